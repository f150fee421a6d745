// A level of 128 x 128 cells where a wall falls in every frame, and the rover's plan changes with it:
//
//     npm install waybreaker && node walls_fall.mjs
import { createPlanner } from "waybreaker";

const side = 128;
const room = 16; // with its walls
const frames = 10;

// The level: each piece of wall between two pillars has a number of its own, by which the game knows it for good. Many
// pieces have a door.
const walls = new Uint32Array(side * side);
let pieces = 0;
function build(cellAt) {
  const hasDoor = (++pieces * 37) % 10 < 6;
  for (let i = 1; i < room; ++i) if (!hasDoor || i < 7 || i > 9) walls[cellAt(i)] = pieces;
}
for (let at = room; at < side; at += room) {
  for (let from = 0; from < side; from += room) {
    build((i) => at * side + from + i); // across
    build((i) => (from + i) * side + at); // down
  }
}

const wb = await createPlanner();
const attributes = Array.from({ length: pieces + 1 }, (_, sourceId) => ({ sourceId }));
// A limit in expansions, unlike one in seconds, gives the same plan on every machine.
const mission = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "rover", kind: "ground", start: [8, 8], goal: [120, 120] },
    { id: "drone", kind: "air", start: [8, 8], goal: [120, 120], speed: 2 },
  ],
  rules: { removals: 3, breach_time: 4 },
  method: { select: "greedy" },
  limits: { seconds: null, expansions: 2000 },
};

let seed = 7;
const standing = () => [...new Set(walls)].filter((wall) => wall !== 0);

for (let frame = 0; frame < frames; ++frame) {
  const map = wb.mapFromLabels(side, side, walls, { attributes });
  const plan = wb.plan(map, mission);
  map.free();
  const removed = plan.removed.map((breach) => breach.source_id);
  console.log(`frame ${frame}: break ${removed.join(", ") || "nothing"}, arrive at ${plan.after.makespan?.toFixed(1)}`);

  seed = (seed * 1103515245 + 12345) % 2 ** 31; // some other wall falls
  const left = standing();
  const falls = left[seed % left.length];
  for (let i = 0; i < walls.length; ++i) if (walls[i] === falls) walls[i] = 0;
}
