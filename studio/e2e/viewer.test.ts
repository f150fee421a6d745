// The page that `waybreaker plan --html` writes: without a server, from a file.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import type { Plan } from "../src/domain/plan";
import { command, data } from "./command";
import { launch, phone, StudioPage, wide } from "./studio_page";

const scratch = mkdtempSync(join(tmpdir(), "viewer-"));
const html = join(scratch, "plan.html");
const json = join(scratch, "plan.json");

let browser: Browser;

beforeAll(async () => {
  const mission = [join(data, "berlin-adlershof.tif"), "--start", "130,104", "--goal", "466,105", "-n", "2"];
  execFileSync(command, ["plan", ...mission, "--html", html, "--json", json], { stdio: "ignore" });
  browser = await launch();
});
afterAll(async () => {
  await browser.close();
  rmSync(scratch, { recursive: true });
});

for (const viewport of [wide, phone]) {
  it(`shows the plan, plays it and asks nobody, at ${viewport.width} px`, async () => {
    const viewer = await StudioPage.visit(browser, pathToFileURL(html).href, { viewport });
    const plan = JSON.parse(readFileSync(json, "utf8")) as Plan;
    await viewer.result().getByText(/8\.7\s% sooner/).first().waitFor();
    expect(await viewer.figures()).toEqual([plan.after.makespan, plan.before.makespan]);
    await viewer.result().getByText("Checked independently").waitFor();
    expect(await viewer.result().locator(".figure").innerText()).toMatch(/^\d+\smin/); // a time, not a length
    await viewer.page.getByRole("table", { name: /Removed obstacles/ }).waitFor();
    await viewer.page.getByRole("group", { name: "What each number of removals reaches" }).waitFor();
    await viewer.page.getByRole("button", { name: "Play", exact: true }).click();
    const time = viewer.page.getByRole("slider", { name: "Time of the mission" });
    await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(5);
    expect(await viewer.accessibilityFaults()).toEqual([]);
    expect(viewer.faults).toEqual([]);
    await viewer.close();
  });
}

it("shows the plan where no script runs", async () => {
  const context = await browser.newContext({ javaScriptEnabled: false, viewport: phone });
  const page = await context.newPage();
  await page.goto(pathToFileURL(html).href);
  await page.getByRole("heading", { name: /^Plan: / }).waitFor();
  await page.getByText(/^Makespan .* 2 openings/).first().waitFor();
  const picture = (await page.locator("noscript svg").boundingBox())!;
  expect(picture.height).toBeGreaterThan(200);
  expect(picture.x + picture.width).toBeLessThanOrEqual(phone.width);
  await context.close();
});
