// Rubble: set by the keyboard, planned as by the command, kept in the link and the file.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { command, data } from "./command";
import { Setting } from "./setting";

const city = join(data, "krems.tif");
const setting = new Setting("rubble");

it("slows the robot, is planned with and kept", async () => {
  const studio = await setting.settled({ query: "?map=krems.tif&start=487,5&goal=450,240&removals=3" });
  const { page } = studio;
  const [cleared] = await studio.figures();
  await page.locator("summary", { hasText: "Mission settings" }).focus();
  await page.keyboard.press("Enter");
  await page.getByLabel("Rubble delay").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("20");
  await page.keyboard.press("Tab");
  await expect.poll(async () => (await studio.plan()).options.rubble).toBe(20);
  await studio.settled();
  expect((await studio.figures())[0]).toBeGreaterThan(cleared!);
  const plan = await studio.plan();
  const waits = plan.agents.flatMap((agent) => agent.waits ?? []);
  expect(waits.map(({ reason }) => reason)).toContain("rubble");
  expect(page.url()).toContain("rubble=20");
  expect(await studio.accessibilityFaults()).toEqual([]);

  const file = join(setting.scratch, "plan.json");
  writeFileSync(file, JSON.stringify(plan));
  expect(execFileSync(command, ["check", city, file], { encoding: "utf8" })).toContain("valid");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const saved = join(setting.scratch, "mission.json");
  await (await download).saveAs(saved);
  expect((JSON.parse(readFileSync(saved, "utf8")) as { rules: object }).rules).toMatchObject({ rubble: 20 });
});
