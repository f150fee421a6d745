import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { before, describe, it } from "node:test";
import { createPlanner, InputError, InternalError, OutOfMemoryError } from "waybreaker";
import { withMemoryLimit } from "./memory_limit.mjs";
import { drawnGrid, random } from "./missions.mjs";

let wb;
before(async () => {
  wb = await createPlanner();
});

const wall = () => Uint8Array.from({ length: 100 }, (_, i) => (i % 10 === 5 ? 1 : 0));
const mission = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "ground", kind: "ground", start: [1, 1], goal: [8, 8] },
    { id: "air", kind: "air", start: [1, 1], goal: [8, 8] },
  ],
};

describe("wrong input is an InputError that says what is wrong", () => {
  const cases = {
    "a file that is no map": [() => wb.mapFromMovingAI("no map", { name: "level.map" }), /level\.map.*type octile/],
    "too few rows": [() => wb.mapFromMovingAI("type octile\nheight 2\nwidth 2\nmap\n..\n"), /map/],
    "too few cells": [() => wb.mapFromGrid(10, 10, new Uint8Array(99)), /100 bytes, not 99/],
    "a side of a fraction": [() => wb.mapFromGrid(2.5, 40, new Uint8Array(100)), /2\.5/],
    "an empty map": [() => wb.mapFromGrid(0, 0, new Uint8Array(0)), /./],
    "a side too long": [() => wb.mapFromGrid(40000, 1, new Uint8Array(40000)), /32768/],
    "a connectivity of 5": [() => wb.mapFromGrid(10, 10, wall(), { connectivity: 5 }), /4 or 8, not 5/],
    "a cell of nothing": [() => wb.mapFromGrid(10, 10, wall(), { cellSize: -1 }), /-1/],
    "too few labels": [() => wb.mapFromLabels(10, 10, new Uint32Array(5)), /100 labels, not 5/],
    "a weight of nothing": [
      () => wb.mapFromLabels(1, 1, new Uint32Array([1]), { attributes: [undefined, { weight: 0 }] }),
      /weigh/,
    ],
    "a sourceId that is not exact": [
      () => wb.mapFromLabels(1, 1, new Uint32Array([1]), { attributes: [undefined, { sourceId: 2 ** 60 }] }),
      /bigint/,
    ],
    "no JSON": [() => wb.plan(wb.mapFromGrid(10, 10, wall()), "{"), /mission/],
    "a mission without agents": [() => wb.plan(wb.mapFromGrid(10, 10, wall()), { format: mission.format }), /agents/],
    "a start off the map": [
      () => wb.plan(wb.mapFromGrid(10, 10, wall()), { ...mission, agents: [{ ...mission.agents[0], start: [10, 1] }, mission.agents[1]] }),
      /10/,
    ],
    "overlays, whose files are not there": [
      () => wb.plan(wb.mapFromGrid(10, 10, wall()), { ...mission, overlays: [{ file: "flood.geojson", as: "water" }] }),
      /flood\.geojson laid over it.*'waybreaker map overlay'.*leave out 'overlays'/,
    ],
    "a plan that is none": [() => wb.check(wb.mapFromGrid(10, 10, wall()), "{}"), /plan/],
    "another map's plan, drawn": [
      () => wb.svg(wb.mapFromGrid(20, 20, new Uint8Array(400)), wb.plan(wb.mapFromGrid(10, 10, wall()), mission)),
      /10 x 10/,
    ],
  };
  for (const [name, [call, message]] of Object.entries(cases)) {
    it(name, () => {
      assert.throws(call, (error) => error instanceof InputError && error.name === "InputError" && message.test(error.message));
      assert.equal(wb.plan(wb.mapFromGrid(10, 10, wall()), mission).status, "solved"); // the planner is as before
    });
  }

  it("a map that has been freed", () => {
    const map = wb.mapFromGrid(10, 10, wall());
    map.free();
    map.free();
    assert.throws(() => wb.plan(map, mission), /freed/);
    assert.throws(() => map.labels(), /freed/);
  });

  it("another planner's map", async () => {
    const other = await createPlanner();
    assert.throws(() => other.plan(wb.mapFromGrid(10, 10, wall()), mission), InputError);
  });
});

it("no plan is none, and says so", () => {
  const map = wb.mapFromLabels(10, 10, Uint32Array.from(wall()), { attributes: [undefined, { destructible: false }] });
  assert.equal(wb.plan(map, mission).status, "no_plan");
});

it("a report says what is wrong with a plan", () => {
  const map = wb.mapFromGrid(10, 10, wall());
  const plan = wb.plan(map, mission);
  assert.equal(wb.check(map, plan).valid, true);
  plan.agents[0].path[1][2] /= 2;
  const report = wb.check(map, plan);
  assert.equal(report.valid, false);
  assert.ok(report.violations.length > 0);
});

it("memory that has run out is an OutOfMemoryError, and the planner goes on", async () => {
  const wasm = readFileSync(new URL("../dist/waybreaker.wasm", import.meta.url));
  const small = await createPlanner({ wasm: withMemoryLimit(wasm, 160) });
  const side = 1200;
  assert.throws(() => small.mapFromGrid(4000, 4000, new Uint8Array(16_000_000)), OutOfMemoryError); // to pass it in
  const held = [];
  assert.throws(() => {
    for (;;) held.push(small.mapFromGrid(side, side, drawnGrid(random(1), side, side))); // in the library
  }, OutOfMemoryError);
  for (const map of held) map.free();
  assert.equal(small.plan(small.mapFromGrid(10, 10, wall()), mission).status, "solved");
});

it("memory that runs out while it plans is an OutOfMemoryError, and the planner goes on", async () => {
  const wasm = readFileSync(new URL("../dist/waybreaker.wasm", import.meta.url));
  const agents = mission.agents.map((agent) => ({ ...agent, start: [0, 0], goal: [699, 699] }));
  const blocked = drawnGrid(random(2), 700, 700, 0.3);
  blocked[0] = blocked[blocked.length - 1] = 0;
  let failed = 0;
  for (let pages = 120; pages <= 400; pages += 40) {
    const small = await createPlanner({ wasm: withMemoryLimit(wasm, pages) });
    const map = small.mapFromGrid(700, 700, blocked);
    try {
      small.plan(map, { ...mission, agents, limits: { seconds: null, expansions: 50_000 } });
    } catch (error) {
      assert.ok(error instanceof OutOfMemoryError, error);
      ++failed;
    }
    assert.equal(small.plan(small.mapFromGrid(10, 10, wall()), mission).status, "solved");
  }
  assert.ok(failed > 0);
});

it("what traps is an InternalError, and the planner starts anew", () => {
  const map = wb.mapFromGrid(10, 10, wall());
  const library = map.held().library;
  assert.throws(() => library.call("waybreaker_map_width", 0xfffffff0), InternalError);
  assert.throws(() => wb.plan(map, mission), InputError); // it is gone with the memory
  map.free();
  assert.equal(wb.plan(wb.mapFromGrid(10, 10, wall()), mission).status, "solved");
});
