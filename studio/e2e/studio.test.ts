// The studio as people use it, in a real browser against a real server.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, describe, expect, it } from "vitest";
import type { Run } from "../src/domain/geometry";
import { freshMission } from "../src/domain/mission";
import type { Plan } from "../src/domain/plan";
import { missionFile } from "../src/mission/mission_file";
import { union } from "../src/mission/run_set";
import { command, data } from "./command";
import { Server } from "./server";
import { Setting } from "./setting";
import { StudioPage } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const size = { width: 501, height: 501 };
const setting = new Setting("studio");
const { scratch } = setting;

let studio: StudioPage | null = null;

afterEach(async () => {
  await studio?.close();
  studio = null;
});

async function visit(options: Parameters<typeof StudioPage.visit>[2] = {}): Promise<StudioPage> {
  studio = await setting.visit(options);
  await studio.settled();
  return studio;
}

function commandAccepts(plan: Plan, map: string): string {
  const file = join(scratch, "plan.json");
  writeFileSync(file, JSON.stringify(plan));
  return execFileSync(command, ["check", map, file], { encoding: "utf8" });
}

function yardFile(): string {
  const file = join(scratch, "yard.map");
  const rows = Array.from({ length: 20 }, (_, y) => (y > 3 && y < 16 ? "........@@@........." : "....................")).join("\n");
  writeFileSync(file, `type octile\nheight 20\nwidth 20\nmap\n${rows}\n`);
  return file;
}

const slider = (page: StudioPage) => page.page.getByRole("slider", { name: "Removals" });

