// An aircraft that recharges: set by the keyboard and by the mouse, planned as by the command, kept in the link and the
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
const size = { width: 501, height: 501 };
const query = "?map=berlin-adlershof.tif&start=130,104&goal=466,105&air_goal=130,104&air_speed=3&removals=3";
// From the middle of the way: what it opens lies on both sides of its start.
const between = "?map=berlin-adlershof.tif&start=130,104&goal=466,105&air_start=300,104&air_goal=300,104&air_speed=3&removals=3";
const setting = new Setting("bases");

const airOf = async (studio: StudioPage) => ((await studio.plan()).mission!.agents as AgentDocument[])[1]!;

// Without the mouse: the folds open by Enter.
async function limit({ page }: StudioPage, range: string): Promise<void> {
  await page.locator("summary", { hasText: "Mission settings" }).focus();
  await page.keyboard.press("Enter");
  await page.locator("summary", { hasText: "Aircraft’s battery" }).focus();
  await page.keyboard.press("Enter");
  await page.getByLabel("Range").focus();
  await page.keyboard.type(range);
  await page.keyboard.press("Tab");
}

it("flies again from its start, and is planned, told and kept so", async () => {
  const studio = await setting.settled({ query: between });
  const { page } = studio;
  expect(await page.getByLabel("Recharges in").count()).toBe(0);
  await limit(studio, "400");
  await expect.poll(async () => (await airOf(studio)).range).toBeDefined();
  await studio.settled();
  const [once] = await studio.figures();
  await page.getByLabel("Recharges in").focus();
  await page.keyboard.type("0,1");
  await page.keyboard.press("Tab");
  await expect.poll(async () => (await airOf(studio)).recharge).toBe(6);
  await page.getByText("Recharges at its start and goal.").waitFor();
  await studio.settled();
  expect((await studio.figures())[0]).toBeLessThan(once!);
  expect((await studio.plan()).agents[1]!.recharges?.[0]?.at).toEqual([300, 104]);
  await studio.result().getByText(/The aircraft recharges at 300,104 for 6\ss, with \d+\sm of 400\sm left/).first().waitFor();
  expect(await page.locator("p.legend").innerText()).not.toContain("base");
  expect(await studio.accessibilityFaults()).toEqual([]);

  const plan = join(setting.scratch, "plan.json");
  writeFileSync(plan, JSON.stringify(await studio.plan()));
  expect(execFileSync(command, ["check", city, plan], { encoding: "utf8" })).toContain("valid");
  await page.getByLabel("Recharges in").fill("");
  await expect.poll(async () => (await airOf(studio)).recharge).toBeUndefined();
  await studio.settled();
  expect((await studio.figures())[0]).toBe(once);
  expect(studio.faults).toEqual([]);
});

it("recharges at bases that are set on the map, which stand in the link and in the file", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  await limit(studio, "900");
  await page.getByLabel("Recharges in").fill("0.1");
  await page.getByRole("button", { name: "Add base" }).focus();
  await page.keyboard.press("Enter");
  await page.getByRole("status").getByText("Click where the aircraft can recharge.").waitFor();
  await page.keyboard.press("Enter"); // in the middle: the map has the keyboard
  await expect.poll(async () => (await airOf(studio)).bases).toHaveLength(1);
  const { x, y } = await studio.place([300, 110], size);
  await page.mouse.click(x, y);
  await expect.poll(async () => (await airOf(studio)).bases).toHaveLength(2);
  const [middle, clicked] = (await airOf(studio)).bases!;
  expect(Math.hypot(clicked![0] - 300, clicked![1] - 110)).toBeLessThan(2);
  await page.keyboard.press("Escape");
  expect(await page.getByRole("radio", { name: "Move" }).isChecked()).toBe(true);
  await studio.settled();
  expect(await page.locator("p.legend").innerText()).toContain("base");
  expect(await studio.accessibilityFaults()).toEqual([]);
  await page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "bases.png") });

  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const saved = join(setting.scratch, "mission.json");
  await (await download).saveAs(saved);
  const { agents } = JSON.parse(readFileSync(saved, "utf8")) as { agents: AgentDocument[] };
  expect(agents[1]).toMatchObject({ recharge: 6, bases: [middle, clicked] });
  const same = JSON.parse(execFileSync(command, ["plan", city, "--mission", saved, "--json", "-"], { encoding: "utf8" })) as Plan;
  expect(same.after.makespan).toBe((await studio.figures())[0]);

  const again = await setting.settled({ viewport: phone }, page.url());
  expect((await airOf(again)).bases).toEqual([middle, clicked]);
  await again.page.locator("summary", { hasText: "Mission settings" }).click();
  await again.page.locator("summary", { hasText: "Aircraft’s battery" }).click();
  expect(await again.cutOff(".panel *, .tools *")).toEqual([]);
  await again.page.getByRole("button", { name: `Remove base ${middle!.join()}` }).click();
  await expect.poll(async () => (await airOf(again)).bases).toEqual([clicked]);
  await again.page.getByLabel("File to open").setInputFiles(saved);
  await expect.poll(async () => (await airOf(again)).bases).toEqual([middle, clicked]);
  expect(await again.page.getByText(/Left out/).count()).toBe(0);
  expect([...studio.faults, ...again.faults]).toEqual([]);
});
