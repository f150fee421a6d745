// Bands of time: by when the ground is reached, of missions of many places.
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { Bands, type ReachDocument } from "../src/domain/bands";
import type { Cell } from "../src/domain/geometry";
import type { Plan } from "../src/domain/plan";
import { toScreen, wholeMap } from "../src/map/viewport/camera";
import { type BandColours, dark, light } from "../src/map/viewport/theme";
import { bandsHere } from "../src/mission/band_words";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, type StudioPage } from "./studio_page";

const city = join(data, "berlin-mitte.tif");
const query = "?map=berlin-mitte.tif";
const setting = new Setting("bands");
const hospital: Cell = [100, 55];
const place = (id: string, goal: Cell, speed = 1) => ({ id, kind: "ground", start: hospital, goal, speed });
const mission = {
  format: "waybreaker-mission/1",
  time_unit: "s",
  agents: [
    place("school", [481, 440]),
    place("mill", [348, 47]),
    { id: "air", kind: "air", start: hospital, goal: hospital, weight: 0 },
  ],
  rules: { removals: 1, objective: "flowtime", collisions: false, unreached: 620 },
};

function written(name: string, asked: unknown = mission): string {
  const file = join(setting.scratch, name);
  writeFileSync(file, JSON.stringify(asked));
  return file;
}

async function opened(options: Parameters<Setting["settled"]>[0] = {}): Promise<StudioPage> {
  const studio = await setting.settled({ query, ...options });
  await studio.page.getByLabel("File to open").setInputFiles(written("places.json"));
  await studio.result().getByText("1 of 2 places are reached, 1 of them sooner. Not reached: school.").first().waitFor();
  await studio.settled();
  await upToDate(studio);
  return studio;
}

const list = ({ page }: StudioPage) => page.getByRole("list", { name: /^Bands of time/ });
const upToDate = ({ page }: StudioPage) => page.locator('.bands[aria-busy="false"]').waitFor();
const layer = ({ page }: StudioPage) => page.getByRole("checkbox", { name: /^Bands of time/ });
const texts = async (studio: StudioPage) => (await list(studio).locator("li").allTextContents()).map((text) => text.replaceAll("\u00a0", " "));

async function bandsOf(plan: Plan): Promise<Bands> {
  const address = `${setting.server.url}/api/v1/maps/berlin-mitte.tif/export?format=reach`;
  const answer = await fetch(address, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(plan) });
  return Bands.of((await answer.json()) as ReachDocument)!;
}

// Cells amid others that show the same.
function evenCells({ width, height, after, gains }: Bands): { cell: Cell; band: number; gained: number }[] {
  const reach = 4;
  const cells: ReturnType<typeof evenCells> = [];
  for (let y = reach; y < height - reach; y += 3) {
    for (let x = reach; x < width - reach; x += 3) {
      const [band, gained] = [after[y * width + x]!, gains[y * width + x]!];
      const around = Array.from({ length: (2 * reach + 1) ** 2 }, (_, i) => (y - reach + Math.floor(i / 9)) * width + x - reach + (i % 9));
      if (band !== 0 && around.every((i) => after[i] === band && gains[i] === gained)) cells.push({ cell: [x, y], band, gained });
    }
  }
  return cells;
}

// The colours of pixels around cells while all of the map is shown.
async function coloursAround(studio: StudioPage, cells: readonly Cell[], map: Bands, by: number): Promise<string[][]> {
  const box = (await studio.map().boundingBox())!;
  const camera = wholeMap(map, box);
  const places = cells.map((cell) => toScreen(camera, box, cell));
  return studio.map().evaluate(
    (canvas, [points, reach]) => {
      const { width, height } = canvas as HTMLCanvasElement;
      const { data } = (canvas as HTMLCanvasElement).getContext("2d")!.getImageData(0, 0, width, height);
      const hex = (k: number) => `#${((data[k]! << 16) | (data[k + 1]! << 8) | data[k + 2]!).toString(16).padStart(6, "0")}`;
      const side = 2 * reach + 1;
      return points.map(([x, y]) => {
        const first = (Math.round(y!) - reach) * width + Math.round(x!) - reach;
        return Array.from({ length: side * side }, (_, k) => hex(4 * (first + Math.floor(k / side) * width + (k % side))));
      });
    },
    [places, by] as const,
  );
}

// Which share of the cells amid a band has its colour; the rest lies under paths, names and markers.
async function shown(studio: StudioPage, bands: Bands, colours: BandColours): Promise<number> {
  const cells = evenCells(bands).filter(({ band, gained }) => band <= bands.ends.length && gained === 0);
  expect(new Set(cells.map(({ band }) => band)).size).toBeGreaterThan(2);
  const seen = await coloursAround(studio, cells.map(({ cell }) => cell), bands, 0);
  return seen.filter(([colour], i) => colour === colours.bands[cells[i]!.band - 1]).length / cells.length;
}

const reddish = (colour: string) => parseInt(colour.slice(1, 3), 16) > parseInt(colour.slice(3, 5), 16) + 60;