describe("first visit", () => {
  it("shows a real city with a mission already planned, and says what removing gains", async () => {
    const page = await visit();
    await page.result().getByText(/Removing 2 obstacles gets the ground robot there 8\.7\s% sooner/).first().waitFor();
    await page.result().getByText(/May be up to 1\.\d\s% from the best possible/).waitFor();
    await page.page.getByText("OpenStreetMap contributors").waitFor();
    expect(page.faults).toEqual([]);
  });

  it("shows the figures of the server's plan, which the command's check accepts", async () => {
    const page = await visit();
    const plan = await page.plan();
    expect(await page.figures()).toEqual([plan.after.makespan, plan.before.makespan]);
    expect(commandAccepts(plan, city)).toContain("valid");
    const rows = page.page.getByRole("table", { name: /Removed obstacles/ }).getByRole("row");
    expect(await rows.count()).toBe(1 + plan.removed.length);
  });

  it("can be used soon after it was asked for, and is small", async () => {
    const page = await visit();
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
    const page = await visit();
    const from = await page.cellOf("Ground start");
    const [before] = await page.figures();
    const grip = await page.place(from, size);
    await page.page.mouse.move(grip.x, grip.y);
    await page.page.mouse.down();
    for (let step = 1; step <= 10; ++step) await page.page.mouse.move(grip.x + 8 * step, grip.y - 4 * step);
    await expect.poll(async () => (await page.figures())[0], { timeout: 10_000 }).not.toBe(before);
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
    const page = await visit();
    const [x, y] = await page.cellOf("Ground goal");
    await page.marker("Ground goal").focus();
    await page.page.keyboard.press("ArrowRight");
    await page.page.keyboard.press("Shift+ArrowDown");
    await expect.poll(async () => (await page.cellOf("Ground goal"))[1], { timeout: 10_000 }).toBeGreaterThan(y);
    const [right, down] = await page.cellOf("Ground goal");
    expect(right).toBeGreaterThan(x);
    await expect.poll(async () => (await page.plan()).agents[0]!.goal, { timeout: 10_000 }).toEqual([right, down]);
  });

  it("takes the number of removals from the slider, and the curve shows what each number reaches", async () => {
    const page = await visit();
    await slider(page).focus();
    await page.page.keyboard.press("Home");
    await page.result().getByText(/nothing removed/i).waitFor();
    await page.settled();
    const [none] = await page.figures();
    await page.page.keyboard.press("End");
    await expect.poll(async () => (await page.figures())[0]!, { timeout: 10_000 }).toBeLessThan(none!);
    await expect.poll(async () => (await page.plan()).options.removals, { timeout: 10_000 }).toBe(8);
    const curve = page.page.getByRole("group", { name: "What each number of removals reaches" });
    await expect.poll(() => curve.getByRole("button").count(), { timeout: 20_000 }).toBe(9);
  });

  it("protects and forces obstacles, by name and from the table", async () => {
    const page = await visit();
    const first = (await page.plan()).removed[0]!.obstacle;
    const protect = page.page.getByRole("button", { name: /^Protect / }).first();
    await protect.click();
    await expect.poll(async () => (await page.plan()).options.protect ?? [], { timeout: 10_000 }).toHaveLength(1);
    await page.settled();
    const plan = await page.plan();
    expect(plan.removed.map((one) => one.obstacle)).not.toContain(plan.options.protect![0]);
    expect([first, ...plan.removed.map((one) => one.obstacle)]).toContain(plan.options.protect![0]);
    expect(commandAccepts(plan, city)).toContain("valid");
    await page.page.getByRole("button", { name: "Undo" }).click();
    await page.page.getByRole("button", { name: /^Force / }).first().click();
    await expect.poll(async () => (await page.plan()).options.force ?? [], { timeout: 10_000 }).toHaveLength(1);
    expect(commandAccepts(await page.plan(), city)).toContain("valid");
  });

  it("tells about an obstacle that is clicked on the map", async () => {
    const page = await visit();
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
    const page = await visit();
    await page.page.getByRole("radio", { name: "Draw wall" }).check({ force: true });
    const plan = await page.plan();
    const path = plan.agents[0]!.path;
    const [from, to] = path.slice(1).map((end, i) => [path[i]!, end] as const).sort(([a, b], [c, d]) => d[0] - c[0] - (b[0] - a[0]))[0]!;
    const spot = await page.place([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], size);
    await page.page.mouse.move(spot.x, spot.y - 30);
    await page.page.mouse.down();
    for (let step = 1; step <= 12; ++step) await page.page.mouse.move(spot.x, spot.y - 30 + 5 * step);
    await page.page.mouse.up();
    await expect.poll(async () => (await page.plan()).map.digest, { timeout: 15_000 }).not.toBe(plan.map.digest);
    await page.settled();
    const saved = page.page.waitForEvent("download");
    await page.page.getByRole("region", { name: "Take it along" }).getByRole("button", { name: "Map file" }).click();
    const file = join(scratch, "edited.tif");
    await (await saved).saveAs(file);
    expect(commandAccepts(await page.plan(), file)).toContain("valid");
    const link = page.page.url();
    await page.close();
    studio = await setting.visit({}, link);
    await studio.settled();
    expect((await studio.plan()).map.digest).not.toBe(plan.map.digest);
  });
});

