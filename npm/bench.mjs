// Planning time of the package against that of the command's server, as both measure it themselves:
//
//     waybreaker serve --maps FOLDER --port 8081 & node bench.mjs http://localhost:8081 FOLDER/MAP.map...
//
// Draws missions with up to three removals on each MovingAI map (always the same), plans each by both in turn, five times, and
// takes the least time of each: both have a planner that is warm.
import { readFileSync, statSync } from "node:fs";
import { basename } from "node:path";
import { gzipSync } from "node:zlib";
import { createPlanner } from "waybreaker";
import { random } from "./tests/missions.mjs";

const [server, ...files] = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node bench.mjs URL MAP.map...; waybreaker serve --maps FOLDER answers at URL");
  process.exit(2);
}

const missionsPerMap = 6;
const rounds = 5;
const wasm = new URL("dist/waybreaker.wasm", import.meta.url);
console.log(`waybreaker.wasm: ${statSync(wasm).size} bytes, ${gzipSync(readFileSync(wasm)).length} by gzip`);

const wb = await createPlanner();
const ratios = [];
let [allOurs, allTheirs] = [0, 0];
for (const file of files) {
  const map = wb.mapFromMovingAI(readFileSync(file), { name: basename(file) });
  const labels = map.labels();
  const { below, one } = random(labels.length);
  const free = () => {
    for (;;) {
      const [x, y] = [below(map.width), below(map.height)];
      if (labels[y * map.width + x] === 0) return [x, y];
    }
  };
  for (let i = 0; i < missionsPerMap; ++i) {
    const [start, goal, removals] = [free(), free(), one([1, 2, 3])];
    const agents = ["ground", "air"].map((kind) => ({ id: kind, kind, start, goal }));
    const mission = { format: "waybreaker-mission/1", agents, rules: { removals }, limits: { seconds: 60 } };
    let [ours, theirs] = [Infinity, Infinity];
    try {
      for (let round = 0; round < rounds; ++round) {
        const { seconds, after } = wb.plan(map, mission, { timing: true });
        const answer = await fetch(`${server}/api/v1/maps/${basename(file)}/plan`, {
          method: "POST",
          headers: { "content-type": "application/json" },
          body: JSON.stringify(mission),
        });
        const native = await answer.json();
        if (!answer.ok) throw new Error(`${file}: ${JSON.stringify(native)}`);
        if (native.after.makespan !== after.makespan) throw new Error(`${file}: the plans differ`);
        ours = Math.min(ours, seconds.total);
        theirs = Math.min(theirs, native.seconds.total);
      }
    } catch (error) {
      if (error.name !== "InputError") throw error;
      continue; // a start without room
    }
    ratios.push(ours / theirs);
    allOurs += ours;
    allTheirs += theirs;
  }
  map.free();
}
ratios.sort((a, b) => a - b);
const at = (share) => ratios[Math.floor(share * (ratios.length - 1))].toFixed(2);
console.log(`${ratios.length} missions: ${((1e3 * allOurs) / ratios.length).toFixed(1)} ms against ${((1e3 * allTheirs) / ratios.length).toFixed(1)} ms`);
console.log(`ratio: ${(allOurs / allTheirs).toFixed(2)} of the sums; median ${at(0.5)}, ${at(0.1)} to ${at(0.9)} from the 10th to the 90th percentile`);
