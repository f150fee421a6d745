// A plan that was mailed: one file, opened from a disk, which plans by itself.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Plan } from "../../src/domain/plan";
import { command, data } from "../command";
import { launch, StudioPage } from "../studio_page";
import { plannerOption } from "./site";

const scratch = mkdtempSync(join(tmpdir(), "steerable-"));
const html = join(scratch, "plan.html");
const json = join(scratch, "plan.json");
const size = { width: 501, height: 501 };

let browser: Browser;

beforeAll(async () => {
  const mission = [join(data, "berlin-mitte.tif"), "--start", "485,101", "--goal", "425,488", "-n", "2"];
  const steerable = ["--html", html, "--steerable", ...plannerOption];
  execFileSync(command, ["plan", ...mission, ...steerable, "--json", json], { stdio: "ignore" });
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
  rmSync(scratch, { recursive: true });
});

it("plans its mission, and another one when the start is dragged, and asks nobody", async () => {
  const page = await StudioPage.visit(browser, pathToFileURL(html).href);
  await page.settled();
  const plan = JSON.parse(readFileSync(json, "utf8")) as Plan;
  const seconds = [plan.after.makespan!, plan.before.makespan!].map((cells) => cells * plan.map.cell_size!); // at 1 m/s
  const shown = await page.figures();
  shown.forEach((figure, i) => expect(figure).toBeCloseTo(seconds[i]!, 6));
  const [from, to] = [await page.place([485, 101], size), await page.place([462, 120], size)];
  await page.page.mouse.move(from.x, from.y);
  await page.page.mouse.down();
  await page.page.mouse.move(to.x, to.y, { steps: 10 });
  await page.page.mouse.up();
  await page.settled();
  const start = await page.cellOf("Ground start");
  expect(start).not.toEqual([485, 101]);
  const figures = await page.figures();
  expect(figures).not.toEqual(shown);
  expect(await page.accessibilityFaults()).toEqual([]);
  expect(page.faults).toEqual([]);
  // The address holds the mission.
  await page.page.waitForFunction(() => location.hash !== "");
  const again = await StudioPage.visit(browser, await page.page.evaluate(() => location.href));
  await again.settled();
  expect(await again.cellOf("Ground start")).toEqual(start);
  expect(await again.figures()).toEqual(figures);
  await Promise.all([page.close(), again.close()]);
});
