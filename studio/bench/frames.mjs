// usage: node bench/frames.mjs [WIDTH [HEIGHT [PIXEL_RATIO]]]
//
// What a frame of the map view costs the main thread on a city of 4096² cells in headless Chromium, in milliseconds of
// processor time: the view's own work, and then the drawing, which has no graphics card here. Frames that draw nothing
// are left out. CHROMIUM names another browser.
import { chromium } from "playwright-core";
import { createServer } from "vite";

const [width = 1400, height = 900, deviceScaleFactor = 1] = process.argv.slice(2).map(Number);
const root = new URL("..", import.meta.url).pathname;
const server = await createServer({ root, logLevel: "warn", server: { port: 0 } });
await server.listen();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  const tracing = await browser.newBrowserCDPSession();
  const events = [];
  tracing.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  const includedCategories = ["devtools.timeline", "disabled-by-default-devtools.timeline", "blink.user_timing"];
  await tracing.send("Tracing.start", { traceConfig: { includedCategories } });
  const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor });
  page.on("pageerror", (error) => console.error(error));
  await page.goto(new URL("bench/", server.resolvedUrls.local[0]).href);
  await page.waitForFunction("window.done", null, { timeout: 300000 });
  if (process.env.PICTURE) await page.screenshot({ path: process.env.PICTURE });
  const complete = new Promise((resolve) => tracing.once("Tracing.tracingComplete", resolve));
  await tracing.send("Tracing.end");
  await complete;
  report(events);
} finally {
  await browser.close();
  await server.close();
}

function report(events) {
  console.log(`${width} × ${height}, pixel ratio ${deviceScaleFactor}: median / 95 % / worst`);
  console.log("".padEnd(24), "work".padEnd(20), "work and drawing");
  const marks = events.filter(({ name }) => name.startsWith("bench: ")).sort((a, b) => a.ts - b.ts);
  marks.slice(0, -1).forEach((mark, i) => {
    const within = events.filter(({ ts }) => ts >= mark.ts && ts < marks[i + 1].ts).sort((a, b) => a.ts - b.ts);
    const work = [];
    const both = [];
    let sum = 0; // of the callbacks since the last drawing
    for (const { name, ph, tdur } of within) {
      if (ph !== "X") continue;
      if (name === "FireAnimationFrame") sum += tdur;
      if (name !== "Commit") continue;
      work.push(sum);
      both.push(sum + tdur);
      sum = 0;
    }
    console.log(mark.name.slice(7).padEnd(24), figures(work).padEnd(20), figures(both));
  });
}

function figures(microseconds) {
  const sorted = microseconds.sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] / 1000;
  return sorted.length === 0 ? "-" : [0.5, 0.95, 1].map((share) => at(share).toFixed(1)).join(" / ");
}
