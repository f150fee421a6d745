// Links and files that bring a mission back, or cannot.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { Run } from "../src/domain/geometry";
import { freshMission } from "../src/domain/mission";
import { missionFile } from "../src/mission/mission_file";
import { union } from "../src/mission/run_set";
import { Setting } from "./setting";

const setting = new Setting("link");
const { scratch } = setting;

it("a link restores the mission", async () => {
  const page = await setting.settled();
  await page.page.getByRole("slider", { name: "Removals" }).focus();
  await page.page.keyboard.press("ArrowRight");
  await page.page.getByRole("button", { name: /^Protect / }).first().click();
  await expect.poll(async () => (await page.plan()).options.protect ?? []).toHaveLength(1);
  await page.settled();
  await expect.poll(() => page.page.url()).toContain("protect=");
  const plan = await page.plan();
  const link = page.page.url();
  await page.close();
  const studio = await setting.settled({}, link);
  const restored = await studio.plan();
  for (const key of ["removals", "protect", "objective"] as const) expect(restored.options[key]).toEqual(plan.options[key]);
  expect(restored.removed.map((one) => one.obstacle)).toEqual(plan.removed.map((one) => one.obstacle));
  expect((await studio.figures())[0]).toBe(plan.after.makespan);
});

it("a link keeps a drawing of many strokes, which a file brings, too", async () => {
  const strokes = Array.from({ length: 32 * 90 }, (_, i): Run => [(i * 7) % 350 + ((i >> 5) % 90), 100 + (i % 300), 3]);
  const mission = freshMission("berlin-mitte.tif", { start: [256, 434], goal: [118, 55] });
  const file = join(scratch, "mission.json");
  writeFileSync(file, missionFile({ ...mission, walls: union(strokes, []) }, { width: 501, cell: 2.4, metric: true }, 3));
  const page = await setting.settled({ query: "#map=berlin-mitte.tif&start=256,434&goal=118,55&removals=1" });
  const { digest } = (await page.plan()).map;
  await page.page.getByLabel("File to open").setInputFiles(file);
  await expect.poll(() => page.page.url()).toContain("#z=");
  await page.page.getByText(/^Drawn: /).waitFor();
  const drawn = await page.page.getByText(/^Drawn: /).innerText();
  const link = page.page.url();
  await page.close();
  const studio = await setting.visit({}, link);
  expect(await studio.page.getByText(/^Drawn: /).innerText()).toBe(drawn);
  await studio.page.goto(`${setting.server.url}/#map=berlin-mitte.tif&start=256,434&goal=118,55&removals=1`); // the same page
  await studio.settled();
  await expect.poll(async () => (await studio.plan()).map.digest).toBe(digest);
});

it("a link and a plan's file bring back its mission", async () => {
  const page = await setting.settled({ query: "#map=berlin-mitte.tif&start=250,430&goal=118,55&removals=3&ground_speed=2" });
  const plan = await page.plan();
  await page.close();
  const file = join(scratch, "plan.json");
  writeFileSync(file, JSON.stringify(plan));
  const other = await setting.settled();
  await other.page.getByLabel("File to open").setInputFiles(file);
  await other.page.getByText("The mission of the plan is planned anew.").waitFor();
  await other.settled();
  const again = await other.plan();
  expect(again.options.objective).toEqual(plan.options.objective);
  expect(again.agents).toEqual(plan.agents);
});

it("a link that is broken says so, and the page works on", async () => {
  const page = await setting.settled({ query: "?map=berlin-mitte.tif&start=9999,4&removals=many" });
  await page.page.getByText(/in the link cannot be read/).waitFor();
});

it("a link to a map that is not there, or cannot be, says so", async () => {
  for (const name of ["atlantis.tif", "../x"]) {
    const studio = await setting.visit({ query: `#map=${name}` });
    await studio.page.getByText(`does not have the map “${name}”`).waitFor();
    await studio.close();
  }
});
