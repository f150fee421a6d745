// usage: node bench/site_drag.mjs SITE [MAP START GOAL]
//
// How soon plans follow a marker that is dragged on a page without a server: SITE is what `waybreaker site` wrote.
// Chromium drags the start by hand's pace, three times. Says the time from a move of the mouse to the plan for that
// place on the screen, plans a second, and how soon the first plan was there, with a warm cache. CHROMIUM names another
// browser.
import { createReadStream, existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";
import { createServer as createVite } from "vite";

const [site, map = "berlin-mitte.tif", start = "485,101", goal = "425,488"] = process.argv.slice(2);
const view = { width: 1400, height: 900 };
const [turns, moves, pace] = [3, 120, 8]; // ms
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm" };

const vite = await createVite({ root: new URL("..", import.meta.url).pathname, logLevel: "warn", server: { middlewareMode: true } });
const { toScreen, wholeMap } = await vite.ssrLoadModule("/src/map/viewport/camera.ts");
const host = createServer((request, response) => {
  const file = join(site, new URL(request.url, "http://localhost").pathname.replace(/\/$/, "/index.html"));
  if (!existsSync(file)) return response.writeHead(404).end();
  response.writeHead(200, { "Content-Type": types[extname(file)] ?? "application/octet-stream" });
  createReadStream(file).pipe(response);
});
await new Promise((ready) => host.listen(0, "127.0.0.1", ready));
const url = `http://127.0.0.1:${host.address().port}/`;
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
try {
  await measure();
} finally {
  await browser.close();
  host.close();
  await vite.close();
}

async function measure() {
  const { description: size } = JSON.parse(readFileSync(join(site, "maps", `${map}.json`), "utf8"));
  const context = await browser.newContext({ viewport: view });
  const page = await context.newPage();
  await page.addInitScript(note);
  const address = `${url}?map=${map}&start=${start}&goal=${goal}&removals=2&show=after`;
  await page.goto(address);
  await page.getByText("Checked independently").waitFor({ timeout: 120_000 });
  await page.reload();
  await page.getByText("Checked independently").waitFor({ timeout: 120_000 });
  const [first] = await page.evaluate(() => window.drawn);
  const box = await page.getByRole("application").boundingBox();
  const waits = [];
  let seconds = 0;
  for (let turn = 0; turn < turns; ++turn) {
    const [x, y] = toScreen(wholeMap(size, box), box, await cellOf(page));
    await page.mouse.move(box.x + x, box.y + y);
    await page.mouse.down();
    await page.evaluate(() => (window.drawn = []));
    const began = performance.now();
    for (let i = 1; i <= moves; ++i) {
      await page.mouse.move(box.x + x - (turn % 2 ? -i : i) / 2, box.y + y + (turn % 2 ? -i : i) / 3);
      await page.waitForTimeout(pace);
    }
    seconds += (performance.now() - began) / 1000;
    waits.push(...(await page.evaluate(() => window.drawn)).map(({ after }) => after));
    await page.mouse.up();
    await page.waitForTimeout(1500);
  }
  waits.sort((a, b) => a - b);
  const at = (share) => waits[Math.min(waits.length - 1, Math.floor(share * waits.length))].toFixed(1);
  console.log(`${map}: first plan ${first.at.toFixed(0)} ms after opening`);
  console.log(`move to drawn plan: median ${at(0.5)} ms, 95 % within ${at(0.95)} ms; ${(waits.length / seconds).toFixed(0)} plans a second`);
}

async function cellOf(page) {
  const label = await page.getByRole("button", { name: /^Ground start, column/ }).getAttribute("aria-label");
  return /column (\d+), row (\d+)/.exec(label).slice(1).map(Number);
}

// In the page: when each plan with removals has been drawn, and how long after the move that asked for it.
function note() {
  window.drawn = [];
  let moved = 0;
  addEventListener("pointermove", ({ timeStamp }) => (moved = timeStamp), true);
  window.Worker = class extends Worker {
    #asked = null;
    constructor(...parameters) {
      super(...parameters);
      this.addEventListener("message", ({ data }) => {
        const asked = this.#asked;
        if (data.kind === "progress" || asked === null) return;
        this.#asked = null;
        requestAnimationFrame(() => setTimeout(() => window.drawn.push({ at: performance.now(), after: performance.now() - asked })));
      });
    }
    postMessage(message) {
      const removals = message.what === "plan" && JSON.parse(message.request).options.removals;
      this.#asked = removals > 0 ? moved : null;
      super.postMessage(message);
    }
  };
}
