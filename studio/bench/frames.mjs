// usage: node bench/frames.mjs [WIDTH [HEIGHT [PIXEL_RATIO]]]
//
// Frame times of the map view on a city of 4096² cells in headless Chromium, which draws without a graphics card: median,
// 95th percentile and worst, in milliseconds. CHROMIUM names another browser.
import { chromium } from "playwright-core";
import { createServer } from "vite";

const [width = 1400, height = 900, deviceScaleFactor = 1] = process.argv.slice(2).map(Number);
const server = await createServer({ root: new URL("..", import.meta.url).pathname, logLevel: "warn", server: { port: 0 } });
await server.listen();
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox"],
});
try {
  const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor });
  page.on("pageerror", (error) => console.error(error));
  await page.goto(new URL("bench/", server.resolvedUrls.local[0]).href);
  await page.waitForFunction("window.figures", null, { timeout: 120000 });
  console.log(`${width} × ${height}, pixel ratio ${deviceScaleFactor}; work, interval: median / 95 % / worst`);
  for (const [name, figures] of Object.entries(await page.evaluate("window.figures"))) {
    console.log(name.padEnd(28), typeof figures === "string" ? figures : `${figures.work.padEnd(22)} ${figures.interval}`);
  }
  if (process.env.SHOT) await page.screenshot({ path: process.env.SHOT });
} finally {
  await browser.close();
  await server.close();
}
