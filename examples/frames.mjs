// A game level in which a wall falls or is built in every frame, and the plan changes with it: how long a frame takes.
// Times go to the standard error output.
//
//     npm install waybreaker && node frames.mjs
import { createPlanner } from "waybreaker";

const side = 128;
const room = 16; // with its walls
const frames = 1000;

// The cells of each piece of wall between two pillars; many have a door. The game knows a piece by its number, from 1.
const pieces = [[]];
function piece(cellAt) {
  const hasDoor = (pieces.length * 37) % 10 < 6;
  pieces.push([...Array(room).keys()].filter((i) => i > 0 && (!hasDoor || i < 7 || i > 9)).map(cellAt));
}
for (let at = room; at < side; at += room) {
  for (let from = 0; from < side; from += room) {
    piece((i) => at * side + from + i); // across
    piece((i) => (from + i) * side + at); // down
  }
}

// Numbers of walls, which stay; the map's own ids are given anew in each frame.
const labels = new Uint32Array(side * side);
const stands = pieces.map(() => false);
function turn(number) {
  stands[number] = !stands[number];
  for (const cell of pieces[number]) labels[cell] = stands[number] ? number : 0;
}
for (let number = 1; number < pieces.length; ++number) turn(number);
const attributes = pieces.map((_, sourceId) => ({ sourceId }));

const wb = await createPlanner();
const mission = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "rover", kind: "ground", start: [8, 8], goal: [120, 120] },
    { id: "drone", kind: "air", start: [8, 8], goal: [120, 120], speed: 2 },
  ],
  rules: { removals: 1, breach_time: 4 },
  // A limit in expansions, unlike one in seconds, gives the same plan on every machine.
  limits: { seconds: null, expansions: 2000 },
};

const times = [];
let seed = 7;
let breached = 0;
for (let frame = 0; frame < frames; ++frame) {
  seed = (seed * 48271) % 2147483647;
  const start = performance.now();
  turn(1 + (seed % (pieces.length - 1)));
  const map = wb.mapFromLabels(side, side, labels, { attributes });
  const plan = wb.plan(map, mission);
  map.free();
  times.push(performance.now() - start);

  breached += plan.removed.length;
  if (frame % 200 !== 0) continue;
  const through = plan.removed.map((breach) => `, through wall ${breach.source_id}`).join("");
  const there = plan.after.ground_makespan?.toFixed(3);
  console.log(`frame ${frame}: ${stands.filter(Boolean).length} walls stand; there at ${there}${through}`);
}
console.log(`${breached} walls to breach in ${frames} plans`);
times.sort((a, b) => a - b);
const [median, most, worst] = [frames / 2, frames * 0.99, frames - 1].map((i) => times[i].toFixed(2));
console.error(`milliseconds a frame: median ${median}, 99 of 100 within ${most}, worst ${worst}`);
