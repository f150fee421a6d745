import assert from "node:assert/strict";
import { after, before, it } from "node:test";
import { createPlanner } from "waybreaker";
import { createWorkerPlanner, InputError } from "waybreaker/worker";
import { drawnGrid, random } from "./missions.mjs";

let here;
let worker;
before(async () => {
  here = await createPlanner();
  worker = await createWorkerPlanner();
});
after(() => worker.close());

const side = 600;
const blocked = drawnGrid(random(5), side, side, 0.35);
blocked[0] = blocked[blocked.length - 1] = 0;
const [start, goal] = [
  [0, 0],
  [side - 1, side - 1],
];
const agents = [
  { id: "ground", kind: "ground", start, goal },
  { id: "air", kind: "air", start, goal },
];
const limits = { seconds: null };
const mission = { format: "waybreaker-mission/1", agents, rules: { removals: 0 }, limits };
// The proof for so many removals of small obstacles does not end while anybody waits.
const endless = { ...mission, rules: { removals: 32 } };

it("plans, checks and draws as the planner does", async () => {
  const small = 50;
  const cells = drawnGrid(random(6), small, small);
  cells[0] = cells[cells.length - 1] = 0;
  const ends = agents.map((agent) => ({ ...agent, goal: [small - 1, small - 1] }));
  const mission = { format: "waybreaker-mission/1", agents: ends, rules: { removals: 2 }, limits };
  const ours = here.mapFromGrid(small, small, cells, { name: "level" });
  const map = await worker.mapFromGrid(small, small, cells, { name: "level" });
  for (const property of ["width", "height", "obstacleCount", "digest"]) assert.equal(map[property], ours[property]);
  const text = await worker.planText(map, mission);
  assert.equal(text, here.planText(ours, mission));
  const plan = await worker.plan(map, mission);
  assert.deepEqual(plan, JSON.parse(text));
  assert.equal(await worker.svg(map, plan), here.svg(ours, plan));
  assert.deepEqual(await worker.check(map, plan), here.check(ours, plan));
  assert.deepEqual(await worker.front(map, mission), here.front(ours, mission));
  assert.deepEqual(await map.labels(), ours.labels());
  assert.deepEqual(await map.obstacle(1), ours.obstacle(1));
});

it("errors come as they are", async () => {
  await assert.rejects(worker.mapFromMovingAI("no map", { name: "x.map" }), (error) => error instanceof InputError && /x\.map/.test(error.message));
  const map = await worker.mapFromGrid(2, 1, new Uint8Array(2));
  await assert.rejects(worker.plan(map, mission), InputError);
  map.free();
  await assert.rejects(worker.plan(map, mission), /freed/);
});

it("a call is cancelled, those before and after it are not", async () => {
  const map = await worker.mapFromGrid(side, side, blocked);
  const before = worker.planText(map, mission);
  const cancelled = new AbortController();
  const long = worker.plan(map, endless, { signal: cancelled.signal });
  const waiting = new AbortController();
  const never = worker.plan(map, endless, { signal: waiting.signal });
  const after = worker.planText(map, mission);
  waiting.abort(new Error("not needed any more"));
  await assert.rejects(never, /not needed any more/);
  const text = await before;
  setTimeout(() => cancelled.abort(), 50); // while it plans
  await assert.rejects(long, { name: "AbortError" });
  assert.equal(await after, text); // in another worker, on the map made again
});

it("what is aborted before it is asked for is not begun", async () => {
  const map = await worker.mapFromGrid(2, 1, new Uint8Array(2));
  await assert.rejects(worker.plan(map, endless, { signal: AbortSignal.abort() }), { name: "AbortError" });
});

it("closing rejects what has no answer yet", async () => {
  const other = await createWorkerPlanner();
  const map = await other.mapFromGrid(side, side, blocked);
  const long = other.plan(map, endless);
  const next = other.plan(map, mission);
  setTimeout(() => other.close(), 50);
  await assert.rejects(long, /closed/);
  await assert.rejects(next, /closed/);
  await assert.rejects(other.plan(map, mission), /closed/);
});
