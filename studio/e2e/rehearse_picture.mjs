// usage: node e2e/rehearse_picture.mjs [OUT]: docs/pictures/rehearse-page.png, three moments of a rehearsal: before the aircraft is
// lost, when it is, and later; from the command in WAYBREAKER_COMMAND (default: the one in build/release).
import { spawn } from "node:child_process";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../..", import.meta.url));
const out = process.argv[2] ?? `${root}docs/pictures/rehearse-page.png`;
const command = process.env.WAYBREAKER_COMMAND ?? `${root}build/release/apps/waybreaker`;
const part = { x: 208, y: 133, width: 400, height: 116 }; // of the map

const server = spawn(command, ["serve", "--port", "0"], { stdio: ["ignore", "ignore", "pipe"] });
const url = await new Promise((found) =>
  server.stderr.on("data", (log) => /http:\/\/[\d.]+:\d+/.test(log) && found(/http:\/\/[\d.]+:\d+/.exec(log)[0])),
);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage({ viewport: { width: 1100, height: 700 } });
await page.goto(url);
await page.getByText("Checked independently").waitFor();
await page.getByText("One removal more").waitFor();
await page.getByRole("button", { name: "Rehearse this plan" }).click();
await page.getByRole("button", { name: "Pause" }).click();

const seek = (share) =>
  page.getByRole("slider", { name: "Time of the mission" }).evaluate((one, to) => {
    one.value = String(to * one.max);
    one.dispatchEvent(new Event("input", { bubbles: true }));
  }, share);
const frames = [];
const shoot = async (words) => {
  await page.mouse.move(0, 0);
  await page.waitForTimeout(1500); // the map's tiles
  const { x, y } = await page.getByRole("application").boundingBox();
  const clip = { ...part, x: x + part.x, y: y + part.y };
  frames.push({ words, picture: (await page.screenshot({ clip })).toString("base64") });
};
await seek(0.2);
await shoot("As planned");
await page.getByRole("button", { name: "The aircraft: Lost" }).click();
await page.getByText("Checked independently").waitFor();
await shoot("The aircraft is lost: a new way, and the old one dotted");
await seek(0.55);
await shoot("Driven on");

const figures = frames.map(({ words, picture }) => `<figure><img src="data:image/png;base64,${picture}"><figcaption>${words}</figcaption></figure>`);
const style = "body{margin:0;background:#fff;font:14px sans-serif}figure{margin:0}img{display:block}figcaption{height:32px;line-height:30px;padding-left:4px}";
const sheet = await browser.newPage({ viewport: { width: part.width, height: 3 * (part.height + 32) } });
await sheet.setContent(`<style>${style}</style>${figures.join("")}`);
await sheet.screenshot({ path: out });
await browser.close();
server.kill();
