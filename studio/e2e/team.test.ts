// Teams in the studio: opened from a file, steered, played, added to, and shown by a page that needs no server.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { expect, it } from "vitest";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, wide } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const size = { width: 501, height: 501 };
const setting = new Setting("team");
const { scratch } = setting;
const mission = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "truck", kind: "ground", start: [130, 104], goal: [466, 105] },
    { id: "rover", kind: "ground", start: [319, 410], goal: [72, 474], speed: 2, ready_at: 20 },
    { id: "drone", kind: "air", start: [130, 104], goal: [130, 104], speed: 5 },
  ],
  rules: { removals: 2, breach_time: 5 },
};

function written(name: string, document: unknown): string {
  const file = join(scratch, name);
  writeFileSync(file, JSON.stringify(document));
  return file;
}

it("opens the mission of a team, follows a marker, plays it, and takes another aircraft", async () => {
  const studio = await setting.visit();
  await studio.settled();
  await studio.page.getByLabel("File to open").setInputFiles(written("mission.json", mission));
  const table = studio.page.getByRole("table", { name: /^When each agent arrives/ });
  await table.getByRole("button", { name: "rover", exact: true }).waitFor();
  await studio.settled();
  const opened = await studio.plan();
  expect(opened.agents.map(({ id }) => id)).toEqual(["truck", "rover", "drone"]);
  expect(execFileSync(command, ["check", city, written("plan.json", opened)], { encoding: "utf8" })).toContain("valid");
  await expect.poll(() => studio.page.url()).toContain("vehicles=");

  const from = await studio.cellOf("Start of rover");
  const grip = await studio.place(from, size);
  await studio.page.mouse.move(grip.x, grip.y);
  await studio.page.mouse.down();
  for (let step = 1; step <= 8; ++step) await studio.page.mouse.move(grip.x + 6 * step, grip.y - 3 * step);
  await studio.page.mouse.up();
  const to = await studio.cellOf("Start of rover");
  expect(to).not.toEqual(from);
  await expect.poll(async () => (await studio.plan()).agents[1]!.start).toEqual(to);

  await studio.page.getByRole("button", { name: "Play", exact: true }).click();
  const time = studio.page.getByRole("slider", { name: "Time of the mission" });
  await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(5);
  expect(await time.getAttribute("aria-valuetext")).toMatch(/truck moves/);
  await studio.page.getByRole("button", { name: "Pause" }).click();

  await studio.page.getByRole("button", { name: "Add aircraft" }).click();
  await table.getByRole("button", { name: "air1", exact: true }).waitFor();
  await expect.poll(async () => (await studio.plan()).agents.length).toBe(4);
  await studio.settled();
  expect(await studio.accessibilityFaults()).toEqual([]);
  await studio.page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => table.getByRole("button", { name: "air1", exact: true }).count()).toBe(0);
  const link = studio.page.url();
  expect(studio.faults).toEqual([]);
  await studio.close();

  const again = await setting.visit({}, link);
  await again.page.getByRole("button", { name: /^Start of drone, column/ }).waitFor({ state: "attached" });
  expect(await again.cellOf("Start of rover")).toEqual(to);
  await again.close();
});

