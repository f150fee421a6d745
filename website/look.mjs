// usage: node look.mjs FOLDER [BASE [PICTURES [PAGE...]]]: opens every page of the built site, or those named, in Chromium, wide
// and narrow, light and dark. Nothing may be wider than the window, no error may be on the console, axe may find nothing
// serious. Pictures of all pages go to the folder PICTURES.
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

const [folder, base = "/", pictures, ...named] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const all = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".html") && !file.startsWith("cpp/"));
const pages = named.length > 0 ? named : [...all, "cpp/index.html"];

const server = await serve(folder, base);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const faults = [];
for (const [width, colorScheme] of [
  [1400, "light"],
  [1400, "dark"],
  [390, "light"],
  [390, "dark"],
]) {
  const context = await browser.newContext({ viewport: { width, height: 860 }, colorScheme });
  const page = await context.newPage();
  let errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  for (const file of pages) {
    const fault = (text) => faults.push(`${file}, ${width} ${colorScheme}: ${text}`);
    errors = [];
    await page.goto(`${server.url}/${file}`, { waitUntil: "load" });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    if (wide > 0) fault(`${wide} pixels wider than the window`);
    if (!file.startsWith("cpp/")) {
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
      for (const { id, impact, nodes } of violations) {
        if (impact === "serious" || impact === "critical") fault(`${id}: ${nodes.map((node) => node.html.slice(0, 160)).slice(0, 3).join(" | ")}`);
      }
    }
    for (const error of errors) fault(error);
    if (pictures) await page.screenshot({ path: join(pictures, `${file.replace(/\W/g, "-")}-${width}-${colorScheme}.png`) });
  }
  await context.close();
}
await browser.close();
server.close();
for (const fault of faults) console.error(fault);
console.log(`${pages.length} pages looked at, each in 4 ways, ${faults.length} findings`);
process.exitCode = faults.length > 0 ? 1 : 0;
