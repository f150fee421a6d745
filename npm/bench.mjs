// Planning time of the package against the command's, as both measure it themselves, on MovingAI maps in turn:
//
//     node bench.mjs COMMAND MAP.map...
//
// Draws missions with up to three removals on each map (always the same), plans each by both, in turn, three times, and takes the
// least time of each.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { gzipSync } from "node:zlib";
import { createPlanner } from "waybreaker";
import { random } from "./tests/missions.mjs";

const [command, ...files] = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node bench.mjs COMMAND MAP.map...");
  process.exit(2);
}

const missionsPerMap = 4;
const rounds = 3;
const wasm = new URL("dist/waybreaker.wasm", import.meta.url);
console.log(`waybreaker.wasm: ${statSync(wasm).size} bytes, ${gzipSync(readFileSync(wasm)).length} by gzip`);

const wb = await createPlanner();
const folder = mkdtempSync(join(tmpdir(), "waybreaker-bench-"));
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
    const path = join(folder, "mission.json");
    writeFileSync(path, JSON.stringify(mission));
    let [ours, theirs] = [Infinity, Infinity];
    try {
      for (let round = 0; round < rounds; ++round) {
        const { seconds, after } = wb.plan(map, mission, { timing: true });
        const native = JSON.parse(execFileSync(command, ["plan", file, "--mission", path, "--json", "-"], { stdio: ["ignore", "pipe", "ignore"] }));
        if (native.after.makespan !== after.makespan) throw new Error(`${file}: the plans differ`);
        ours = Math.min(ours, seconds.total);
        theirs = Math.min(theirs, native.seconds.total - native.seconds.label);
      }
    } catch (error) {
      if (error.name !== "InputError" && error.status !== 1) throw error;
      continue; // a start without room, or no way
    }
    ratios.push(ours / theirs);
    allOurs += ours;
    allTheirs += theirs;
  }
  map.free();
}
rmSync(folder, { recursive: true });
ratios.sort((a, b) => a - b);
const at = (share) => ratios[Math.floor(share * (ratios.length - 1))].toFixed(2);
console.log(`${ratios.length} missions: ${((1e3 * allOurs) / ratios.length).toFixed(1)} ms against ${((1e3 * allTheirs) / ratios.length).toFixed(1)} ms`);
console.log(`ratio: ${(allOurs / allTheirs).toFixed(2)} of the sums; median ${at(0.5)}, ${at(0.1)} to ${at(0.9)} from the 10th to the 90th percentile`);
