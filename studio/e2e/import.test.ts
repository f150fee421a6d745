// Map data that is dropped on the page becomes a map.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator } from "playwright-core";
import { afterEach, describe, expect, it } from "vitest";
import { Setting } from "./setting";
import { phone, StudioPage, wide } from "./studio_page";

const setting = new Setting("import");
const { scratch } = setting;

let studio: StudioPage | null = null;

afterEach(async () => {
  await studio?.close();
  studio = null;
});

async function visit(viewport = wide): Promise<StudioPage> {
  studio = await setting.visit({ viewport });
  await studio.settled();
  return studio;
}

// OpenStreetMap's XML of 6 x 6 houses, one of them a pond, and a lane between them.
function townFile(): string {
  const nodes: string[] = [];
  const ways: string[] = [];
  const way = (tags: Record<string, string>, points: [number, number][]) => {
    const first = nodes.length + 1;
    const refs = points.map(([x, y], i) => {
      if (i > 0 && `${points[i]}` === `${points[0]}`) return `<nd ref="${first}"/>`; // closed
      nodes.push(`<node id="${nodes.length + 1}" lon="${9 + x / 71_700}" lat="${50 + y / 111_200}"/>`);
      return `<nd ref="${nodes.length}"/>`;
    });
    const said = Object.entries(tags).map(([key, value]) => `<tag k="${key}" v="${value}"/>`);
    ways.push(`<way id="${1000 + ways.length}">${refs.join("")}${said.join("")}</way>`);
  };
  const area = (tags: Record<string, string>, x: number, y: number, side: number) =>
    way(tags, [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]);
  const pond = 14;
  for (let i = 0; i < 36; ++i) {
    area(i === pond ? { natural: "water", name: "Pond" } : { building: "yes" }, 50 * (i % 6), 50 * Math.floor(i / 6), 46);
  }
  way({ highway: "residential", name: "Long Lane" }, [[-2, 48], [300, 48]]);
  const file = join(scratch, "town.osm");
  writeFileSync(file, `<osm version="0.6">${nodes.join("")}${ways.join("")}</osm>`);
  return file;
}

