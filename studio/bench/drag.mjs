// usage: node bench/drag.mjs MAP START GOAL [PAGE...]
//
// How soon plans follow a marker that is dragged: Chromium drags the start by hand's pace, three times. Says, in ms,
// how long from one answer to the next while the mouse moves, from the last move to the answer for that place, and to the
// plan that is no draft. START and GOAL are X,Y; a PAGE is a folder that Vite built, to try
// instead of the command's own.
// WAYBREAKER_COMMAND and CHROMIUM name other programs. A large city: waybreaker map generate blocks --side 4096 -o city.tif
import { spawn } from "node:child_process";
import { basename, dirname, resolve } from "node:path";
import { chromium } from "playwright-core";
import { createServer } from "vite";

const [map, start, goal, ...pages] = process.argv.slice(2);
const root = new URL("../..", import.meta.url).pathname;
const command = process.env.WAYBREAKER_COMMAND ?? `${root}build/release/apps/waybreaker`;
const view = { width: 1400, height: 900 };
const [moves, pace] = [40, 25]; // ms

const vite = await createServer({ root: `${root}studio`, logLevel: "warn", server: { middlewareMode: true } });
const { toScreen, wholeMap } = await vite.ssrLoadModule("/src/map/viewport/camera.ts");
const server = spawn(command, ["serve", "--maps", dirname(resolve(map)), "--port", "0"], {
  stdio: ["ignore", "ignore", "pipe"],
});
const url = await new Promise((found) =>
  server.stderr.on("data", (log) => /http:\/\/[\d.]+:\d+/.test(log) && found(/http:\/\/[\d.]+:\d+/.exec(log)[0])),
);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  console.log("page".padEnd(24), "between answers", " last answer", " plan");
  for (const folder of pages.length > 0 ? pages : [null]) await measure(folder);
} finally {
  await browser.close();
  server.kill();
  await vite.close();
}

async function measure(folder) {
  const page = await browser.newPage({ viewport: view });
  if (folder) {
    for (const [path, file] of [["/", "index.html"], ["/studio.js", "studio.js"], ["/studio.css", "studio.css"]]) {
      await page.route(url + path, (route) => route.fulfill({ path: resolve(folder, file) }));
    }
  }
  await page.addInitScript(noteAnswers);
  const mission = `map=${basename(map)}&start=${start}&goal=${goal}&removals=2&show=after`;
  await page.goto(`${url}/?${mission}`);
  await page.getByText("Checked independently").waitFor({ timeout: 120_000 });
  const size = await (await page.request.get(`${url}/api/v1/maps/${basename(map)}`)).json();
  const box = await page.getByRole("application").boundingBox();
  const results = [];
  for (let turn = 0; turn < 3; ++turn) results.push(await drag(page, box, size));
  const column = (name) => String(Math.round(median(results.map((result) => result[name])))).padStart(12);
  console.log((folder ?? "of the command").padEnd(24), column("between"), column("last"), column("plan"));
  await page.close();
}

async function drag(page, box, size) {
  const label = await page.getByRole("button", { name: /^Ground start, column/ }).getAttribute("aria-label");
  const cell = /column (\d+), row (\d+)/.exec(label).slice(1).map(Number);
  const [x, y] = toScreen(wholeMap(size, box), box, cell);
  await page.mouse.move(box.x + x, box.y + y);
  await page.mouse.down();
  await page.evaluate(() => (window.answers = []));
  const began = await page.evaluate(() => performance.now());
  for (let i = 1; i <= moves; ++i) {
    await page.mouse.move(box.x + x + 2 * i, box.y + y - i);
    await page.waitForTimeout(pace);
  }
  const ended = await page.evaluate(() => performance.now());
  await page.mouse.up();
  const last = await page.getByRole("button", { name: /^Ground start, column/ }).getAttribute("aria-label");
  const final = /column (\d+), row (\d+)/.exec(last).slice(1).join();
  const isPlanned = (place) => window.answers.some(({ start, removals, draft }) => start === place && removals > 0 && !draft);
  await page.waitForFunction(isPlanned, final, { timeout: 120_000 });
  const answers = (await page.evaluate(() => window.answers)).filter(({ removals }) => removals > 0);
  const there = answers.filter((answer) => answer.start === final);
  const all = answers.map(({ at }) => at);
  const times = [began, ...all.slice(0, 1 + all.filter((at) => at < ended).length)];
  return {
    between: median(times.slice(1).map((at, i) => at - times[i])),
    last: Math.max(0, there[0].at - ended),
    plan: Math.max(0, there.find(({ draft }) => !draft).at - ended),
  };
}

// In the page: when each plan has been drawn.
function noteAnswers() {
  window.answers = [];
  const ask = window.fetch;
  window.fetch = async (...question) => {
    const answer = await ask(...question);
    if (answer.ok && answer.url.endsWith("/plan")) {
      const { mission, options } = JSON.parse(question[1].body);
      const note = () =>
        window.answers.push({
          at: performance.now(),
          start: mission.start.join(),
          removals: options.removals,
          draft: options.select !== "exact",
        });
      void answer.clone().text().then(() => requestAnimationFrame(() => setTimeout(note)), () => undefined);
    }
    return answer;
  };
}

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length === 0 ? Infinity : sorted[Math.floor(sorted.length / 2)];
}
