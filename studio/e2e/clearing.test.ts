// A vehicle that clears for others: set by the keyboard, planned as by the command, kept in the link and the file.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { AgentDocument } from "../src/domain/agent_document";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const setting = new Setting("clearing");

it("clears for the vehicle that joins it, and says who opens what", async () => {
  const studio = await setting.settled({ query: "?map=berlin-adlershof.tif&start=130,104&goal=466,105&removals=2" });
  const { page } = studio;
  await page.getByRole("button", { name: "Robot alone" }).press("Enter");
  await page.getByLabel("Opens in its way").selectOption("2");
  await studio.settled();
  await page.getByRole("button", { name: "Add vehicle" }).press("Enter");
  await studio.settled();
  const table = page.getByRole("table", { name: /^When each agent arrives/ });
  await table.getByRole("row", { name: /opens 1, 2/ }).waitFor();
  expect(await page.getByLabel("Opens at most").inputValue()).toBe("0");
  expect(await page.locator("p.legend").innerText()).not.toContain("aircraft");
  expect(await studio.accessibilityFaults()).toEqual([]);

  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const file = join(setting.scratch, "clearing.json");
  await (await download).saveAs(file);
  const { agents } = JSON.parse(readFileSync(file, "utf8")) as { agents: AgentDocument[] };
  expect(agents.map(({ kind, breaches }) => [kind, breaches])).toEqual([["ground", 2], ["ground", undefined]]);
  const wanted = JSON.parse(execFileSync(command, ["plan", city, "--mission", file, "--time-limit", "none", "--json", "-"], { encoding: "utf8" })) as Plan;
  const shown = await studio.plan();
  expect(shown.after.makespan).toBe(wanted.after.makespan);
  expect(shown.removed.map(({ obstacle, by }) => [obstacle, by])).toEqual(wanted.removed.map(({ obstacle, by }) => [obstacle, by]));
  const plan = join(setting.scratch, "plan.json");
  writeFileSync(plan, JSON.stringify(shown));
  expect(execFileSync(command, ["check", city, plan], { encoding: "utf8" })).toContain("valid");

  const again = await setting.settled({ viewport: phone }, page.url());
  expect((await again.plan()).after.makespan).toBe(wanted.after.makespan);
  await again.page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "clearing-phone.png"), fullPage: true });
  await page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "clearing.png") });
});
