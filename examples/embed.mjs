// waybreaker in JavaScript: make a map, plan a mission, print which wall to break and the way through.
import { createPlanner } from "waybreaker";

const [width, height] = [40, 20];
const walls = new Uint8Array(width * height); // every cell free
for (let y = 0; y < 18; ++y) walls[y * width + 20] = 1;

const wb = await createPlanner();
const start = [4, 4];
const goal = [36, 4];
const plan = wb.plan(wb.mapFromGrid(width, height, walls), {
  format: "waybreaker-mission/1",
  agents: [
    { id: "ground", kind: "ground", start, goal },
    { id: "air", kind: "air", start, goal },
  ],
  rules: { removals: 1 },
});

for (const { obstacle, at } of plan.removed) console.log(`break wall ${obstacle} from (${at.join(", ")})`);
console.log("drive", ...plan.agents[0].path.map(([x, y]) => `(${x}, ${y})`));
console.log(`${+plan.before.makespan.toPrecision(6)} cells before, ${plan.after.makespan} after`);
