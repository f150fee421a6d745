// Zones: drawn by the mouse and by the keyboard, planned round, named, kept in the link and the file, and removed.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { Point } from "../src/domain/geometry";
import type { ZoneCollection } from "../src/domain/zone";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, type StudioPage } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const size = { width: 501, height: 501 };
const query = "?map=berlin-adlershof.tif&start=130,104&goal=466,105&removals=1";
const setting = new Setting("zone");
const corners: Point[] = [[250, 60], [330, 60], [345, 170], [270, 190]];

const zonesOf = async (studio: StudioPage) =>
  ((await studio.plan()).mission?.rules?.zones as ZoneCollection | undefined)?.features ?? [];

async function draw(studio: StudioPage): Promise<void> {
  await studio.page.getByRole("radio", { name: "Zone" }).check({ force: true });
  for (const corner of [...corners, corners[0]!]) {
    const { x, y } = await studio.place(corner, size);
    await studio.page.mouse.click(x, y);
  }
}

it("is drawn, flown round, named, kept in the link and in the file, and removed", async () => {
  const studio = await setting.settled({ query });
  const { page } = studio;
  const bends = async () => (await studio.plan()).agents.find(({ kind }) => kind === "air")!.path.length;
  const before = await bends();
  await draw(studio);
  await expect.poll(async () => (await zonesOf(studio)).length).toBe(1);
  await studio.settled();
  expect(await bends()).toBeGreaterThan(before);
  const [drawn] = await zonesOf(studio);
  drawn!.geometry.coordinates[0]!.forEach(([x, y], i) => {
    const [right, down] = corners[i % corners.length]!;
    expect(Math.hypot(x - right, y - down)).toBeLessThan(1);
  });
  const file = join(setting.scratch, "plan.json");
  writeFileSync(file, JSON.stringify(await studio.plan()));
  expect(execFileSync(command, ["check", city, file], { encoding: "utf8" })).toContain("valid");

  await page.getByLabel("Name of zone 1").fill("helipad");
  await page.getByLabel("Name of zone 1").blur();
  await expect.poll(async () => (await zonesOf(studio))[0]?.properties.name).toBe("helipad");
  await page.getByLabel("Who keeps out of zone 1").selectOption("keep_out");
  await expect.poll(async () => (await zonesOf(studio))[0]?.properties.zone).toBe("keep_out");
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await zonesOf(studio))[0]?.properties.zone).toBe("no_fly");
  await studio.settled();
  expect(await studio.accessibilityFaults()).toEqual([]);

  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Mission", exact: true }).click();
  const saved = join(setting.scratch, "mission.json");
  await (await download).saveAs(saved);
  const { rules } = JSON.parse(readFileSync(saved, "utf8")) as { rules: { zones: ZoneCollection } };
  expect(rules.zones.features[0]!.properties).toEqual({ zone: "no_fly", name: "helipad" });

  const again = await setting.settled({}, page.url());
  expect(await again.page.getByLabel("Name of zone 1").inputValue()).toBe("helipad");
  expect((await zonesOf(again)).length).toBe(1);
  await again.page.getByRole("button", { name: "Remove zone 1" }).click();
  await expect.poll(async () => (await zonesOf(again)).length).toBe(0);
  await again.page.getByLabel("File to open").setInputFiles(saved);
  await expect.poll(() => again.page.getByLabel("Name of zone 1").inputValue()).toBe("helipad");
  expect([...studio.faults, ...again.faults]).toEqual([]);
});

it("is drawn by the keyboard alone, on a phone as well", async () => {
  const studio = await setting.settled({ query, viewport: phone });
  const { page } = studio;
  await studio.map().focus();
  await page.keyboard.press("z");
  for (const key of ["Enter", "ArrowRight", "Enter", "ArrowDown", "Enter", "ArrowLeft", "Enter"]) await page.keyboard.press(key);
  await page.getByRole("status").getByText("4 corners: click the first corner again to close it.").waitFor();
  await page.keyboard.press("Backspace");
  await page.getByRole("status").getByText("3 corners").waitFor();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await expect.poll(async () => (await zonesOf(studio)).length).toBe(1);
  expect((await zonesOf(studio))[0]!.geometry.coordinates[0]).toHaveLength(4);
  expect(await studio.cutOff(".panel *, .tools *")).toEqual([]);
  expect(studio.faults).toEqual([]);
});

