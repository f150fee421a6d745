// waybreaker in JavaScript: draw a map, plan a mission, see which wall to break and the way through.
import { createPlanner } from "waybreaker";

const rows = [
  "....@....",
  "....@....",
  "....@....",
  ".........",
];
const wb = await createPlanner();
const walls = Uint8Array.from(rows.join(""), (cell) => (cell === "@" ? 1 : 0));
const plan = wb.plan(wb.mapFromGrid(9, 4, walls), {
  format: "waybreaker-mission/1",
  agents: [
    { id: "rover", kind: "ground", start: [0, 1], goal: [8, 1], ready_at: 5 },
    { id: "drone", kind: "air", start: [0, 1], goal: [0, 1] },
  ],
  rules: { removals: 1 },
});

for (const { obstacle, at } of plan.removed) console.log(`break wall ${obstacle} from (${at.join(", ")})`);
console.log("drive", ...plan.agents[0].path.map(([x, y]) => `(${x}, ${y})`));
const [before, after] = [plan.before, plan.after].map(({ makespan }) => +makespan.toPrecision(6));
console.log(`${plan.status}: there at ${before} before, at ${after} after`);
