// usage: node bench/start.mjs SITE[,SITE...]
//
// What the start of a page without a server costs its main thread: SITE is what `waybreaker site` wrote. Chromium opens it in
// a telephone's window, five times each in turns. Says the processor's time in all, and how much of it blocks a telephone, where
// tasks take four times as long: what is above 50 ms of each. Other work on the machine does not count, but for what it
// takes from caches. CHROMIUM names another browser.
import { chromium } from "playwright-core";
import { serve } from "../../website/serve.mjs";

const sites = process.argv[2].split(",").map((site) => ({ site, busy: [], blocked: [] }));
const [runs, slower, short] = [5, 4, 50]; // ms
const categories = ["devtools.timeline", "disabled-by-default-devtools.timeline", "v8.execute", "toplevel", "__metadata"];

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
for (let run = 0; run < runs; ++run) for (const result of sites) await measure(result);
await browser.close();
const median = (values) => Math.round(values.sort((a, b) => a - b)[Math.floor(values.length / 2)]);
for (const { site, busy, blocked } of sites) console.log(`${site}: main thread ${median(busy)} ms, ${median(blocked)} ms block a telephone`);

async function measure({ site, busy, blocked }) {
  const host = await serve(site);
  const context = await browser.newContext({ viewport: { width: 412, height: 823 }, deviceScaleFactor: 1.75, isMobile: true });
  const page = await context.newPage();
  await browser.startTracing(page, { categories });
  await page.goto(`${host.url}/`);
  while (!(await page.evaluate(() => document.body.textContent.includes("Checked independently")))) await page.waitForTimeout(400);
  await page.waitForTimeout(2000);
  const tasks = tasksOf(JSON.parse((await browser.stopTracing()).toString()).traceEvents, host.url);
  await context.close();
  host.close();
  busy.push(tasks.reduce((sum, time) => sum + time, 0));
  blocked.push(tasks.reduce((sum, time) => sum + Math.max(0, slower * time - short), 0));
}

// Processor's time of each task of the page's main thread, in ms: of the outermost parts of it that say theirs.
function tasksOf(events, url) {
  const threadOf = ({ pid, tid }) => `${pid} ${tid}`;
  const ofPage = events.find(({ args }) => (args?.fileName ?? args?.data?.url) === `${url}/studio.js`);
  const parts = events.filter((event) => event.ph === "X" && threadOf(event) === threadOf(ofPage)).sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  const tasks = [];
  let end = 0;
  for (const { name, ts, dur = 0, tdur } of parts) {
    if (name === "RunTask") tasks.push(0);
    else if (tdur !== undefined && ts >= end && tasks.length > 0 && !name.endsWith("::RunTask")) {
      tasks[tasks.length - 1] += tdur / 1000;
      end = ts + dur;
    }
  }
  return tasks;
}
