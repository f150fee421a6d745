// Missions under way, and maps that change: revisions equal those of the command to the byte.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { createPlanner, InputError } from "waybreaker";
import { createWorkerPlanner } from "waybreaker/worker";
import { drawnGrid, drawnMission, movingAI, random } from "./missions.mjs";
import { cityMap, nativeRevision, Refused, Scratch } from "./native.mjs";

const scratch = new Scratch();
let wb;
let worker;
before(async () => {
  wb = await createPlanner();
  worker = await createWorkerPlanner();
});
after(() => {
  worker.close();
  scratch.remove();
});

// What may have happened to a plan.
function drawnState({ below, next, one }, plan) {
  const end = plan.after.makespan;
  const now = end * next();
  const state = { format: "waybreaker-state/1", sequence: 1, now };
  const failed = plan.removed.filter(({ cleared_at }) => cleared_at <= now);
  const agent = one(plan.agents);
  const [x, y] = one(agent.path);
  const news = [
    () => (failed.length > 0 ? { failed: [{ obstacle: failed[0].obstacle, at: failed[0].cleared_at }] } : {}),
    () => ({ agents: [{ id: plan.agents.at(-1).id, passed: 0, doing: "lost" }] }),
    () => ({ found: [{ cells: [[Math.round(x), Math.round(y)]], destructible: next() < 0.3 }] }),
    () => ({ agents: [{ id: agent.id, passed: 0, goal: [below(plan.map.width), below(plan.map.height)] }] }),
    () => ({}),
  ];
  return { ...state, ...one(news)() };
}

function assertSame(name, file, plan, state, reaction) {
  const map = wb.mapFromMovingAI(file, { name });
  let ours;
  try {
    ours = wb.reviseText(map, plan, state, { reaction, seconds: null });
  } catch (error) {
    assert.ok(error instanceof InputError, error);
    assert.throws(() => nativeRevision(scratch, { name, map: file, plan, state, reaction }), Refused);
    return "refused";
  }
  const native = nativeRevision(scratch, { name, map: file, plan, state, reaction });
  assert.equal(ours, native.plan, JSON.stringify(state));
  const report = wb.check(map, ours, { after: plan, state });
  assert.deepEqual(report, native.report);
  const { status, revision } = JSON.parse(ours);
  if (status === "solved") assert.deepEqual(report.violations, []);
  return revision?.status;
}

describe("revisions equal the command's to the byte", () => {
  it("on drawn maps", () => {
    const outcomes = new Set();
    for (let seed = 1; seed <= 60; ++seed) {
      const from = random(3000 + seed);
      const [width, height] = [8 + from.below(30), 8 + from.below(30)];
      const blocked = drawnGrid(from, width, height);
      const mission = drawnMission(from, width, height, blocked);
      const file = movingAI(width, height, blocked);
      let plan;
      try {
        plan = wb.planText(wb.mapFromMovingAI(file, { name: "drawn.map" }), mission);
      } catch (error) {
        assert.ok(error instanceof InputError, error);
        continue; // a start without room
      }
      const document = JSON.parse(plan);
      if (document.status !== "solved") continue;
      outcomes.add(assertSame("drawn.map", file, plan, drawnState(from, document), from.one([0, 0, 2])));
    }
    for (const outcome of ["kept", "revised"]) assert.ok(outcomes.has(outcome), [...outcomes].join());
  });

  it("across a city, after a failed breach", () => {
    const file = cityMap(scratch, "berlin-adlershof.tif");
    const ends = { start: [130, 104], goal: [466, 105] };
    const agents = [
      { id: "ground", kind: "ground", ...ends },
      { id: "air", kind: "air", ...ends, speed: 2 },
    ];
    const mission = { format: "waybreaker-mission/1", agents, rules: { removals: 2, breach_time: 10 }, limits: { seconds: null } };
    const plan = wb.planText(wb.mapFromMovingAI(file, { name: "city.map" }), mission);
    const [{ obstacle, cleared_at: now }] = JSON.parse(plan).removed;
    const state = { format: "waybreaker-state/1", sequence: 1, now, failed: [{ obstacle, at: now }] };
    assert.equal(assertSame("city.map", file, plan, state, 0), "revised");
  });
});

const level = "type octile\nheight 4\nwidth 9\nmap\n....@....\n....@....\n....@....\n.........\n";
const mission = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "rover", kind: "ground", start: [0, 1], goal: [8, 1] },
    { id: "drone", kind: "air", start: [0, 1], goal: [0, 1] },
  ],
  rules: { removals: 1, breach_time: 1 },
};
const failure = { format: "waybreaker-state/1", sequence: 1, now: 4, failed: [{ obstacle: 1, at: 4 }] };

