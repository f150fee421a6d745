// usage: node bench/site_drag.mjs SITE[,SITE...] [MAP START GOAL [LAYERS]]
//
// How soon plans follow a marker that is dragged on a page without a server: SITE is what `waybreaker site` wrote.
// Chromium drags the start by hand's pace, three times. Says the time from a move of the mouse to the plan for that
// place on the screen, be it a draft or not, plans a second, and how soon the first plan was there, with a warm cache.
// Several sites take turns, so that other work on the machine slows all of them. LAYERS is what the map shows:
// "after", or "before,after" as the page does by itself. CHROMIUM names another browser.
import { createReadStream, existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";
import { createServer as createVite } from "vite";

const [sites, map = "berlin-mitte.tif", start = "485,101", goal = "425,488", layers = "after"] = process.argv.slice(2);
const view = { width: 1400, height: 900 };
const [turns, moves, pace] = [3, 120, 8]; // ms
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm" };

const vite = await createVite({ root: new URL("..", import.meta.url).pathname, logLevel: "warn", server: { middlewareMode: true } });
const { toScreen, wholeMap } = await vite.ssrLoadModule("/src/map/viewport/camera.ts");
const results = sites.split(",").map((site) => ({ site, firsts: [], waits: [], seconds: 0 }));
let site;
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
  for (let turn = 0; turn < turns; ++turn) for (const result of results) await measure(result, turn);
} finally {
  await browser.close();
  host.close();
  await vite.close();
}
for (const { site, firsts, waits, seconds } of results) {
  const at = (share, of = waits) => of.sort((a, b) => a - b)[Math.min(of.length - 1, Math.floor(share * of.length))].toFixed(1);
  console.log(`${site}, ${map}: first plan ${at(0.5, firsts)} ms after opening`);
  console.log(`move to drawn plan: median ${at(0.5)} ms, 95 % within ${at(0.95)} ms; ${(waits.length / seconds).toFixed(0)} plans a second`);
}

async function measure(result, turn) {
  ({ site } = result);
  const { description: size } = JSON.parse(readFileSync(join(site, "maps", `${map}.json`), "utf8"));
  const context = await browser.newContext({ viewport: view });
  const page = await context.newPage();
  await page.addInitScript(note);
  await page.goto(`${url}?map=${map}&start=${start}&goal=${goal}&removals=2&show=${layers}`);
  await page.getByText("Checked independently").waitFor({ timeout: 120_000 });
  await page.reload();
  await page.getByText("Checked independently").waitFor({ timeout: 120_000 });
  result.firsts.push((await page.evaluate(() => window.drawn))[0].at);
  const box = await page.getByRole("application").boundingBox();
  for (let i = 0; i < 2; ++i) await drag(page, box, size, (turn + i) % 2 ? -1 : 1, i === 0 ? null : result);
  await context.close();
}

// The first drag on a page is for the browser's compiler.
async function drag(page, box, size, way, result) {
  const [x, y] = toScreen(wholeMap(size, box), box, await cellOf(page));
  await page.mouse.move(box.x + x, box.y + y);
  await page.mouse.down();
  await page.evaluate(() => (window.drawn = []));
  const began = performance.now();
  for (let i = 1; i <= moves; ++i) {
    await page.mouse.move(box.x + x + (way * i) / 2, box.y + y - (way * i) / 3);
    await page.waitForTimeout(pace);
  }
  if (result) result.seconds += (performance.now() - began) / 1000;
  if (result) result.waits.push(...(await page.evaluate(() => window.drawn)).map(({ after }) => after));
  await page.mouse.up();
  await page.waitForTimeout(1500);
}

async function cellOf(page) {
  const label = await page.getByRole("button", { name: /^Ground start, column/ }).getAttribute("aria-label");
  return /column (\d+), row (\d+)/.exec(label).slice(1).map(Number);
}

// In the page: when each plan is on the screen, and how long after the move that asked for it. What the headline says tells
// which plan is shown.
function note() {
  window.drawn = [];
  const asked = new Map(); // by what the plan reaches
  let moved = 0;
  for (const type of ["pointermove", "pointerrawupdate"]) addEventListener(type, ({ timeStamp }) => (moved = timeStamp), true);
  window.Worker = class extends Worker {
    #move = 0;
    constructor(...parameters) {
      super(...parameters);
      this.addEventListener("message", ({ data }) => {
        const value = data.kind === "answer" && this.#move !== null && JSON.parse(data.text).after.makespan;
        if (value) asked.set(String(value), this.#move);
      });
    }
    postMessage(message) {
      this.#move = message.what === "plan" && JSON.parse(message.request).options.removals > 0 ? moved : null;
      super.postMessage(message);
    }
  };
  let shown;
  new MutationObserver(() => {
    const value = document.querySelector(".headline .figure")?.getAttribute("value");
    if (value === shown || !asked.has(value)) return;
    shown = value;
    const move = asked.get(value);
    requestAnimationFrame(() => setTimeout(() => window.drawn.push({ at: performance.now(), after: performance.now() - move })));
  }).observe(document, { subtree: true, childList: true, attributes: true });
}
