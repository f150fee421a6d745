// In Chromium: the files of dist/ as a plain server sends them, and the one-file build in a page without any.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { after, before, it } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { drawnGrid, drawnMission, movingAI, random } from "./missions.mjs";
import { nativePlan, Refused, Scratch } from "./native.mjs";

const dist = fileURLToPath(new URL("../dist/", import.meta.url));
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const types = { ".js": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };

const scratch = new Scratch();
let server;
let browser;
let page;
let address;

before(async () => {
  server = createServer((request, response) => {
    const file = join(dist, request.url);
    const found = request.url !== "/" && existsSync(file);
    response.writeHead(found || request.url === "/" ? 200 : 404, { "content-type": types[extname(file)] ?? types[".html"] });
    response.end(found ? readFileSync(file) : "<!doctype html><title>waybreaker</title>");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  page = await browser.newPage();
  await page.goto(address);
});
after(async () => {
  await browser?.close();
  server?.close();
  scratch.remove();
});

// Missions that can be planned, and the command's plans for them.
function missions(count) {
  const result = [];
  for (let seed = 500; result.length < count; ++seed) {
    const from = random(seed);
    const [width, height] = [10 + from.below(50), 10 + from.below(50)];
    const blocked = drawnGrid(from, width, height);
    const mission = drawnMission(from, width, height, blocked);
    const map = movingAI(width, height, blocked);
    try {
      result.push({ map, mission, plan: nativePlan(scratch, { name: "drawn.map", map, mission }) });
    } catch (error) {
      if (!(error instanceof Refused)) throw error; // a start without room
    }
  }
  return result;
}

async function planAll([module, create, all]) {
  const wb = await (await import(module))[create]();
  const plans = [];
  for (const { map, mission } of all) plans.push(await wb.planText(await wb.mapFromMovingAI(map, { name: "drawn.map" }), mission));
  wb.close?.();
  return plans;
}

for (const [module, create] of [
  ["./index.js", "createPlanner"],
  ["./worker.js", "createWorkerPlanner"],
  ["./inline.js", "createPlanner"],
  ["./inline.js", "createWorkerPlanner"],
]) {
  it(`${create} of ${module}: plans equal the command's to the byte`, async () => {
    const all = missions(12);
    const plans = await page.evaluate(planAll, [address + module, create, all]);
    for (const [i, { plan, mission }] of all.entries()) assert.equal(plans[i], plan, JSON.stringify(mission));
  });
}

it("an error, a cancelled call and the next plan, in a worker", async () => {
  const side = 600;
  const cells = drawnGrid(random(5), side, side, 0.35);
  cells[0] = cells[cells.length - 1] = 0;
  const outcome = await page.evaluate(async ([module, side, cells]) => {
    const { createWorkerPlanner, InputError } = await import(module);
    const wb = await createWorkerPlanner();
    const mistaken = await wb.mapFromMovingAI("no map").catch((error) => error instanceof InputError && error.message);
    const map = await wb.mapFromGrid(side, side, Uint8Array.from(cells));
    const agents = ["ground", "air"].map((kind) => ({ id: kind, kind, start: [0, 0], goal: [side - 1, side - 1] }));
    const mission = { format: "waybreaker-mission/1", agents, rules: { removals: 0 } };
    const long = { ...mission, rules: { removals: 32 }, limits: { seconds: null } };
    const cancelled = new AbortController();
    setTimeout(() => cancelled.abort(), 50);
    const aborted = await wb.plan(map, long, { signal: cancelled.signal }).catch(({ name }) => name);
    const { width } = (await wb.plan(map, mission)).map;
    wb.close();
    return { mistaken, aborted, width };
  }, [`${address}worker.js`, side, [...cells]]);
  assert.match(outcome.mistaken, /type octile/);
  assert.deepEqual([outcome.aborted, outcome.width], ["AbortError", side]);
});

it("the one-file build works in a page of one file, without a server", async () => {
  const script = readFileSync(join(dist, "inline.js"), "utf8").replace(/export\{[^}]*\};?\s*$/, (exports) => {
    const name = /([\w$]+) as createPlanner\b/.exec(exports);
    return `globalThis.createPlanner=${name?.[1] ?? "createPlanner"};`;
  });
  const mission = missions(1)[0];
  const file = scratch.file("page.html", `<!doctype html><title>one file</title><script type="module">${script.replaceAll("</script", "<\\/script")}</script>`);
  const alone = await browser.newPage();
  await alone.goto(`file://${file}`);
  const plan = await alone.evaluate(async ({ map, mission }) => {
    const wb = await globalThis.createPlanner();
    return wb.planText(wb.mapFromMovingAI(map, { name: "drawn.map" }), mission);
  }, mission);
  assert.equal(plan, mission.plan);
  await alone.close();
});
