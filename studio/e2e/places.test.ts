// Many places: vehicles that pass through each other, those that are not reached, and what each counts.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { AgentDocument } from "../src/domain/agent_document";
import type { Cell } from "../src/domain/geometry";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, type StudioPage } from "./studio_page";

const city = join(data, "berlin-mitte.tif");
const query = "?map=berlin-mitte.tif";
const setting = new Setting("places");
const hospital: Cell = [100, 55];
const place = (id: string, goal: Cell, weight: number, speed = 1) => ({ id, kind: "ground", start: hospital, goal, weight, speed });
const mission = {
  format: "waybreaker-mission/1",
  time_unit: "s",
  agents: [
    place("school", [481, 440], 180),
    place("mill", [348, 47], 40),
    place("yard", [301, 119], 80, 0.3),
    { id: "air", kind: "air", start: hospital, goal: hospital, weight: 0 },
  ],
  rules: { removals: 1, objective: "flowtime", collisions: false, unreached: 620 },
};

function planned(file: string): Plan {
  return JSON.parse(execFileSync(command, ["plan", city, "--mission", file, "--json", "-"], { encoding: "utf8" })) as Plan;
}

async function saved({ page }: StudioPage, name: string): Promise<string> {
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const file = join(setting.scratch, name);
  await (await download).saveAs(file);
  return file;
}

it("opens with its rules, is planned as by the command, and says which places are reached", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  const file = join(setting.scratch, "places.json");
  writeFileSync(file, JSON.stringify(mission));
  await page.getByLabel("File to open").setInputFiles(file);
  await studio.result().getByText("2 of 3 places are reached, 1 only now. Not reached: yard.").first().waitFor();
  await studio.settled();
  expect(await page.getByText(/Left out/).count()).toBe(0);
  const [shown, wanted] = [await studio.plan(), planned(file)];
  expect(shown.after.flowtime).toBe(wanted.after.flowtime);
  expect(shown.removed.map(({ obstacle }) => obstacle)).toEqual(wanted.removed.map(({ obstacle }) => obstacle));
  const plan = join(setting.scratch, "plan.json");
  writeFileSync(plan, JSON.stringify(shown));
  expect(execFileSync(command, ["check", city, plan], { encoding: "utf8" })).toContain("valid");
  const average = await studio.result().locator(".figure").textContent();
  expect(average).toBe(`${Math.floor(shown.after.flowtime! / 300 / 60)}\u00a0min ${Math.round((shown.after.flowtime! / 300) % 60)}\u00a0s`);

  const table = page.getByRole("table", { name: /^When each agent arrives/ });
  await table.getByRole("row", { name: /yard not reached/ }).waitFor();
  await table.getByRole("row", { name: /school .*only now/ }).waitFor();
  await page.locator("summary", { hasText: "Mission settings" }).click();
  const passes = page.getByLabel("Vehicles pass through each other");
  expect(await passes.isChecked()).toBe(true);
  expect(await page.getByLabel("A place not reached counts as").inputValue()).toBe("620");
  expect(await studio.accessibilityFaults()).toEqual([]);

  const again = await setting.settled({}, page.url());
  expect((await again.plan()).after.flowtime).toBe(wanted.after.flowtime);
  const { agents, rules } = JSON.parse(readFileSync(await saved(again, "again.json"), "utf8")) as typeof mission;
  expect(rules).toMatchObject(mission.rules);
  expect(agents.map(({ weight }) => weight)).toEqual([180, 40, 80, 0]);

  await passes.focus();
  await page.keyboard.press("Space");
  await page.getByRole("heading", { name: "This mission cannot be planned" }).waitFor(); // all start at one place
  expect(await page.getByText("is being worked out").count()).toBe(0);
  await page.keyboard.press("Control+z");
  await studio.result().getByText("2 of 3 places are reached, 1 only now. Not reached: yard.").first().waitFor();
  await page.getByLabel("A place not reached counts as").fill("");
  await studio.result().getByText("All 3 places are reached").first().waitFor();
  await table.getByRole("button", { name: "mill", exact: true }).click();
  await table.getByLabel("Weight in the sum").fill("0");
  const weights = async () => ((await studio.plan()).mission!.agents as AgentDocument[]).map(({ weight }) => weight);
  await expect.poll(weights).toEqual([180, 0, 80, 0]);
  expect([...studio.faults, ...again.faults]).toEqual([]);
});

it("says of a rehearsal what it does to the average, and who is no longer reached", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  const file = join(setting.scratch, "rehearsed.json");
  writeFileSync(file, JSON.stringify(mission));
  await page.getByLabel("File to open").setInputFiles(file);
  await studio.result().getByText("2 of 3 places are reached, 1 only now. Not reached: yard.").first().waitFor();
  await studio.settled();
  await page.getByRole("button", { name: "Rehearse this plan" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("button", { name: "Breach fails" }).first().click();
  const told = /^The breach of .+ failed at .+: the weighted average arrival is .+ later, at .+; school is no longer reached\.$/;
  await studio.result().getByRole("heading", { name: told }).waitFor();
  await page.locator('.rehearsal[aria-busy="false"]').getByText("Checked independently").waitFor();
  expect(await studio.accessibilityFaults()).toEqual([]);
  await page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "places-rehearsed.png") });
  await page.getByRole("button", { name: "Back to the plan" }).click();
  await studio.result().getByText("2 of 3 places are reached").first().waitFor();
  expect(studio.faults).toEqual([]);
});

it("shows thirty places, on a phone as well", async () => {
  const file = join(setting.scratch, "access.json");
  const [from, to] = ["hospital", "places"].map((what) => join(data, `berlin-mitte-${what}.geojson`));
  execFileSync(command, ["missions", "access", city, "--from", from!, "--to", to!, "-o", file]);
  const studio = await setting.settled({ query, viewport: phone });
  const { page } = studio;
  await page.getByLabel("File to open").setInputFiles(file);
  await studio.result().getByText(/All 30 places are reached/).first().waitFor();
  expect(await page.getByText(/Left out/).count()).toBe(0);
  expect(await page.getByRole("table", { name: /^When each agent arrives/ }).locator("tbody tr").count()).toBe(31);
  await expect.poll(() => page.url()).toContain("#z=");
  await studio.marker("Goal of place 13").focus();
  const stood = await studio.cellOf("Goal of place 13");
  for (let i = 0; i < 5; ++i) await page.keyboard.press("Shift+ArrowDown"); // drafts have little time for so many
  await studio.settled();
  expect(await studio.cellOf("Goal of place 13")).not.toEqual(stood);
  await studio.result().getByText(/All 30 places are reached/).first().waitFor();
  await page.getByRole("button", { name: "place 30", exact: true }).click();
  expect(await page.getByLabel("Weight in the sum").inputValue()).toBe("110");
  expect(await studio.cutOff(".panel *")).toEqual([]);
  expect(studio.faults).toEqual([]);
});
