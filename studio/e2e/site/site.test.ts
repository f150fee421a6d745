// The page without a server, from a plain host of files.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Plan } from "../../src/domain/plan";
import { command, data } from "../command";
import { FileServer, siteIn } from "./site";
import { launch, StudioPage } from "../studio_page";

const scratch = mkdtempSync(join(tmpdir(), "site-"));
const city = join(data, "berlin-mitte.tif");
const size = { width: 501, height: 501 };
const query = "?map=berlin-mitte.tif&start=485,101&goal=425,488&removals=2";

let folder: string;
let browser: Browser;
let host: FileServer;

beforeAll(async () => {
  folder = siteIn(scratch);
  [host, browser] = await Promise.all([FileServer.start(folder), launch()]);
});
afterAll(async () => {
  await browser.close();
  await host.stop();
  rmSync(scratch, { recursive: true });
});

async function opened(asked = query): Promise<StudioPage> {
  const page = await StudioPage.visit(browser, host.url, { query: asked });
  await page.settled();
  return page;
}

async function downloaded(page: Page, button: string): Promise<string> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: button, exact: true }).click()]);
  return readFileSync(await download.path(), "utf8");
}

// Of the plan that is shown.
async function planOf(page: StudioPage): Promise<Plan> {
  return JSON.parse(await downloaded(page.page, "Plan (JSON)")) as Plan;
}

function commandAccepts(plan: Plan): string {
  return execFileSync(command, ["check", city, "-"], { input: JSON.stringify(plan), encoding: "utf8" });
}

// The files that the browser keeps.
function kept(page: StudioPage): Promise<string[]> {
  return page.page.evaluate(async () => {
    const caches = await Promise.all((await window.caches.keys()).map((name) => window.caches.open(name)));
    return (await Promise.all(caches.map((cache) => cache.keys()))).flat().map(({ url }) => url);
  });
}

describe("a site", () => {
  it("has bands of time, as a server has", async () => {
    const places = "100,55,481,440,2.4,,,school~100,55,348,47,2.4,,,mill";
    const rules = "removals=1&objective=flowtime&collisions=false&unreached=620";
    const page = await opened(`?map=berlin-mitte.tif&vehicles=${places}&aircraft=,,100,55,2.4,,air,,,,0&${rules}`);
    const list = page.page.locator('.bands[aria-busy="false"]').getByRole("list", { name: /^Bands of time/ });
    await list.getByText(/^reached by 12\smin 30\ss/).waitFor();
    await list.getByText(/^15\ss or more sooner/).waitFor();
    expect(page.faults).toEqual([]);
    await page.close();
  });

  it("plans in the page, and the command accepts the plan", async () => {
    const page = await opened();
    const plan = await planOf(page);
    expect(plan.removed.length).toBe(2);
    expect(await page.figures()).toEqual([plan.after.makespan, plan.before.makespan]);
    expect(commandAccepts(plan)).toContain("valid");
    expect(page.faults).toEqual([]);
    await page.close();
  });

  it("plans to the byte what the command plans", async () => {
    const page = await opened();
    const mission = await downloaded(page.page, "Mission");
    const text = await page.page.evaluate(async (asked) => {
      const worker = new Worker("worker.js", { type: "module" });
      const answer = (message: unknown) =>
        new Promise<string>((done) => {
          worker.onmessage = ({ data: { kind, text, reason } }) => (kind === "progress" ? null : done(text ?? reason));
          worker.postMessage(message);
        });
      worker.postMessage(await WebAssembly.compile(await (await fetch("studio.wasm")).arrayBuffer()));
      const document = await (await fetch("maps/berlin-mitte.tif.json")).text();
      await answer({ what: "open", map: "m", document });
      const request = JSON.stringify({ mission: JSON.parse(asked), no_timing: true });
      return answer({ what: "plan", map: "m", request });
    }, mission);
    const commands = execFileSync(command, ["plan", city, "--mission", "-", "--no-timing", "--json", "-"], {
      input: mission,
      encoding: "utf8",
    });
    expect(text).toBe(commands);
    await page.close();
  });

  it("follows a marker that is dragged", async () => {
    const page = await opened();
    const from = await page.cellOf("Ground start");
    const grip = await page.place(from, size);
    await page.page.mouse.move(grip.x, grip.y);
    await page.page.mouse.down();
    for (let step = 1; step <= 10; ++step) await page.page.mouse.move(grip.x - 3 * step, grip.y + 2 * step);
    await page.page.mouse.up();
    await page.settled();
    const to = await page.cellOf("Ground start");
    expect(to).not.toEqual(from);
    const plan = await planOf(page);
    expect(plan.agents[0]!.start).toEqual(to);
    expect(commandAccepts(plan)).toContain("valid");
    expect(page.faults).toEqual([]);
    await page.close();
  });

  it("plans a team", async () => {
    const page = await opened();
    await page.page.getByRole("button", { name: "Add vehicle" }).click();
    await page.settled();
    const plan = await planOf(page);
    expect(plan.agents.filter(({ kind }) => kind === "ground")).toHaveLength(2);
    expect(commandAccepts(plan)).toContain("valid");
    await page.close();
  });

  it("opens a mission by its link", async () => {
    const page = await opened();
    await page.page.waitForFunction(() => location.hash !== "");
    const link = await page.page.evaluate(() => location.href);
    expect(link.startsWith(`${host.url}#`)).toBe(true);
    const other = await StudioPage.visit(browser, link);
    await other.settled();
    expect(await other.cellOf("Ground start")).toEqual([485, 101]);
    expect(await other.figures()).toEqual(await page.figures());
    await other.close();
    await page.close();
  });

  it("draws on a map, and says what needs the service", async () => {
    const page = await opened();
    expect(await page.page.getByRole("button", { name: "Map file" }).isVisible()).toBe(true);
    expect(await page.page.getByRole("button", { name: "Page (HTML)" }).count()).toBe(0);
    await page.page.getByText("This page plans by itself, without a server.").waitFor();
    await page.page.getByLabel("File to open").setInputFiles({
      name: "town.geojson",
      mimeType: "application/json",
      buffer: Buffer.from('{"type":"FeatureCollection","features":[]}'),
    });
    await page.page.getByText("is map data, which “waybreaker serve” takes").waitFor();
    await page.close();
  });

  it("works without a network after the first visit", async () => {
    const page = await opened();
    await expect.poll(() => kept(page)).toContain(`${host.url}maps/berlin-mitte.tif.json`);
    const figures = await page.figures();
    await page.page.context().setOffline(true);
    await host.stop();
    try {
      await page.page.reload();
      await page.settled();
      expect(await page.figures()).toEqual(figures);
    } finally {
      await page.close();
      host = await FileServer.start(folder);
    }
  });
});
