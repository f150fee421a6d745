// Missions that protect by tag or name: opened, changed and saved, they keep the rule and give the command's plan.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { Setting } from "./setting";

const city = join(data, "berlin-adlershof.tif");
const setting = new Setting("rule");
const { scratch } = setting;
const mission = {
  format: "waybreaker-mission/1",
  time_unit: "s",
  agents: [
    { id: "ground", kind: "ground", start: [130, 104], goal: [466, 105] },
    { id: "air", kind: "air", start: [130, 104], goal: [130, 104] },
  ],
  rules: { removals: 2, protect: [17, "barrier=fence"] },
};

function planOfCommand(file: string): Plan {
  const json = join(scratch, "plan.json");
  execFileSync(command, ["plan", city, "--mission", file, "--json", json], { stdio: "ignore" });
  return JSON.parse(readFileSync(json, "utf8")) as Plan;
}

const essence = ({ after, removed, options }: Plan) => ({
  makespan: after.makespan,
  removed: removed.map(({ obstacle }) => obstacle).sort((a, b) => a - b),
  protect: options.protect,
});

it("keeps a rule of a mission file, and plans as the command does", async () => {
  const file = join(scratch, "mission.json");
  writeFileSync(file, JSON.stringify(mission));
  const expected = planOfCommand(file);
  expect(expected.options.protect!.length).toBeGreaterThan(100);

  const studio = await setting.visit();
  await studio.settled();
  await studio.page.getByLabel("File to open").setInputFiles(file);
  const choice = studio.page.getByText(/^Protected: all barrier=fence, \d+ obstacles$/);
  await choice.waitFor();
  await expect.poll(async () => essence(await studio.plan())).toEqual(essence(expected));
  await studio.settled();
  expect(await studio.page.getByRole("status").getByText(/Left out/).count()).toBe(0);

  await studio.page.getByRole("slider", { name: "Removals" }).fill("1");
  await studio.settled();
  const download = studio.page.waitForEvent("download");
  await studio.page.getByRole("button", { name: "Mission", exact: true }).click();
  const saved = join(scratch, "saved.json");
  await (await download).saveAs(saved);
  const document = JSON.parse(readFileSync(saved, "utf8")) as typeof mission;
  expect(document.rules).toMatchObject({ removals: 1, protect: [17, "barrier=fence"] });
  // As good: where the curve has it already, the page does not ask again, and the last answer may be for more removals.
  const { after } = planOfCommand(saved);
  await expect.poll(async () => (await studio.plan()).after.makespan).toBe(after.makespan);

  await studio.page.getByRole("button", { name: /^Take back: Protected: all barrier=fence/ }).click();
  await expect.poll(async () => (await studio.plan()).options.protect).toEqual([17]);
  expect(await studio.accessibilityFaults()).toEqual([]);
  expect(studio.faults).toEqual([]);
  await studio.close();
});

it("keeps a limit that it has no control for, plans as the command does, and drops it when told to", async () => {
  const file = join(scratch, "budget.json");
  const [start, goal] = [[130, 104], [466, 105]];
  const agents = [{ id: "ground", kind: "ground", start, goal, ready_at: 5 }, { id: "air", kind: "air", start, goal }];
  writeFileSync(file, JSON.stringify({ format: "waybreaker-mission/1", agents, rules: { removals: 2, budget_m2: 100 } }));
  const studio = await setting.visit();
  const { page } = studio;
  await studio.settled();
  await page.getByLabel("File to open").setInputFiles(file);
  const choice = page.getByText("Also asked: budget 100\u00a0m²", { exact: true });
  await choice.waitFor();
  await studio.settled();
  const { options, demolition, mission } = await studio.plan();
  expect(options.budget_m2).toBe(100);
  expect(demolition!.area_m2).toBeLessThanOrEqual(100);
  expect(mission!.time_unit).toBe("s");
  expect(mission!.agents[0]).toMatchObject({ id: "ground", ready_at: 12 }); // 5 cells of 2.4 m at 1 m/s
  expect((await studio.figures())[0]).toBeGreaterThan(800); // seconds at 1 m/s, as the command says
  await page.getByRole("button", { name: /^Take back: Also asked/ }).click();
  await choice.waitFor({ state: "detached" });
  await expect.poll(async () => (await studio.plan()).options).not.toHaveProperty("budget_m2");
  await studio.settled();
  await studio.close();
});

it("says so where a rule of the mission means nothing on the map", async () => {
  const file = join(scratch, "zoo.json");
  writeFileSync(file, JSON.stringify({ ...mission, rules: { protect: ["amenity=zoo"] } }));
  const studio = await setting.visit();
  await studio.settled();
  await studio.page.getByLabel("File to open").setInputFiles(file);
  await studio.page.getByText(/Nothing to protect: no obstacle of berlin-adlershof\.tif has the tag 'amenity=zoo'/).first().waitFor();
  await studio.page.getByRole("button", { name: /^Take back: Protected: all amenity=zoo/ }).click();
  await studio.settled();
  expect((await studio.plan()).options.protect).toBeUndefined();
  await studio.close();
});
