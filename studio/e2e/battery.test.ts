// An aircraft that has to come home: set by the keyboard, planned as by the command, kept in the link and the file,
// explained.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { AgentDocument } from "../src/domain/agent_document";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, type StudioPage } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const query = "?map=berlin-adlershof.tif&start=130,104&goal=466,105&air_goal=130,104&air_speed=3&removals=3";
const setting = new Setting("battery");
const cell = 2.4; // metres

const airOf = async (studio: StudioPage) => ((await studio.plan()).mission!.agents as AgentDocument[])[1]!;

// Without the mouse: the folds open by Enter.
async function openBattery({ page }: StudioPage): Promise<void> {
  await page.locator("summary", { hasText: "Mission settings" }).focus();
  await page.keyboard.press("Enter");
  await page.locator("summary", { hasText: "Aircraft’s battery" }).focus();
  await page.keyboard.press("Enter");
}

it("has a range, and is planned, explained and kept with it", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  const [far] = await studio.figures();
  await openBattery(studio);
  await page.getByLabel("Range").focus();
  await page.keyboard.type("1000");
  await page.getByLabel("Kept in reserve").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.type("20");
  await page.keyboard.press("Tab");
  await expect.poll(async () => (await airOf(studio)).reserve).toBeCloseTo(0.2);
  expect((await airOf(studio)).range).toBeCloseTo(1000 / cell);
  await studio.settled();
  expect((await studio.figures())[0]).toBeGreaterThan(far!);
  const result = studio.result();
  await result.getByText("The aircraft lands with 225 m of 1000 m left; 20 % are to be in reserve.").first().waitFor();
  await result.getByText("Out of range: the aircraft can fly 800 m with 20 % in reserve.").first().waitFor();
  await result.getByText("there and back is 880 m").first().waitFor();
  await page.getByRole("button", { name: "Rehearse this plan" }).waitFor();
  await result.getByRole("button", { name: /607/ }).click();
  await page.getByRole("complementary").getByText("Out of range: the aircraft can fly 800 m with 20 % in reserve; there and back is 880 m.").waitFor();
  expect(await studio.accessibilityFaults()).toEqual([]);

  const plan = join(setting.scratch, "plan.json");
  writeFileSync(plan, JSON.stringify(await studio.plan()));
  expect(execFileSync(command, ["check", city, plan], { encoding: "utf8" })).toContain("valid");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const saved = join(setting.scratch, "mission.json");
  await (await download).saveAs(saved);
  const { agents } = JSON.parse(readFileSync(saved, "utf8")) as { agents: AgentDocument[] };
  expect(agents[1]).toMatchObject({ range: 1000 / cell, reserve: 0.2 });
  const same = JSON.parse(execFileSync(command, ["plan", city, "--mission", saved, "--json", "-"], { encoding: "utf8" })) as Plan;
  expect(same.after.makespan).toBe((await studio.figures())[0]);

  const again = await setting.settled({}, page.url());
  expect(await airOf(again)).toMatchObject({ range: 1000 / cell, reserve: 0.2 });
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await airOf(studio)).reserve).toBeUndefined();
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await airOf(studio)).range).toBeUndefined();
  await page.getByRole("button", { name: "Rehearse this plan" }).waitFor();
  await page.getByLabel("File to open").setInputFiles(saved);
  await expect.poll(async () => (await airOf(studio)).reserve).toBe(0.2);
  expect(await page.getByText(/Left out/).count()).toBe(0);
  expect([...studio.faults, ...again.faults]).toEqual([]);
});

it("says so where it is too far from the start to the goal, in metres, and takes no range that is none", async () => {
  const studio = await setting.settled({ query: query.replace("&air_goal=130,104", "") });
  const { page } = studio;
  await openBattery(studio);
  await page.getByLabel("Range").fill("500");
  await page.getByText("The aircraft can fly 500 m; from its start to its goal it is 806 m.").waitFor();
  await page.getByLabel("Range").fill("0");
  await page.getByText("Give 1 to 1000000 m, or nothing. Until then it stays 500.").waitFor();
  await page.getByLabel("Range").fill("");
  await page.getByLabel("Endurance").fill("1,5");
  await page.getByText("The aircraft can fly for 1 min 30 s; from its start to its goal it takes 4 min 29 s.").waitFor();
  await page.getByLabel("Endurance").fill("");
  await studio.settled();
});

it("each of a team has its own, on a phone as well", async () => {
  const studio = await setting.settled({ query, viewport: phone });
  const { page } = studio;
  await page.getByRole("button", { name: "Add aircraft" }).click();
  const table = page.getByRole("table", { name: /^When each agent arrives/ });
  await table.getByText("Battery: no limit").click();
  await table.getByLabel("Range").fill("900");
  await expect.poll(async () => ((await studio.plan()).mission!.agents as AgentDocument[])[2]!.range).toBeCloseTo(900 / cell);
  await studio.settled();
  await table.getByText(/lands with \d+\sm of 900\sm left/).waitFor();
  await expect.poll(() => page.url()).toContain("aircraft=");
  expect(await studio.cutOff(".panel *")).toEqual([]);
  expect(studio.faults).toEqual([]);
});
