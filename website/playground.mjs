// usage: node playground.mjs FOLDER [BASE]: the way into the playground of the built site. The home page fetches nothing of it until
// it is asked to, then plans in place; every link of a page into it opens a mission that is planned.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

const [folder, base = "/"] = process.argv.slice(2);
const minute = 60_000; // ms
const server = await serve(folder, base);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const faults = [];

async function opened(path, viewport = { width: 1400, height: 900 }) {
  const page = await (await browser.newContext({ viewport })).newPage();
  page.setDefaultTimeout(2 * minute);
  page.on("console", (message) => message.type() === "error" && faults.push(`${path}: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`${path}: ${error}`));
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(server.url + path, { waitUntil: "load" });
  return { page, asked };
}

// The figures of the headline, once the plan has been checked.
async function figures(frame) {
  await frame.locator('[aria-label="Result"][aria-busy="false"]').getByText("Checked independently").waitFor();
  return frame.locator('[aria-label="Result"] data').evaluateAll((all) => all.map((one) => Number(one.getAttribute("value"))));
}

async function lookAtHome() {
  const { page, asked } = await opened("/");
  await page.waitForLoadState("networkidle");
  const early = asked.filter((url) => url.startsWith(`${server.url}/playground/`));
  if (early.length > 0) faults.push(`the home page fetches ${early[0]} before anybody asks for it`);
  await page.getByText("Plan it yourself").click();
  const [after, before] = await figures(page.frameLocator("iframe"));
  if (!(after < before)) faults.push(`the home page plans ${after}, no better than ${before} without removals`);
  await page.context().close();

  const narrow = await opened("/", { width: 390, height: 844 });
  await narrow.page.getByText("Plan it yourself").click();
  await narrow.page.waitForURL(/\/playground\//);
  await figures(narrow.page);
  await narrow.page.context().close();
}

function missions() {
  const pages = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith(".html") && !/^(cpp|playground)\//.test(file));
  const links = pages.flatMap((file) => [...readFileSync(join(folder, file), "utf8").matchAll(/"[^"]*\/playground\/(#[^"]+)"/g)]);
  return [...new Set(links.map(([, mission]) => mission.replaceAll("&amp;", "&")))];
}

async function follow(mission) {
  const path = `/playground/${mission}`;
  const { page } = await opened(path);
  const found = await figures(page);
  if (found.length !== 2) faults.push(`${path}: no removal helps`);
  const complaint = page.getByText(/in the link cannot be read/);
  if (await complaint.count()) faults.push(`${path}: ${await complaint.first().innerText()}`);
  await page.context().close();
}

await lookAtHome();
const links = missions();
if (links.length === 0) faults.push("no page links into the playground");
for (const mission of links) await follow(mission);
await browser.close();
server.close();
for (const fault of faults) console.error(fault);
console.log(`the home page plans; ${links.length} links into the playground, ${faults.length} findings`);
process.exitCode = faults.length > 0 ? 1 : 0;
