// The studio as people use it, in a real browser against a real server.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { Setting } from "./setting";
import { StudioPage } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const size = { width: 501, height: 501 };
const setting = new Setting("studio");
const { scratch } = setting;

function commandAccepts(plan: Plan, map: string): string {
  const file = join(scratch, "plan.json");
  writeFileSync(file, JSON.stringify(plan));
  return execFileSync(command, ["check", map, file], { encoding: "utf8" });
}

const slider = (page: StudioPage) => page.page.getByRole("slider", { name: "Removals" });

describe("first visit", () => {
  it("shows a real city with a mission already planned, and says what removing gains", async () => {
    const page = await setting.settled();
    await page.result().getByText(/Removing 2 obstacles gets the ground robot there 8\.7\s% sooner/).first().waitFor();
    await page.result().getByText(/May be up to 1\.\d\s% from the best possible/).waitFor();
    await page.page.getByText("OpenStreetMap contributors").waitFor();
    expect(page.faults).toEqual([]);
  });

  it("shows the figures of the server's plan, which the command's check accepts", async () => {
    const page = await setting.settled();
    const plan = await page.plan();
    expect(await page.figures()).toEqual([plan.after.makespan, plan.before.makespan]);
    expect(commandAccepts(plan, city)).toContain("valid");
    const rows = page.page.getByRole("table", { name: /Removed obstacles/ }).getByRole("row");
    expect(await rows.count()).toBe(1 + plan.removed.length);
  });

  it("can be used soon after it was asked for, and is small", async () => {
    const page = await setting.settled();
    const ready = await page.page.evaluate(() => performance.getEntriesByType("paint").at(-1)!.startTime);
    const sent = await page.page.evaluate(() => {
      const files = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")];
      const own = (files as PerformanceResourceTiming[]).filter((file) => !file.name.includes("/api/"));
      return own.reduce((sum, file) => sum + file.encodedBodySize, 0);
    });
    expect(sent).toBeGreaterThan(0);
    expect(sent).toBeLessThan(300_000);
    expect(ready).toBeGreaterThan(0); // how long it takes depends on the machine: docs/performance.md
  });
});

describe("the mission", () => {
  it("follows a marker that is dragged, and one press undoes the drag", async () => {
    const page = await setting.settled();
    const from = await page.cellOf("Ground start");
    const [before] = await page.figures();
    const grip = await page.place(from, size);
    await page.page.mouse.move(grip.x, grip.y);
    await page.page.mouse.down();
    for (let step = 1; step <= 10; ++step) await page.page.mouse.move(grip.x + 8 * step, grip.y - 4 * step);
    await expect.poll(async () => (await page.figures())[0]).not.toBe(before);
    await page.page.mouse.up();
    await page.settled();
    const to = await page.cellOf("Ground start");
    expect(to).not.toEqual(from);
    const plan = await page.plan();
    expect(plan.agents[0]!.start).toEqual(to);
    expect((await page.figures())[0]).toBe(plan.after.makespan);
    expect(commandAccepts(plan, city)).toContain("valid");
    await page.page.keyboard.press("Control+z");
    await expect.poll(() => page.cellOf("Ground start")).toEqual(from);
    await page.page.getByRole("button", { name: "Redo" }).click();
    await expect.poll(() => page.cellOf("Ground start")).toEqual(to);
    expect(page.faults).toEqual([]);
  });

  it("moves a marker by the keyboard alone", async () => {
    const page = await setting.settled();
    const [x, y] = await page.cellOf("Ground goal");
    await page.marker("Ground goal").focus();
    await page.page.keyboard.press("ArrowRight");
    await page.page.keyboard.press("Shift+ArrowDown");
    await expect.poll(async () => (await page.cellOf("Ground goal"))[1]).toBeGreaterThan(y);
    const [right, down] = await page.cellOf("Ground goal");
    expect(right).toBeGreaterThan(x);
    await expect.poll(async () => (await page.plan()).agents[0]!.goal).toEqual([right, down]);
  });

  it("takes the number of removals from the slider, and the curve shows what each number reaches", async () => {
    const page = await setting.settled();
    await slider(page).focus();
    await page.page.keyboard.press("Home");
    await page.result().getByText(/nothing removed/i).waitFor();
    await page.settled();
    const [none] = await page.figures();
    await page.page.keyboard.press("End");
    await expect.poll(async () => (await page.figures())[0]!).toBeLessThan(none!);
    await expect.poll(async () => (await page.plan()).options.removals).toBe(8);
    const curve = page.page.getByRole("group", { name: "What each number of removals reaches" });
    await expect.poll(() => curve.getByRole("button").count()).toBe(9);
  });

  it("protects and forces obstacles, by name and from the table", async () => {
    const page = await setting.settled();
    const first = (await page.plan()).removed[0]!.obstacle;
    const protect = page.page.getByRole("button", { name: /^Protect / }).first();
    await protect.click();
    await expect.poll(async () => (await page.plan()).options.protect ?? []).toHaveLength(1);
    await page.settled();
    const plan = await page.plan();
    expect(plan.removed.map((one) => one.obstacle)).not.toContain(plan.options.protect![0]);
    expect([first, ...plan.removed.map((one) => one.obstacle)]).toContain(plan.options.protect![0]);
    expect(commandAccepts(plan, city)).toContain("valid");
    await page.page.getByRole("button", { name: "Undo" }).click();
    await page.page.getByRole("button", { name: /^Force / }).first().click();
    await expect.poll(async () => (await page.plan()).options.force ?? []).toHaveLength(1);
    expect(commandAccepts(await page.plan(), city)).toContain("valid");
  });

  it("tells about an obstacle that is clicked on the map", async () => {
    const page = await setting.settled();
    const obstacles = await (await page.page.request.get(`${setting.server.url}/api/v1/maps/berlin-adlershof.tif/obstacles`)).json();
    const runs = obstacles.runs as number[];
    let at = 0;
    let id = 0;
    let cell: [number, number] | null = null;
    for (let i = 0; i < runs.length && !cell; i += 2) {
      if (runs[i] !== 0 && runs[i + 1]! > 7) cell = [(at + 4) % 501, Math.floor((at + 4) / 501)];
      if (cell) id = runs[i]!;
      at += runs[i + 1]!;
    }
    const spot = await page.place(cell!, size);
    await page.page.mouse.click(spot.x, spot.y);
    const card = page.page.getByRole("complementary", { name: /^About / });
    await card.waitFor();
    await card.getByText(`${Math.abs(obstacles.obstacles[id - 1].source_id)}`).waitFor();
    await card.getByRole("button", { name: "Close" }).click();
    await card.waitFor({ state: "detached" });
  });

  it("draws a wall, plans around it, and the plan holds on the edited map's file", async () => {
    const page = await setting.settled();
    await page.page.getByRole("radio", { name: "Draw wall" }).check({ force: true });
    const plan = await page.plan();
    const path = plan.agents[0]!.path;
    const [from, to] = path.slice(1).map((end, i) => [path[i]!, end] as const).sort(([a, b], [c, d]) => d[0] - c[0] - (b[0] - a[0]))[0]!;
    const spot = await page.place([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], size);
    await page.page.mouse.move(spot.x, spot.y - 30);
    await page.page.mouse.down();
    for (let step = 1; step <= 12; ++step) await page.page.mouse.move(spot.x, spot.y - 30 + 5 * step);
    await page.page.mouse.up();
    await expect.poll(async () => (await page.plan()).map.digest).not.toBe(plan.map.digest);
    await page.settled();
    const saved = page.page.waitForEvent("download");
    await page.page.getByRole("region", { name: "Take it along" }).getByRole("button", { name: "Map file" }).click();
    const file = join(scratch, "edited.tif");
    await (await saved).saveAs(file);
    expect(commandAccepts(await page.plan(), file)).toContain("valid");
    const link = page.page.url();
    await page.close();
    const studio = await setting.settled({}, link);
    expect((await studio.plan()).map.digest).not.toBe(plan.map.digest);
  });
});