it("says what has become of the plan", () => {
  const map = wb.mapFromMovingAI(level);
  const plan = wb.plan(map, mission);
  const next = wb.revise(map, plan, failure);
  assert.deepEqual([next.status, next.revision.number, next.revision.status], ["solved", 1, "revised"]);
  assert.equal(next.mission.rules.failed[0], 1);
  assert.deepEqual(wb.revise(map, next, failure), next); // a report twice is a report once
  const lost = { format: "waybreaker-state/1", sequence: 2, now: 5, agents: [{ id: "rover", passed: 0, doing: "lost" }] };
  assert.equal(wb.revise(map, next, lost).revision.reason, "no vehicle is left to drive");
  const blocked = { format: "waybreaker-state/1", sequence: 1, now: 1, found: [{ cells: [[2, 1]] }] };
  const { status, revision } = wb.revise(map, plan, blocked, { reaction: 3 });
  assert.deepEqual([status, revision.status, revision.halts.map(({ agent }) => agent)], ["no_plan", "broken", ["rover"]]);
  assert.equal(wb.check(map, wb.plan(map, mission), { after: plan, state: failure }).valid, false); // it begins anew
});

it("refuses what does not fit, and says what", () => {
  const map = wb.mapFromMovingAI(level);
  const plan = wb.plan(map, mission);
  const cases = [
    [() => wb.revise(map, plan, { ...failure, failed: [{ obstacle: 7, at: 4 }] }), /^the state: .*obstacle 7/],
    [() => wb.revise(map, plan, { ...failure, sequence: 0 }), /^the state.*sequence/],
    [() => wb.revise(map, "{}", failure), /^the plan/],
    [() => wb.revise(wb.mapFromGrid(9, 4, new Uint8Array(36)), plan, failure), /^the plan: .*another map/],
    [() => wb.revise(map, plan, failure, { reaction: -1 }), /^the time of reaction must be from 0/],
    [() => wb.revise(map, plan, failure, { seconds: 0 }), /^the time limit must be above 0/],
    [() => wb.check(map, plan, { after: plan }), /belong together/],
    [() => map.with([{ remove: 2 }]), /no obstacle 2 to remove/],
    [() => map.with([{ remove: -1 }]), /-1 is no id/],
    [() => map.with([{ add: [] }]), /at least one cell/],
    [() => map.with([{ free: [[9, 0]] }]), /9,0/],
    [() => map.with([{ free: [[0.5, 0]] }]), /\[0\.5,0\] is no cell/],
    [() => map.with([{ free: 7 }]), /a list of/],
    [() => map.with([{}]), /remove, add, extend or free/],
  ];
  for (const [call, message] of cases) {
    assert.throws(call, (error) => error instanceof InputError && message.test(error.message), `${message}`);
  }
});

it("maps change by edits, and obstacles keep their ids", () => {
  const map = wb.mapFromMovingAI(level);
  const built = map.with([
    { add: [[6, 0], [6, 1]], attributes: { sourceId: 4711, weight: 2 } },
    { extend: 1, cells: [[4, 3]] },
    { free: [[4, 0]] },
  ]);
  assert.deepEqual([built.obstacleCount, built.obstacle(1).cells, built.obstacle(2).sourceId], [2, 3, 4711]);
  assert.deepEqual([...built.labels()].filter((label) => label === 2).length, 2);
  const gone = built.with([{ remove: 1 }]);
  assert.deepEqual([gone.obstacle(1).cells, gone.obstacle(2).cells], [0, 2]);
  assert.deepEqual([map.obstacleCount, map.obstacle(1).cells], [1, 3]);
  assert.equal(map.with([]).digest, map.digest);
  const plan = wb.plan(built, mission);
  assert.equal(wb.check(built, plan).valid, true);
  assert.equal(wb.check(map, plan).valid, false); // it is another map
});

it("in a worker, and after a call was cancelled", async () => {
  const map = wb.mapFromMovingAI(level);
  const plan = wb.planText(map, mission);
  const next = wb.reviseText(map, plan, failure);
  const there = await worker.mapFromMovingAI(level);
  assert.equal(await worker.reviseText(there, plan, failure), next);
  assert.deepEqual(await worker.revise(there, plan, failure), JSON.parse(next));
  assert.equal((await worker.check(there, next, { after: plan, state: failure })).valid, true);

  const edits = [{ add: [[6, 0], [6, 1]] }];
  const [ours, theirs] = [map.with(edits).with([{ remove: 1 }]), await (await there.with(edits)).with([{ remove: 1 }])];
  assert.deepEqual([theirs.digest, theirs.obstacleCount], [ours.digest, 2]);
  const cancelled = new AbortController();
  const endless = worker.plan(await worker.mapFromGrid(600, 600, drawnGrid(random(5), 600, 600, 0.35)), mission, { signal: cancelled.signal });
  cancelled.abort();
  await assert.rejects(endless, { name: "AbortError" });
  assert.equal(await worker.planText(theirs, mission), wb.planText(ours, mission)); // in another worker, made again there
  const aborted = worker.revise(there, plan, failure, { signal: AbortSignal.abort() });
  await assert.rejects(aborted, { name: "AbortError" });
});
