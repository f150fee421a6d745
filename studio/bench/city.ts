// A made-up city of 4096² cells and about nine thousand buildings, with streets and a mission across it: as large as
// maps of the studio get.
import { type Aircraft, looksOf, type MissionAgent, pair, type Vehicle } from "../src/domain/agents";
import { CellMap } from "../src/domain/cell_map";
import type { Feature, Obstacle } from "../src/domain/map";
import type { Agent, Plan, TimedPoint } from "../src/domain/plan";
import type { Scene } from "../src/domain/scene";

const side = 4096;
const block = 128; // cells from street to street
const lots = 3; // buildings along a side of a block

export function city(): Scene {
  let state = 1;
  const draw = (): number => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const labels = new Uint16Array(side * side);
  const obstacles: Obstacle[] = [];
  const lot = Math.floor((block - 14) / lots);
  for (let y = 0; y + block <= side; y += block) {
    for (let x = 0; x + block <= side; x += block) {
      for (let k = 0; k < lots * lots; ++k) {
        const left = x + 7 + (k % lots) * lot;
        const top = y + 7 + Math.floor(k / lots) * lot;
        obstacles.push(build(labels, obstacles.length + 1, left, top, lot, draw));
      }
    }
  }
  const runs: number[] = [];
  for (const label of labels) {
    if (runs.at(-2) === label) runs[runs.length - 1]! += 1;
    else runs.push(label, 1);
  }
  const cells = new CellMap({ width: side, height: side, obstacles, runs });
  const before = plan([]);
  const after = plan(obstacles.filter((_, i) => i % 1031 === 7));
  return {
    map: {
      id: "city",
      source: "city",
      format: "",
      width: side,
      height: side,
      cell_size: 1,
      blocked: 0,
      density: 0,
      obstacles: { count: obstacles.length, largest: null },
      georeference: null,
      start: null,
      goal: null,
      title: "city",
      attribution: "",
      notes: [],
      digest: "",
    },
    cells,
    background: { features: streets() },
    agents: pair([66, 4030], [4030, 66]),
    looks: new Map(),
    chosen: null,
    layers: [
      { name: "before", plan: before },
      { name: "after", plan: after },
    ],
    marks: new Map([
      [70, "protect"],
      [700, "exclude"],
    ]),
    ruled: new Map(),
    highlighted: 4000,
    selected: 4100,
    time: null,
    old: false,
    zones: [],
    pointedZone: null,
    tool: "move",
    followed: null,
    editable: true,
    formatTime: (time) => `${time.toFixed(0)} s`,
  };
}

// The same with so many vehicles and three aircraft, each on a winding way of 200 turns.
export function withTeam(scene: Scene, vehicles: number): Scene {
  const [vehicle, craft] = scene.agents;
  const ids = [...Array.from({ length: vehicles }, (_, i) => String(i + 1)), "air1", "air2", "air3"];
  const agents = ids.map((id, i): MissionAgent => {
    const end = (k: number): [number, number] => [66 + ((k * 977) % 3900), 66 + ((k * 1637) % 3900)];
    return i < vehicles
      ? { ...(vehicle as Vehicle), id, start: end(2 * i), goal: end(2 * i + 1) }
      : { ...(craft as Aircraft), id, start: end(2 * i), goal: end(2 * i + 1) };
  });
  const plan = { ...scene.layers.at(-1)!.plan };
  plan.agents = agents.map(({ id, kind, start, goal }, i): Agent => {
    const [[ax, ay], [bx, by]] = [start!, goal!];
    const path = Array.from({ length: 200 }, (_, k): TimedPoint => {
      const share = k / 199;
      const away = 40 * Math.sin(20 * share + i);
      return [ax + share * (bx - ax) + away, ay + share * (by - ay) + away, 6000 * share];
    });
    return { id, kind, speed: 1, start: start!, goal: goal!, path };
  });
  return { ...scene, agents, looks: looksOf(agents), layers: [{ name: "after", plan }] };
}

// A building with ragged walls around a yard, wall to wall with its neighbours or not.
function build(
  labels: Uint16Array,
  id: number,
  left: number,
  top: number,
  size: number,
  draw: () => number,
): Obstacle {
  const inset = Math.floor(3 * draw());
  const yard = size * (0.25 + 0.1 * draw());
  let cells = 0;
  for (let y = inset; y < size - inset; ++y) {
    const ragged = inset + Math.floor(2 * draw());
    for (let x = ragged; x < size - inset; ++x) {
      if (Math.abs(x - size / 2) + Math.abs(y - size / 2) < yard) continue;
      labels[(top + y) * side + left + x] = id;
      ++cells;
    }
  }
  const bounds: Obstacle["bounds"] = [left, top, left + size - 1, top + size - 1];
  return { id, source_id: 0, name: id % 9 === 0 ? `House ${id}` : "", cells, bounds, destructible: id % 13 !== 0, weight: 1, breach_time: 0 };
}

function streets(): Feature[] {
  const features: Feature[] = [];
  for (let i = 0; i <= side / block; ++i) {
    const street = i % 8 === 0 ? "primary" : i % 4 === 0 ? "secondary" : "residential";
    for (let k = 0; k < side / block; ++k) {
      const [from, to] = [k * block, (k + 1) * block];
      features.push(line(street, `Avenue ${i}`, [i * block, from], [i * block, to]));
      features.push(line(street, `Street ${i}`, [from, i * block], [to, i * block]));
      features.push(line("footway", "", [from + 40, i * block], [to, (i + 1) * block - 40]));
    }
  }
  return features;
}

function line(street: string, name: string, from: [number, number], to: [number, number]): Feature {
  return { kind: "street", class: street, name, shape: "line", points: [[from, to]] };
}

function plan(removed: Obstacle[]): Plan {
  const agent = (kind: Agent["kind"], bend: number): Agent => {
    const path = Array.from({ length: 400 }, (_, i): TimedPoint => {
      const t = i / 399;
      const away = bend * Math.sin(9 * t);
      return [66 + 3964 * t + away, 4030 - 3964 * t + away, 6000 * t];
    });
    path.splice(200, 0, [path[200]![0], path[200]![1], path[200]![2] - 10]);
    return { id: kind, kind, speed: 1, start: [66, 4030], goal: [4030, 66], path };
  };
  return {
    agents: [agent("ground", 200), agent("air", 50)],
    removed: removed.map(({ id, cells, bounds }, i) => ({
      obstacle: id,
      cells,
      hits: 0,
      at: [bounds[0], bounds[1]],
      cleared_at: 500 * (i + 1),
      entered_at: 500 * (i + 1) + 40,
    })),
  } as unknown as Plan;
}
