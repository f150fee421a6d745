// What agents open, and how long that takes them: set by the keyboard, planned as by the command, kept in the link and the
// file, told.
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
const query = "?map=berlin-adlershof.tif&start=130,104&goal=466,105&air_speed=3&removals=3";
const setting = new Setting("abilities");
const cell = 2.4; // metres

const agentOf = async (studio: StudioPage, index: number) => ((await studio.plan()).mission!.agents as AgentDocument[])[index]!;
const openedIn = (plan: Plan) => plan.removed.map(({ obstacle }) => obstacle).sort((a, b) => a - b);

async function savedBy({ page }: StudioPage, name: string): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const file = join(setting.scratch, name);
  await (await download).saveAs(file);
  return file;
}

function plannedByCommand(mission: string): Plan {
  const args = ["plan", city, "--mission", mission, "--time-limit", "none", "--json", "-"];
  return JSON.parse(execFileSync(command, args, { encoding: "utf8" })) as Plan;
}

function expectValid(plan: Plan): void {
  const file = join(setting.scratch, "plan.json");
  writeFileSync(file, JSON.stringify(plan));
  expect(execFileSync(command, ["check", city, file], { encoding: "utf8" })).toContain("valid");
}

it("opens what is small enough, in its own time", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  const [any] = await studio.figures();
  const large = (await studio.plan()).removed.find(({ cells }) => cells * cell * cell > 250)!;
  await page.locator("summary", { hasText: "Mission settings" }).focus();
  await page.keyboard.press("Enter");
  await page.locator("summary", { hasText: "What the aircraft opens: anything" }).focus();
  await page.keyboard.press("Enter");
  const fold = page.getByRole("group", { name: "What the aircraft opens", exact: true });
  await fold.getByLabel("Opens up to").focus();
  await page.keyboard.type("250");
  await page.keyboard.press("Tab");
  const can_breach = { most_cells: Math.floor(250 / cell ** 2) };
  await expect.poll(async () => (await agentOf(studio, 1)).can_breach).toEqual(can_breach);
  await studio.settled();
  expect(openedIn(await studio.plan())).not.toContain(large.obstacle);
  const [small] = await studio.figures();
  expect(small).toBeGreaterThan(any!);
  await page.getByLabel("Find a street or obstacle").fill(large.name!);
  await page.getByRole("option", { name: large.name! }).first().click();
  await page.getByRole("complementary").getByText("Too large for all who open the way here.").waitFor();
  await page.getByRole("button", { name: "Close", exact: true }).click();

  expect(await fold.getByLabel("Its own time to open one").getAttribute("placeholder")).toBe("0");
  await fold.getByLabel("Its own time to open one").focus();
  await page.keyboard.type("90");
  await fold.getByLabel("… and for each m²").focus();
  await page.keyboard.type("0,5");
  await page.keyboard.press("Tab");
  await page.getByText("What the aircraft opens: up to 250 m², in its own time").waitFor();
  const own = { can_breach, breach_time: 90, breach_time_per_cell: expect.closeTo(0.5 * cell ** 2) };
  await expect.poll(() => agentOf(studio, 1)).toMatchObject(own);
  await studio.settled();
  const plan = await studio.plan();
  expect(plan.options.breach_time).toBe(0);
  expect(Math.min(...plan.removed.map(({ cleared_at }) => cleared_at))).toBeGreaterThan(90);
  expectValid(plan);
  expect(await studio.accessibilityFaults()).toEqual([]);
  await page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "abilities.png") });

  const saved = await savedBy(studio, "mission.json");
  const { agents } = JSON.parse(readFileSync(saved, "utf8")) as { agents: AgentDocument[] };
  expect(agents[1]).toMatchObject(own);
  expect(plannedByCommand(saved).after.makespan).toBe((await studio.figures())[0]);

  const again = await setting.settled({ viewport: phone }, page.url());
  expect(await agentOf(again, 1)).toMatchObject(own);
  await again.page.locator("summary", { hasText: "Mission settings" }).click();
  expect(await again.page.getByLabel("Opens up to").inputValue()).toBe("250"); // it is open: something is said
  expect(await again.cutOff(".panel *")).toEqual([]);

  await page.keyboard.press("Escape");
  for (let i = 0; i < 2; ++i) await page.keyboard.press("Control+z");
  await expect.poll(async () => (await agentOf(studio, 1)).breach_time).toBeUndefined();
  await studio.settled();
  expect((await studio.figures())[0]).toBe(small);
  await page.getByLabel("File to open").setInputFiles(saved);
  await expect.poll(() => agentOf(studio, 1)).toMatchObject(own);
  expect(await page.getByText(/Left out/).count()).toBe(0);
  expect([...studio.faults, ...again.faults]).toEqual([]);
});

it("a vehicle opens for others what it is told to, from as far as it reaches", async () => {
  const agents = [
    { id: "digger", kind: "ground", start: [130, 104], goal: [466, 105], speed: 1, breaches: 3, breach_time: 20, can_breach: { only: [520, 607] } },
    { id: "truck", kind: "ground", start: [128, 104], goal: [464, 105], speed: 1, ready_at: 60 },
  ];
  const file = join(setting.scratch, "digger.json");
  const rules = { removals: 3, breach_time: 5 };
  writeFileSync(file, JSON.stringify({ format: "waybreaker-mission/1", time_unit: "s", agents, rules }));
  const studio = await setting.settled({ query });
  const { page } = studio;
  await page.getByLabel("File to open").setInputFiles(file);
  await expect.poll(() => agentOf(studio, 0)).toMatchObject({ breach_time: 20, can_breach: { only: [520, 607] } });
  expect(await page.getByText(/Left out/).count()).toBe(0);
  await studio.settled();
  expect([520, 607]).toEqual(expect.arrayContaining(openedIn(await studio.plan())));

  await page.getByRole("button", { name: "digger", exact: true }).click();
  const fold = page.getByRole("group", { name: "What it opens", exact: true });
  await fold.getByText("Only obstacles 520 and 607").waitFor();
  expect(await fold.getByLabel("Its own time to open one").inputValue()).toBe("20");
  expect(await fold.getByLabel("Reach").inputValue()).toBe("2.4");
  await fold.getByLabel("Reach").fill("12");
  await expect.poll(async () => (await agentOf(studio, 0)).reach).toBe(5);
  await studio.settled();
  expectValid(await studio.plan());
  const saved = await savedBy(studio, "digger-saved.json");
  expect(plannedByCommand(saved).after.makespan).toBe((await studio.plan()).after.makespan);
  await fold.getByRole("button", { name: "Let it open others as well" }).click();
  await expect.poll(async () => (await agentOf(studio, 0)).can_breach).toBeUndefined();
  await page.getByLabel("Opens at most").selectOption("0");
  expect(await page.getByText("What it opens").count()).toBe(0);
  expect(studio.faults).toEqual([]);
});