it("leaves the robot alone with what is in its way, by keyboard, and brings the aircraft back", async () => {
  const studio = await setting.visit();
  await studio.settled();
  const agents = [
    { id: "ground", kind: "ground", start: [130, 104], goal: [466, 105] },
    { id: "air", kind: "air", start: [130, 104], goal: [466, 105] },
  ];
  const pair = { ...mission, agents, rules: { removals: 3, breach_time: 20 } };
  await studio.page.getByLabel("File to open").setInputFiles(written("pair.json", pair));
  await expect.poll(async () => (await studio.plan()).options.removals).toBe(3);
  await studio.settled();
  await studio.page.getByRole("button", { name: "Robot alone" }).press("Enter");
  await expect.poll(async () => (await studio.plan()).removed.map(({ by }) => by)).toContain("ground");
  await studio.settled();
  const plan = await studio.plan();
  expect(plan.agents.map(({ id }) => id)).toEqual(["ground"]);
  expect(execFileSync(command, ["check", city, written("alone.json", plan)], { encoding: "utf8" })).toContain("valid");
  expect(await studio.accessibilityFaults()).toEqual([]);

  // What it breaks may stand all the same.
  await studio.page.getByRole("button", { name: "Rehearse this plan" }).click();
  await studio.page.getByRole("button", { name: "Breach fails" }).first().click();
  await studio.result().getByRole("heading", { name: /^The breach of .+ failed at .+: the mission ends .+ later/ }).waitFor();
  await studio.page.keyboard.press("Control+z");

  const limit = studio.page.getByLabel("Opens in its way");
  await limit.selectOption("0");
  await expect.poll(async () => (await studio.plan()).removed.length).toBe(0);
  await limit.selectOption("1");
  await expect.poll(async () => (await studio.plan()).removed.length).toBe(1);
  await expect.poll(() => studio.page.url()).toContain("vehicles=");
  await studio.page.getByRole("button", { name: "Add aircraft" }).press("Enter");
  await expect.poll(async () => (await studio.plan()).agents.map(({ id }) => id)).toEqual(["ground", "air"]);
  expect(studio.faults).toEqual([]);
  await studio.close();
});

it("says who waits for what, in the lanes and for those who do not see them", async () => {
  const yard = join(scratch, "yard.map"); // a wall from side to side, which takes long to open
  writeFileSync(yard, `type octile\nheight 9\nwidth 20\nmap\n${`${".".repeat(9)}@@${".".repeat(9)}\n`.repeat(9)}`);
  const agents = [
    { id: "truck", kind: "ground", start: [1, 4], goal: [18, 4] },
    { id: "rover", kind: "ground", start: [1, 6], goal: [18, 6] },
    { id: "drone", kind: "air", start: [1, 2], goal: [1, 2], speed: 2 },
  ];
  const file = written("yard.json", { format: "waybreaker-mission/1", agents, rules: { removals: 1, breach_time: 30 } });
  const html = join(scratch, "yard.html");
  execFileSync(command, ["plan", yard, "--mission", file, "--html", html], { stdio: "ignore" });
  const viewer = await setting.visit({}, pathToFileURL(html).href);
  await viewer.page.locator(".lane-ground .lane-wait").first().hover();
  await viewer.page.getByText(/^(truck|rover) waits for drone to open 1, \d+/).waitFor();
  await viewer.page.locator(".lane-air .lane-wait").first().hover();
  await viewer.page.getByText(/^drone opens 1, 30/).waitFor();
  await viewer.page.locator(".lane-air .lane-wait").first().click(); // goes to the middle of it
  await viewer.page.mouse.move(700, 300);
  const time = viewer.page.getByRole("slider", { name: "Time of the mission" });
  expect(await time.getAttribute("aria-valuetext")).toMatch(/truck waits for drone to open 1, rover waits for drone to open 1, drone opens 1/);
  await viewer.page.getByText(/^truck waits for drone to open 1; rover waits for drone to open 1; drone opens 1$/).waitFor();
  expect(await viewer.accessibilityFaults()).toEqual([]);
  expect(viewer.faults).toEqual([]);
  await viewer.close();
});

for (const [viewport, colorScheme] of [[wide, "light"], [phone, "dark"]] as const) {
  it(`is shown by a page that plays it, at ${viewport.width} px, ${colorScheme}`, async () => {
    const html = join(scratch, "team.html");
    const plan = ["plan", city, "--mission", written("mission.json", mission), "--time-limit", "1", "--html", html];
    execFileSync(command, plan, { stdio: "ignore" });
    const viewer = await setting.visit({ viewport, colorScheme }, pathToFileURL(html).href);
    await viewer.result().getByText("Checked independently").waitFor();
    await viewer.result().getByText(/arrives last/).first().waitFor();
    await viewer.page.getByRole("table", { name: /^When each agent arrives/ }).getByText("truck").waitFor();
    await viewer.page.getByRole("button", { name: "Play", exact: true }).click();
    const time = viewer.page.getByRole("slider", { name: "Time of the mission" });
    await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(5);
    expect(await viewer.accessibilityFaults()).toEqual([]);
    const wider = await viewer.page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    expect(wider).toBeLessThanOrEqual(0);
    expect(viewer.faults).toEqual([]);
    await viewer.close();
  });
}
