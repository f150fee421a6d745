// Maps and missions that are drawn anew from a seed.

/** Numbers from 0 to 1, the same for the same seed. */
export function random(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let x = Math.imul(state ^ (state >>> 15), state | 1);
    x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
    return ((x ^ (x >>> 14)) >>> 0) / 2 ** 32;
  };
  const below = (n) => Math.floor(next() * n);
  return { next, below, one: (list) => list[below(list.length)] };
}

/** Walls of random length and direction. */
export function drawnGrid({ below, next }, width, height, density = 0.25) {
  const blocked = new Uint8Array(width * height);
  for (let cells = 0; cells < density * width * height; ) {
    const [x, y, length, across] = [below(width), below(height), 1 + below(12), next() < 0.5];
    for (let i = 0; i < length; ++i, ++cells) {
      const [cx, cy] = across ? [x + i, y] : [x, y + i];
      if (cx < width && cy < height) blocked[cy * width + cx] = 1;
    }
  }
  return blocked;
}

export function movingAI(width, height, blocked) {
  const rows = Array.from({ length: height }, (_, y) =>
    Array.from(blocked.subarray(y * width, (y + 1) * width), (cell) => (cell ? "@" : ".")).join(""),
  );
  return `type octile\nheight ${height}\nwidth ${width}\nmap\n${rows.join("\n")}\n`;
}

function freeCell({ below }, width, height, blocked) {
  for (;;) {
    const at = below(width * height);
    if (!blocked[at]) return [at % width, Math.floor(at / width)];
  }
}

/** Pairs and teams, by every kind of method. */
export function drawnMission(from, width, height, blocked) {
  const cell = () => freeCell(from, width, height, blocked);
  const limits = { seconds: null };
  const ground = (id) => ({ id, kind: "ground", start: cell(), goal: cell() });
  if (from.next() < 0.3) {
    const agents = [ground("a"), ground("b"), { id: "heli", kind: "air", start: cell(), goal: cell(), breaches: 2 }];
    const ends = new Set(agents.slice(0, 2).flatMap(({ start, goal }) => [`${start}`, `${goal}`]));
    if (ends.size < 4) return drawnMission(from, width, height, blocked);
    return { format: "waybreaker-mission/1", agents, rules: { removals: 2 }, limits };
  }
  const body = from.one([{}, {}, { radius: 0 }, { radius: 0.8 }, { corners: "cut" }]);
  return {
    format: "waybreaker-mission/1",
    agents: [
      { ...ground("rover"), speed: from.one([1, 0.7]), ...body },
      { id: "drone", kind: "air", start: cell(), goal: cell(), speed: from.one([1, 2.5]) },
    ],
    rules: {
      removals: from.below(4),
      breach_time: from.one([0, 0, 3]),
      objective: from.one(["makespan", "flowtime", "ground-makespan"]),
    },
    method: { ...from.one([{}, {}, { select: "greedy" }]), explain: from.next() < 0.3 },
    limits,
  };
}
