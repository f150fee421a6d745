// A plan that meets the field: a breach fails, and the rest of the mission is planned anew.
import { createPlanner } from "waybreaker";

const rounded = (number) => +number.toPrecision(6);
const show = ({ after, removed }) => console.log(`there at ${rounded(after.ground_makespan)}, breaks ${removed.length}`);

const rows = [
  "....@....",
  "....@....",
  "....@....",
  ".........",
];
const wb = await createPlanner();
const map = wb.mapFromGrid(9, 4, Uint8Array.from(rows.join(""), (cell) => (cell === "@" ? 1 : 0)));
const plan = wb.plan(map, {
  format: "waybreaker-mission/1",
  agents: [
    { id: "rover", kind: "ground", start: [0, 1], goal: [8, 1] },
    { id: "drone", kind: "air", start: [0, 1], goal: [0, 1] },
  ],
  rules: { removals: 1, breach_time: 1 },
});
show(plan);

const { obstacle, cleared_at } = plan.removed[0];
const state = { format: "waybreaker-state/1", sequence: 1, now: cleared_at, failed: [{ obstacle, at: cleared_at }] };
const next = wb.revise(map, plan, state);
console.log(`at ${rounded(state.now)} the breach of wall ${obstacle} has failed: ${next.revision.status}`);
show(next);
for (const { message } of wb.check(map, next, { after: plan, state }).violations) console.log(message);