it("comes from a file, in longitude and latitude, and goes with one step back", async () => {
  const studio = await setting.settled({ query: "?map=krems.tif&start=487,5&goal=450,240&removals=2" });
  const { page } = studio;
  const [far] = await studio.figures();
  await page.getByLabel("File to open").setInputFiles(join(data, "krems-helipad.geojson"));
  await page.getByText("A zone is added.").waitFor();
  await expect.poll(async () => (await zonesOf(studio)).length).toBe(1);
  await studio.settled();
  expect((await studio.figures())[0]).toBeGreaterThan(far!);
  expect((await studio.plan()).removed.map(({ obstacle }) => obstacle)).toContain(458);
  expect(await page.getByLabel("Name of zone 1").inputValue()).toBe("helipad");
  expect(await studio.accessibilityFaults()).toEqual([]);
  const nowhere = join(setting.scratch, "nowhere.geojson");
  writeFileSync(nowhere, '{"type": "FeatureCollection", "features": [{"properties": {"zone": "no_fly"}, "geometry": null}]}');
  await page.getByLabel("File to open").setInputFiles(nowhere);
  await page.getByText("“nowhere.geojson” is no collection of zones").waitFor();
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await zonesOf(studio)).length).toBe(0);
  expect(studio.faults).toEqual([]);
});

it("holds until a time, by the keyboard, and the aircraft need not fly round", async () => {
  const studio = await setting.settled({ query: "?map=krems.tif&start=487,5&goal=450,240&removals=2" });
  const { page } = studio;
  const [free] = await studio.figures();
  await page.getByLabel("File to open").setInputFiles(join(data, "krems-helipad.geojson"));
  await expect.poll(async () => (await zonesOf(studio)).length).toBe(1);
  await studio.settled();
  expect((await studio.figures())[0]).toBeGreaterThan(free!);
  await page.getByLabel("Zone 1 holds until").focus();
  await page.keyboard.type("1,5");
  await page.keyboard.press("Tab");
  await expect.poll(async () => (await zonesOf(studio))[0]?.properties.until).toBe(1.5);
  await studio.settled();
  expect((await studio.figures())[0]).toBe(free);
  expect(await studio.accessibilityFaults()).toEqual([]);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await zonesOf(studio))[0]?.properties.until).toBeUndefined();
  expect(studio.faults).toEqual([]);
});

// A mission file with a zone, in cells: between a square and a smaller one within it, or all of the square.
function missionFile(name: string, properties: object, halves: number[], [x, y]: Point): string {
  const square = (half: number) => [[-half, -half], [half, -half], [half, half], [-half, half], [-half, -half]].map(([dx, dy]) => [x + dx!, y + dy!]);
  const zone = { type: "Feature", properties: { ...properties, name }, geometry: { type: "Polygon", coordinates: halves.map(square) } };
  const zones = { type: "FeatureCollection", crs: "cells", features: [zone] };
  const agents = [
    { id: "ground", kind: "ground", start: [130, 104], goal: [466, 105] },
    { id: "air", kind: "air", start: [130, 104], goal: [130, 104] },
  ];
  const file = join(setting.scratch, `${name}.json`);
  writeFileSync(file, JSON.stringify({ format: "waybreaker-mission/1", agents, rules: { removals: 1, zones } }));
  return file;
}

it("says so where a start lies in it", async () => {
  const studio = await setting.settled({ query });
  await studio.page.getByLabel("File to open").setInputFiles(missionFile("home", { zone: "no_fly" }, [15], [130, 104]));
  await studio.page.getByText(/start 130,104 lies in the zone 'home'/).first().waitFor();
  await studio.page.getByRole("button", { name: "Remove zone 1" }).click();
  await studio.settled();
});

it("is named where from a time on it closes all ways", async () => {
  const studio = await setting.settled({ query });
  await studio.page.getByLabel("File to open").setInputFiles(missionFile("quay", { zone: "keep_out", from: 10 }, [30, 10], [466, 105]));
  await studio.page.getByRole("heading", { name: /the zone quay stands in the way of the ground robot/ }).waitFor();
  await studio.page.screenshot({ path: join(process.env.SHOTS ?? setting.scratch, "barred.png") });
  await studio.page.getByRole("button", { name: "Remove zone 1" }).click();
  await studio.settled();
  expect(studio.faults).toEqual([]);
});