describe("map data", () => {
  it("becomes a map, planned on at once, by the keyboard alone", async () => {
    const page = await visit();
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    const dialog = page.page.getByRole("dialog", { name: "Make a map from town.osm" });
    const window = dialog.getByRole("button", { name: /^Window of/ });
    await window.focus();
    const before = await dialog.getByLabel("Longitude").inputValue();
    await page.page.keyboard.press("-");
    await page.page.keyboard.press("ArrowRight");
    await expect.poll(() => dialog.getByLabel("Longitude").inputValue()).not.toBe(before);
    expect(await page.accessibilityFaults()).toEqual([]);
    await dialog.getByLabel("Size of a cell").fill("1.5");
    await dialog.getByRole("button", { name: "Import" }).focus();
    await page.page.keyboard.press("Enter");
    await dialog.waitFor({ state: "hidden" });
    await expect.poll(() => page.page.getByLabel("Choose a map").evaluate((one) => (one as HTMLSelectElement).selectedOptions[0]?.text)).toBe("town.tif");
    await page.settled();
    expect((await page.plan()).status).toBe("solved");
    await page.page.getByRole("button", { name: "Legend" }).click();
    expect(await page.page.getByRole("list", { name: "Legend of obstacles" }).innerText()).toBe("can be removed\nwater\nremoved in this plan");
    await page.page.getByRole("combobox", { name: "Find a street or obstacle" }).fill("lane");
    await page.page.getByRole("option", { name: /Long Lane/ }).waitFor();
    expect(page.faults).toEqual([]);
  });

  it("ends somewhere, and nobody drives beyond unless that is asked for", async () => {
    const page = await visit();
    const about = page.page.getByLabel("About this map");
    const importFrom = async (longitude: string, choose: (dialog: Locator) => Promise<unknown>) => {
      await page.page.getByLabel("File to open").setInputFiles(townFile());
      const dialog = page.page.getByRole("dialog");
      const beyond = dialog.getByRole("checkbox", { name: /reaches beyond the data/ });
      await dialog.getByLabel("Longitude").waitFor();
      expect(await beyond.count()).toBe(0);
      await dialog.getByLabel("Longitude").fill(longitude);
      await choose(dialog);
      await dialog.getByRole("button", { name: "Import" }).click();
      await dialog.waitFor({ state: "hidden" });
      await page.settled();
    };
    await importFrom("9.0035", (dialog) => dialog.getByRole("checkbox").waitFor());
    await about.getByText(/^\d+\.\d % of this map is unknown ground, without data: it bars the way\.$/).waitFor();
    expect(await page.accessibilityFaults()).toEqual([]);
    await page.page.getByRole("button", { name: "Legend" }).click();
    await page.page.getByRole("list", { name: "Legend of obstacles" }).getByText("unknown: no data").waitFor();
    await importFrom("9.0036", (dialog) => dialog.getByRole("checkbox").check());
    await about.getByText(/covers only \d+ % of the window; the rest is free/).waitFor();
    expect(await about.getByText("unknown").count()).toBe(0);
  });

  it("is chosen on a phone as well", async () => {
    const page = await visit(phone);
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    const dialog = page.page.getByRole("dialog");
    await dialog.getByRole("radio", { name: /^Truck/ }).check();
    await dialog.getByRole("radio", { name: "A whole building" }).check();
    const wider = await dialog.evaluate((one) => one.scrollWidth - one.clientWidth);
    expect(wider).toBe(0);
    await dialog.getByRole("button", { name: "Import" }).click();
    await dialog.waitFor({ state: "hidden" });
    await page.settled();
    expect(page.faults).toEqual([]);
  });

  it("of a closed area is laid over the map, by the keyboard alone, and undo takes it away", async () => {
    const page = await visit();
    const shown = () =>
      page.page.getByLabel("Choose a map").evaluate((one) => (one as HTMLSelectElement).selectedOptions[0]?.text);
    const former = await shown();
    const [west, east, south, north] = [13.53, 13.533, 52.428, 52.43];
    const ring = [[west, south], [east, south], [east, north], [west, north], [west, south]];
    const geometry = { type: "Polygon", coordinates: [ring] };
    const file = join(scratch, "closure.geojson");
    writeFileSync(file, JSON.stringify({ type: "Feature", properties: { name: "Closed for today" }, geometry }));
    await page.page.getByLabel("File to open").setInputFiles(file);
    const dialog = page.page.getByRole("dialog", { name: "Lay closure.geojson over the map" });
    await dialog.getByRole("radio", { name: /^Water/ }).focus();
    await page.page.keyboard.press("ArrowDown");
    await page.page.keyboard.press("ArrowDown");
    expect(await dialog.getByRole("radio", { name: /^Closed/ }).isChecked()).toBe(true);
    expect(await page.accessibilityFaults()).toEqual([]);
    await page.page.keyboard.press("Enter");
    await dialog.waitFor({ state: "hidden" });
    await expect.poll(shown).toBe("closure.tif");
    await page.settled();
    await page.page.getByRole("combobox", { name: "Find a street or obstacle" }).fill("closed for");
    await page.page.getByRole("option", { name: /Closed for today/ }).waitFor();
    await page.page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(shown).toBe(former);
    expect(page.faults).toEqual([]);
  });

  it("says why a file is none, and can be left", async () => {
    const page = await visit();
    const file = join(scratch, "empty.osm");
    writeFileSync(file, '<osm version="0.6"></osm>');
    await page.page.getByLabel("File to open").setInputFiles(file);
    const dialog = page.page.getByRole("dialog");
    await dialog.getByRole("alert").getByText(/buildings/).waitFor();
    await page.page.keyboard.press("Escape");
    await dialog.waitFor({ state: "hidden" });
  });

  it("whose coordinates are none is refused, and the next file is opened", async () => {
    const page = await visit();
    const file = join(scratch, "far.geojson");
    const farAway = /Its coordinates are not longitude and latitude/;
    for (const [far, refusal] of [["1e308", farAway], ["1e400", /no buildings/], ["392000", farAway]] as const) {
      const ring = `[[${far}, 1], [-${far}, 2], [3, 3], [${far}, 1]]`;
      const geometry = `{"type": "Polygon", "coordinates": [${ring}]}`;
      writeFileSync(file, `{"type": "Feature", "properties": {"building": "yes"}, "geometry": ${geometry}}`);
      await page.page.getByLabel("File to open").setInputFiles(file);
      const dialog = page.page.getByRole("dialog");
      await dialog.getByRole("alert").getByText(refusal).waitFor();
      await page.page.keyboard.press("Escape");
      await dialog.waitFor({ state: "hidden" });
    }
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    await page.page.getByRole("dialog", { name: "Make a map from town.osm" }).getByText("35 buildings").waitFor();
  });

  it("that the page cannot show leaves the page alive", async () => {
    const page = await visit();
    const broken = { id: "source-1", name: "x", bytes: 1, bounds: [1, 1, 2, 2], buildings: null, columns: 1, rows: 1, built: [1] };
    const answer = { ...broken, densest: { center: [1.5, 1.5], size: 100 }, places: [] };
    await page.page.route("**/api/v1/sources*", (route) => route.fulfill({ json: answer }), { times: 1 });
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    const dialog = page.page.getByRole("dialog");
    await dialog.getByRole("alert").getByText("What the server says of this file cannot be shown.").waitFor();
    await dialog.getByRole("button", { name: "Cancel" }).click();
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    await dialog.getByText("35 buildings").waitFor();
  });

  it("is not imported while a number is wrong", async () => {
    const page = await visit();
    await page.page.getByLabel("File to open").setInputFiles(townFile());
    const dialog = page.page.getByRole("dialog");
    const side = dialog.getByLabel("Side");
    await side.fill("1e9");
    await dialog.getByText(/^Give 10 to \d+ m\. Until then it stays/).waitFor();
    await dialog.getByRole("button", { name: "Import" }).click();
    expect(await side.evaluate((one) => one === document.activeElement)).toBe(true);
    await side.fill("100,5");
    await dialog.getByRole("button", { name: "Import" }).click();
    await dialog.waitFor({ state: "hidden" });
    await page.settled();
  });
});
