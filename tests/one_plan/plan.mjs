// usage: plan.mjs MAP MISSION: the plan file, by the npm package.
import { readFileSync } from "node:fs";
import { createPlanner } from "waybreaker";

const [map, mission] = process.argv.slice(2);
const wb = await createPlanner();
const city = wb.mapFromMovingAI(readFileSync(map), { name: map });
process.stdout.write(wb.planText(city, JSON.parse(readFileSync(mission, "utf8"))));