describe("a number", () => {
  it("is typed with a comma or a point, and means the same", async () => {
    const page = await setting.settled();
    await page.page.getByText("Mission settings").click();
    const field = page.page.getByLabel("Ground robot’s speed");
    const speedOf = async () => (await page.plan()).agents[0]!.speed * (await page.plan()).map.cell_size;
    for (const [typed, speed] of [["1,5", 1.5], ["2.5", 2.5], [",5", 0.5]] as const) {
      await field.click();
      await page.page.keyboard.press("Control+a");
      await page.page.keyboard.type(typed);
      await page.page.keyboard.press("Tab");
      expect(await field.inputValue()).toBe(String(speed));
      await expect.poll(speedOf).toBeCloseTo(speed, 6);
    }
    expect(page.faults).toEqual([]);
  });

  it("that cannot be taken stands, with what is wrong beside it, until it is mended", async () => {
    const page = await setting.settled();
    await page.page.getByText("Mission settings").click();
    const field = page.page.getByLabel("Aircraft’s speed");
    const said = page.page.getByText("Give 0.01 to 1000 m/s. Until then it stays 1.");
    for (const wrong of ["0", "-3", "", "1e9", "1.000,5", "fast"]) {
      await field.fill(wrong);
      await said.waitFor();
      await field.blur();
      await said.waitFor();
      expect([await field.inputValue(), await field.getAttribute("aria-invalid")]).toEqual([wrong, "true"]);
    }
    expect(await page.accessibilityFaults()).toEqual([]);
    await field.fill("2,5");
    await said.waitFor({ state: "detached" });
    await field.blur();
    expect([await field.inputValue(), await field.getAttribute("aria-invalid")]).toEqual(["2.5", "false"]);
  });
});

describe("playback", () => {
  it("plays, pauses and can be scrubbed", async () => {
    const page = await setting.settled();
    const time = page.page.getByRole("slider", { name: "Time of the mission" });
    await page.page.getByRole("button", { name: "Play", exact: true }).click();
    await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(5);
    await page.page.getByRole("button", { name: "Pause" }).click();
    const stopped = await time.inputValue();
    await page.page.waitForTimeout(300);
    expect(await time.inputValue()).toBe(stopped);
    await time.focus();
    await page.page.keyboard.press("End");
    expect(Number(await time.inputValue())).toBeCloseTo(Number(await time.getAttribute("max")), 0);
    expect(await time.getAttribute("aria-valuetext")).toMatch(/ of /);
  });
});
