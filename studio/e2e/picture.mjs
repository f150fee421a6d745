// usage: node e2e/picture.mjs [OUT [EXTRACT IMPORT_OUT [SHAPES OVERLAY_OUT]]]: docs/pictures/studio.png, what a first
// visit sees, from the command in WAYBREAKER_COMMAND (default: the one in build/release); the import of an extract of
// map data (docs/pictures/import.png); and what is asked of a file to lay over the map (docs/pictures/overlay.png).
import { spawn } from "node:child_process";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
const out = process.argv[2] ?? `${root}docs/pictures/studio.png`;
const command = process.env.WAYBREAKER_COMMAND ?? `${root}build/release/apps/waybreaker`;

const server = spawn(command, ["serve", "--port", "0"], { stdio: ["ignore", "ignore", "pipe"] });
const url = await new Promise((found) =>
  server.stderr.on("data", (log) => /http:\/\/[\d.]+:\d+/.test(log) && found(/http:\/\/[\d.]+:\d+/.exec(log)[0])),
);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage({ viewport: { width: 1400, height: 860 } });
await page.goto(url);
await page.getByText("Checked independently").waitFor();
await page.getByText("One removal more").waitFor();
await page.getByRole("button", { name: "Dismiss the hint" }).click();
await page.waitForTimeout(1000); // the map's tiles
await page.screenshot({ path: out });
const [extract, importOut, shapes, overlayOut] = process.argv.slice(3);
if (extract) {
  await page.getByLabel("File to open").setInputFiles(extract);
  const dialog = page.getByRole("dialog");
  await dialog.getByText("the stronger the shade").waitFor();
  await dialog.screenshot({ path: importOut });
  await page.keyboard.press("Escape");
}
if (shapes) {
  await page.getByLabel("File to open").setInputFiles(shapes);
  await page.getByRole("dialog").screenshot({ path: overlayOut });
}
await browser.close();
server.kill();