describe("a number", () => {
  it("is typed with a comma or a point, and means the same", async () => {
    const page = await visit();
    await page.page.getByText("Mission settings").click();
    const field = page.page.getByLabel("Ground robot’s speed");
    const speedOf = async () => (await page.plan()).agents[0]!.speed * (await page.plan()).map.cell_size;
    for (const [typed, speed] of [["1,5", 1.5], ["2.5", 2.5], [",5", 0.5]] as const) {
      await field.click();
      await page.page.keyboard.press("Control+a");
      await page.page.keyboard.type(typed);
      await page.page.keyboard.press("Tab");
      expect(await field.inputValue()).toBe(String(speed));
      await expect.poll(speedOf, { timeout: 20_000 }).toBeCloseTo(speed, 6);
    }
    expect(page.faults).toEqual([]);
  });

  it("that cannot be taken stands, with what is wrong beside it, until it is mended", async () => {
    const page = await visit();
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
    const page = await visit();
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

describe("a link", () => {
  it("restores the mission", async () => {
    const page = await visit();
    await slider(page).focus();
    await page.page.keyboard.press("ArrowRight");
    await page.page.getByRole("button", { name: /^Protect / }).first().click();
    await expect.poll(async () => (await page.plan()).options.protect ?? [], { timeout: 10_000 }).toHaveLength(1);
    await page.settled();
    await expect.poll(() => page.page.url()).toContain("protect=");
    const plan = await page.plan();
    const link = page.page.url();
    await page.close();
    studio = await setting.visit({}, link);
    await studio.settled();
    const restored = await studio.plan();
    for (const key of ["removals", "protect", "objective"] as const) expect(restored.options[key]).toEqual(plan.options[key]);
    expect(restored.removed.map((one) => one.obstacle)).toEqual(plan.removed.map((one) => one.obstacle));
    expect((await studio.figures())[0]).toBe(plan.after.makespan);
  });

  it("keeps a drawing of many strokes, which a file brings, too", async () => {
    const strokes = Array.from({ length: 32 * 90 }, (_, i): Run => [(i * 7) % 350 + ((i >> 5) % 90), 100 + (i % 300), 3]);
    const mission = freshMission("berlin-mitte.tif", { start: [256, 434], goal: [118, 55] });
    const file = join(scratch, "mission.json");
    writeFileSync(file, missionFile({ ...mission, walls: union(strokes, []) }, { width: 501, cell: 2.4, metric: true }, 3));
    const page = await visit({ query: "#map=berlin-mitte.tif&start=256,434&goal=118,55&removals=1" });
    const { digest } = (await page.plan()).map;
    await page.page.getByLabel("File to open").setInputFiles(file);
    await expect.poll(() => page.page.url(), { timeout: 10_000 }).toContain("#z=");
    await page.page.getByText(/^Drawn: /).waitFor();
    const drawn = await page.page.getByText(/^Drawn: /).innerText();
    const link = page.page.url();
    await page.close();
    studio = await setting.visit({}, link);
    expect(await studio.page.getByText(/^Drawn: /).innerText()).toBe(drawn);
    await studio.page.goto(`${setting.server.url}/#map=berlin-mitte.tif&start=256,434&goal=118,55&removals=1`); // the same page
    await studio.settled();
    await expect.poll(async () => (await studio!.plan()).map.digest, { timeout: 10_000 }).toBe(digest);
  });

  it("and a plan's file bring back its mission", async () => {
    const page = await visit({ query: "#map=berlin-mitte.tif&start=250,430&goal=118,55&removals=3&ground_speed=2" });
    const plan = await page.plan();
    await page.close();
    const file = join(scratch, "plan.json");
    writeFileSync(file, JSON.stringify(plan));
    const other = await visit();
    await other.page.getByLabel("File to open").setInputFiles(file);
    await other.page.getByText("The mission of the plan is planned anew.").waitFor();
    await other.settled();
    const again = await other.plan();
    expect(again.options.objective).toEqual(plan.options.objective);
    expect(again.agents).toEqual(plan.agents);
  });

  it("that is broken says so, and the page works on", async () => {
    const page = await visit({ query: "?map=berlin-mitte.tif&start=9999,4&removals=many" });
    await page.page.getByText(/in the link cannot be read/).waitFor();
  });

  it("to a map that is not there, or cannot be, says so", async () => {
    for (const name of ["atlantis.tif", "../x"]) {
      studio = await setting.visit({ query: `#map=${name}` });
      await studio.page.getByText(`does not have the map “${name}”`).waitFor();
      await studio.close();
    }
    studio = null;
  });
});

describe("what goes wrong", () => {
  it("a file that is no map gets the server's words, and the mission stays", async () => {
    const page = await visit();
    const before = await page.figures();
    const file = join(scratch, "holiday.map");
    writeFileSync(file, "type octile\nheight 3\nwidth banana\nmap\n");
    await page.page.getByLabel("File to open").setInputFiles(file);
    const alert = page.page.getByRole("alert").filter({ hasText: "holiday.map" });
    await alert.waitFor();
    expect(await alert.innerText()).toMatch(/width|banana|line 3/);
    expect(await page.figures()).toEqual(before);
  });

  it("a good file of one's own is opened", async () => {
    const page = await visit();
    await page.page.getByLabel("File to open").setInputFiles(yardFile());
    await expect.poll(async () => (await page.plan()).map.width, { timeout: 10_000 }).toBe(20);
    await page.settled();
  });

  it("a ROS map is opened by its YAML and image together, and an image alone says how it was read", async () => {
    const [yaml, image] = [join(scratch, "floor.yaml"), join(scratch, "floor.pgm")];
    const greys = Array.from({ length: 12 * 12 }, (_, i) => (i % 12 === 6 && i > 24 ? 0 : i < 12 ? 205 : 254));
    writeFileSync(yaml, "image: floor.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
    writeFileSync(image, `P2 12 12 255\n${greys.join(" ")}\n`);
    const page = await visit();
    const input = page.page.getByLabel("File to open");
    await input.setInputFiles(yaml);
    await page.page.getByText("“floor.yaml” belongs to “floor.pgm”: choose both together.").waitFor();
    await input.setInputFiles([image, yaml]);
    await expect.poll(async () => (await page.plan()).map.cell_size, { timeout: 10_000 }).toBe(0.5);
    await page.settled();
    expect(await page.page.getByLabel("How the map was read").count()).toBe(0);
    await input.setInputFiles(image);
    await page.page.getByLabel("How the map was read").getByText(/205.* is free/).waitFor();
  });

  it("a map that is gone is said, asked for once, and can be sent again", async () => {
    const other = await Server.start();
    studio = await setting.visit({}, `${other.url}/`);
    await studio.settled();
    await studio.page.getByLabel("File to open").setInputFiles(yardFile());
    await expect.poll(async () => (await studio!.plan()).map.width, { timeout: 10_000 }).toBe(20);
    await studio.settled();
    await other.stop();
    const back = await Server.start(other.port);
    let asked = 0;
    studio.page.on("request", () => ++asked);
    await studio.marker("Ground goal").focus(); // what no plan of the curve knows
    await studio.page.keyboard.press("ArrowLeft");
    const card = studio.page.getByRole("alert").filter({ hasText: "no longer has the map “yard.map”" });
    await card.waitFor();
    await studio.result().getByText("This is the plan from before your last change").waitFor();
    expect(await studio.result().getByText("Checked independently").count()).toBe(0);
    await studio.marker("Ground goal").focus();
    await studio.page.keyboard.press("ArrowLeft");
    await studio.page.waitForTimeout(1500);
    expect(asked).toBeLessThan(6);
    await card.getByRole("button", { name: "Send it again" }).click();
    await card.waitFor({ state: "detached" });
    await studio.settled();
    expect((await studio.plan()).map.width).toBe(20);
    await studio.result().getByText("Checked independently").waitFor(); // of the plan that is on its way
    await back.stop();
  });

  it("a server that is gone is told of, and the page goes on when it is back", async () => {
    const other = await Server.start();
    studio = await setting.visit({}, `${other.url}/`);
    await studio.settled();
    const before = await studio.figures();
    await other.stop();
    await studio.marker("Ground goal").focus();
    await studio.page.keyboard.press("ArrowRight");
    await studio.page.getByText("The server does not answer").waitFor();
    expect(await studio.figures()).toEqual(before);
    const back = await Server.start(other.port);
    await studio.page.getByText("The server does not answer").waitFor({ state: "detached" });
    const goal = await studio.cellOf("Ground goal");
    await expect.poll(async () => (await studio!.plan()).agents[0]!.goal, { timeout: 15_000 }).toEqual(goal);
    await back.stop();
  });
});
