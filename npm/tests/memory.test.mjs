// What is no longer needed is given back.
import assert from "node:assert/strict";
import { before, it } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { createPlanner, InputError } from "waybreaker";
import { drawnGrid, drawnMission, random } from "./missions.mjs";

let wb;
before(async () => {
  wb = await createPlanner();
});

setFlagsFromString("--expose-gc");
const collectGarbage = runInNewContext("gc");

const side = 60;

function planOnce(seed) {
  const from = random(seed);
  const blocked = drawnGrid(from, side, side);
  const mission = drawnMission(from, side, side, blocked);
  const map = wb.mapFromGrid(side, side, blocked);
  try {
    const plan = wb.plan(map, mission);
    wb.check(map, plan);
    if (plan.agents.length > 0) wb.svg(map, plan);
  } catch (error) {
    assert.ok(error instanceof InputError); // errors must give back what they took as well
  } finally {
    map.free();
  }
}

it("a thousand plans take no more memory than the first round of them", () => {
  const round = 50;
  const seeds = 10;
  const plan = (times) => {
    for (let i = 0; i < times; ++i) planOnce(i % seeds);
  };
  plan(round);
  const before = wb.memoryBytes;
  plan(1000);
  assert.equal(wb.memoryBytes, before);
});

it("maps that are garbage are freed", async () => {
  const blocked = new Uint8Array(500 * 500); // a megabyte each
  const make = () => {
    for (let i = 0; i < 20; ++i) wb.mapFromGrid(500, 500, blocked);
  };
  const collect = async () => {
    for (let i = 0; i < 5; ++i) {
      collectGarbage();
      await new Promise((resolve) => setTimeout(resolve));
    }
  };
  make();
  await collect();
  const before = wb.memoryBytes;
  for (let round = 0; round < 10; ++round) {
    make();
    await collect();
  }
  assert.ok(wb.memoryBytes - before <= 30 * 2 ** 20, `${wb.memoryBytes - before}`);
});
