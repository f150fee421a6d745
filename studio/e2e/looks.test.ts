// How the page looks where readers and machines differ: light and dark, small windows, the pointer over it, on paper, in
// colours of the reader's own.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, expect, it } from "vitest";
import { Setting } from "./setting";
import { phone, StudioPage, wide } from "./studio_page";

const setting = new Setting("looks");
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

const overflow = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

for (const viewport of [wide, phone]) {
  for (const colorScheme of ["light", "dark"] as const) {
    it(`is accessible and fits at ${viewport.width} px, ${colorScheme}`, async () => {
      const page = await visit({ viewport, colorScheme });
      expect(await page.accessibilityFaults()).toEqual([]);
      expect(await overflow(page.page)).toBeLessThanOrEqual(0);
    });
  }
}

for (const colorScheme of ["light", "dark"] as const) {
  it(`can be read beneath the pointer and with the keyboard, ${colorScheme}`, async () => {
    const { page } = await visit({ colorScheme });
    await page.getByText("Mission settings").click();
    expect(await studio!.faultsWhenHovered("body")).toEqual([]);
    expect(await studio!.unseenFocus("main")).toEqual([]);
    await page.getByRole("button", { name: "Help" }).click();
    expect(await studio!.faultsWhenHovered("dialog[open]")).toEqual([]);
  });
}

it("has room for the table of what is removed at 320 px", async () => {
  const { page } = await visit({ viewport: { width: 320, height: 640 } });
  const wider = (table: Element) => table.scrollWidth - table.parentElement!.clientWidth;
  expect(await page.locator(".removed-table").evaluate(wider)).toBeLessThanOrEqual(0);
});

// What is left of 1280 x 1024 when it is enlarged, and of a laptop's window.
for (const [zoom, viewport] of [["400 %", { width: 320, height: 256 }], ["200 %", { width: 700, height: 430 }]] as const) {
  it(`has a map and all its buttons at ${zoom}`, async () => {
    const { page } = await visit({ viewport });
    const map = (await page.getByRole("application").boundingBox())!;
    expect(map.height).toBeGreaterThan(150);
    expect(map.width).toBeGreaterThan(300);
    expect(await overflow(page)).toBeLessThanOrEqual(0);
    expect(await studio!.cutOff("button, select, summary, input, h1")).toEqual([]);
    expect(await studio!.accessibilityFaults()).toEqual([]);
  });
}

it("has no black map while it loads", async () => {
  studio = await setting.visit({}, "about:blank");
  const { page } = studio;
  await page.route("**/obstacles*", () => undefined); // never comes
  await page.goto(`${setting.server.url}/`);
  await page.getByText("Loading the map…").waitFor();
  await expect.poll(() => studio!.colourAt(0.5, 0.5)).toEqual([0xef, 0xec, 0xe6]);
  await page.emulateMedia({ colorScheme: "dark" });
  await expect.poll(() => studio!.colourAt(0.5, 0.5)).toEqual([0x10, 0x12, 0x14]);
});

it("is printed in light colours, with its whole curve, the date and the link", async () => {
  const { page } = await visit({ colorScheme: "dark" });
  await page.getByText("One removal more").waitFor(); // the last to come
  const onScreen = await studio!.colourAt(0.01, 0.01);
  const tell = (event: string) => page.evaluate((name) => void dispatchEvent(new Event(name)), event);
  await tell("beforeprint"); // what follows it is printed: there is no frame more
  expect(await studio!.colourAt(0.01, 0.01)).toEqual([0xef, 0xec, 0xe6]);
  await page.getByText(/^Printed on \d+ \w+ \d{4}/).waitFor();
  await page.getByRole("link", { name: /#map=berlin-adlershof\.tif/ }).waitFor();
  expect(await page.locator(".front-column").count()).toBe(9);
  await tell("afterprint");
  expect(await studio!.colourAt(0.01, 0.01)).toEqual(onScreen);
  expect(await page.getByText(/^Printed on/).count()).toBe(0);
  await page.emulateMedia({ media: "print" });
  expect(await page.evaluate(() => getComputedStyle(document.querySelector(".badge")!).printColorAdjust)).toBe("exact");
  await page.emulateMedia({ media: null });
  for (const landscape of [false, true]) {
    const pdf = await page.pdf({ format: "A4", landscape, printBackground: false });
    expect(pdf.toString("latin1").match(/\/Type\s*\/Page\b/g)).toHaveLength(1);
  }
});

it("shows tracks and choices in colours of the reader's own", async () => {
  const { page } = await visit();
  await page.emulateMedia({ forcedColors: "active" });
  const chosen = page.locator(".segments input:checked + span").first();
  expect(await chosen.evaluate((one) => getComputedStyle(one).outlineStyle)).toBe("solid");
  expect(await studio!.accessibilityFaults()).toEqual([]);
});

it("keeps names in their place, whatever is in them", async () => {
  const { page } = await visit();
  const agents = [
    { id: "x".repeat(100), kind: "ground", start: [130, 104], goal: [466, 105] },
    { id: "רכב 12", kind: "ground", start: [319, 410], goal: [72, 474] },
    { id: "<b>bold</b>".repeat(9), kind: "air", start: [130, 104], goal: [130, 104], speed: 5 },
  ];
  const file = join(scratch, "names.json");
  writeFileSync(file, JSON.stringify({ format: "waybreaker-mission/1", agents, rules: { removals: 2 } }));
  await page.getByLabel("File to open").setInputFiles(file);
  const name = page.locator(".agent-name .name").nth(1);
  await expect.poll(() => name.innerText()).toBe("רכב 12");
  expect(await name.evaluate((one) => one.tagName)).toBe("BDI");
  await page.locator(".removed-table").waitFor();
  expect(await studio!.cutOff(".agent-table, .removed-table, .agent-table td, .removed-table td")).toEqual([]);
  expect(await overflow(page)).toBeLessThanOrEqual(0);
  expect(studio!.faults).toEqual([]);
});