it("are on the map as in the picture of the command, hatched where ground is reached sooner, and told in a list", async () => {
  const studio = await opened();
  const { page } = studio;
  const bands = await bandsOf(await studio.plan());
  await expect.poll(() => shown(studio, bands, light.reach)).toBeGreaterThan(0.8);
  const gained = evenCells(bands).filter((one) => one.gained > 0).map(({ cell }) => cell);
  expect(gained.length).toBeGreaterThan(100);
  const hatched = (await coloursAround(studio, gained, bands, 9)).filter((around) => around.some(reddish));
  expect(hatched.length).toBeGreaterThan(0.95 * gained.length);

  const picture = execFileSync(command, ["plan", city, "--mission", written("same.json"), "--svg", "-"], { encoding: "utf8" });
  const pictured = [...picture.matchAll(/reached by (\d+) s</g)].map(([, seconds]) => Number(seconds));
  expect(pictured).toEqual(bands.ends);
  const said = await texts(studio);
  expect(said.filter((text) => text.startsWith("reached by")).map((text) => secondsIn(text))).toEqual(pictured);
  expect(said.filter((text) => !text.startsWith("reached by ")).join()).toMatch(/not reached.*15 s or more sooner/);
  expect(await studio.accessibilityFaults()).toEqual([]);

  // What is under the pointer, and what is chosen.
  const cell = evenCells(bands).find((one) => one.band === 1 && Math.hypot(one.cell[0] - 60, one.cell[1] - 30) > 30)!.cell;
  const { x, y } = await studio.place(cell, bands);
  await page.mouse.move(x, y);
  await page.locator(".band-strip").getByText(/^Here by /).waitFor();
  const told = page.locator(".band-strip [aria-live]");
  expect(await told.textContent()).toBe(""); // a screen reader is not told of each move
  await page.mouse.click(x, y); // as Enter does in the middle
  const units = { metric: true, cell: 2.4, time: "seconds", seconds: 1 } as const;
  await expect.poll(() => told.textContent()).toBe(bandsHere(bands, cell, units));

  // By keys, and in the link.
  await layer(studio).focus();
  await page.keyboard.press("Space");
  await expect.poll(() => shown(studio, bands, light.reach)).toBeLessThan(0.05);
  expect([await list(studio).count(), await page.locator(".band-strip").count()]).toEqual([0, 0]);
  await expect.poll(() => page.url()).toContain("bands=false");
  const again = await setting.settled({}, page.url());
  expect(await layer(again).isChecked()).toBe(false);
  expect(await list(again).count()).toBe(0);
  await layer(again).focus();
  await again.page.keyboard.press("Space");
  await list(again).waitFor();
  await expect.poll(() => shown(again, bands, light.reach)).toBeGreaterThan(0.8);
  expect([...studio.faults, ...again.faults]).toEqual([]);
});

function secondsIn(text: string): number {
  const part = (unit: string) => Number(new RegExp(`(\\d+) ${unit}\\b`).exec(text)?.[1] ?? 0);
  return 60 * part("min") + part("s");
}

it("follow the plan, and are none where vehicles are not alike", async () => {
  const studio = await opened();
  const { page } = studio;
  const before = await texts(studio);
  await studio.marker("Start of school").focus();
  await page.keyboard.press("Shift+ArrowDown");
  await layer(studio).waitFor({ state: "detached" }); // there are as many starts as goals
  await page.keyboard.press("Control+z");
  await studio.settled();
  await upToDate(studio);
  await expect.poll(() => texts(studio)).toEqual(before);
  await studio.marker("Goal of mill").focus();
  await page.keyboard.press("Shift+ArrowDown");
  await studio.settled();
  await upToDate(studio);
  expect((await texts(studio)).length).toBeGreaterThan(3);
  const slow = { ...mission, agents: [...mission.agents, place("yard", [301, 119], 0.3)] };
  await page.getByLabel("File to open").setInputFiles(written("slow.json", slow));
  await studio.result().getByText(/of 3 places are reached/).first().waitFor();
  await studio.settled();
  await layer(studio).waitFor({ state: "detached" });
  expect(studio.faults).toEqual([]);
});

it("are readable on a phone, in the dark", async () => {
  const studio = await opened({ viewport: phone, colorScheme: "dark" });
  const { page } = studio;
  const bands = await bandsOf(await studio.plan());
  await expect.poll(() => shown(studio, bands, dark.reach)).toBeGreaterThan(0.4); // a small map beneath large markers
  expect(await studio.cutOff(".panel *, .map-box *")).toEqual([]);
  expect(await studio.accessibilityFaults()).toEqual([]);
  await page.getByRole("button", { name: "Legend" }).click();
  await page.locator(".band-strip").getByText("Ground by when it is reached").waitFor();
  await page.getByRole("list", { name: "Legend of the map" }).getByText(/or more sooner/).waitFor();
  expect(await studio.cutOff(".map-box *")).toEqual([]);
  expect(await studio.accessibilityFaults()).toEqual([]);
  expect(studio.faults).toEqual([]);
});

it("are on the page of a single plan, which has no server", async () => {
  const file = join(setting.scratch, "plan.html");
  execFileSync(command, ["plan", city, "--mission", written("places.json"), "--html", file]);
  const viewer = await setting.visit({}, `file://${file}`);
  await list(viewer).waitFor();
  await layer(viewer).focus();
  await viewer.page.keyboard.press("Space");
  await list(viewer).waitFor({ state: "detached" });
  expect(await viewer.accessibilityFaults()).toEqual([]);
  expect(viewer.faults).toEqual([]);
  await viewer.close();
});
