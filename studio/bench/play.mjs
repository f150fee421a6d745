// usage: node bench/play.mjs PAGE.html [WIDTH [HEIGHT]]
//
// What a frame of playback costs the main thread on the page of a plan (`waybreaker plan --html`), in milliseconds of processor
// time: everything, and scripts alone; and how many frames a second there were, which depends on what else the machine does.
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [file, width = 1400, height = 900] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) } });
  await page.goto(pathToFileURL(file).href);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForTimeout(1500); // tiles are painted
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const before = await metrics(session);
  const [frames, seconds] = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const begin = performance.now();
        let count = 0;
        const tick = (now) => (now - begin > 7000 ? resolve([count, (now - begin) / 1000]) : (++count, requestAnimationFrame(tick)));
        requestAnimationFrame(tick);
      }),
  );
  const after = await metrics(session);
  const each = (name) => ((1000 * (after[name] - before[name])) / frames).toFixed(1);
  console.log(`${frames} frames, ${(frames / seconds).toFixed(1)} a second; a frame: ${each("TaskDuration")} ms, scripts ${each("ScriptDuration")} ms`);
} finally {
  await browser.close();
}

async function metrics(session) {
  const { metrics } = await session.send("Performance.getMetrics");
  return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
}
