// usage: node e2e/picture.mjs [OUT]: docs/pictures/studio.png, what a first visit sees, from the command in
// WAYBREAKER_COMMAND (default: the one in build/release).
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
await browser.close();
server.kill();
