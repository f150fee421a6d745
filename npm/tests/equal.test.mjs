// Plans equal those of the command to the byte.
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { createPlanner, InputError } from "waybreaker";
import { drawnGrid, drawnMission, movingAI, random } from "./missions.mjs";
import { cityMap, nativePlan, Refused, Scratch } from "./native.mjs";

const scratch = new Scratch();
after(() => scratch.remove());
let wb;
before(async () => {
  wb = await createPlanner();
});

// The mission as the command plans it; what cannot be planned on this map, such as a start without room, is left out.
function assertEqual(which) {
  const map = wb.mapFromMovingAI(which.map, { name: which.name, ...which.options });
  try {
    let ours;
    try {
      ours = which.front ? wb.frontText(map, which.mission) : wb.planText(map, which.mission);
    } catch (error) {
      assert.ok(error instanceof InputError, error);
      assert.throws(() => nativePlan(scratch, which), Refused);
      return false;
    }
    assert.equal(ours, nativePlan(scratch, which), JSON.stringify(which.mission));
    assert.deepEqual(wb.check(map, ours).violations, []);
    return true;
  } finally {
    map.free();
  }
}

describe("plans equal the command's to the byte", () => {
  it("on drawn maps, by all methods", () => {
    let planned = 0;
    for (let seed = 1; seed <= 120; ++seed) {
      const from = random(seed);
      const [width, height] = [8 + from.below(60), 8 + from.below(60)];
      const blocked = drawnGrid(from, width, height);
      const mission = drawnMission(from, width, height, blocked);
      const options = { connectivity: from.one([4, 4, 8]), ...from.one([{}, {}, { cellSize: 2.5 }]) };
      const which = { name: "drawn.map", map: movingAI(width, height, blocked), mission, options };
      planned += assertEqual(which) ? 1 : 0;
    }
    assert.ok(planned > 80, `${planned}`);
  });

  it("on drawn maps, for each further removal", () => {
    for (let seed = 201; seed <= 215; ++seed) {
      const from = random(seed);
      const [width, height] = [8 + from.below(30), 8 + from.below(30)];
      const blocked = drawnGrid(from, width, height);
      const { agents, ...mission } = drawnMission(from, width, height, blocked);
      const pair = ["ground", "air"].map((kind) => ({ ...agents[0], id: kind, kind }));
      const asMany = 32; // as the command tries with --removals auto
      const rules = { removals: asMany, breach_time: 1 };
      const which = { name: "drawn.map", map: movingAI(width, height, blocked), front: true };
      assertEqual({ ...which, mission: { ...mission, agents: pair, rules, method: {} } });
    }
  });

  for (const [tiff, start, goal] of [
    ["berlin-adlershof.tif", [130, 104], [466, 105]],
    ["andorra.tif", [251, 185], [395, 395]],
    ["berlin-mitte.tif", [485, 101], [425, 488]],
  ]) {
    it(`across ${tiff}, with proof, the paper's and the greedy choice, in time`, () => {
      const map = cityMap(scratch, tiff);
      const agents = [
        { id: "ground", kind: "ground", start, goal },
        { id: "air", kind: "air", start, goal },
      ];
      const paper = { select: "hits", flight: "nearest", planner: "theta", bound: true };
      const inTime = { removals: 1, breach_time: 20, objective: "flowtime" };
      for (const [method, rules] of [
        [{ explain: true }, { removals: 2 }],
        [paper, { removals: 2, timing: "ignore" }],
        [{ select: "greedy" }, { removals: 2 }],
        [{}, inTime],
      ]) {
        const mission = { format: "waybreaker-mission/1", agents, rules, method, limits: { seconds: null } };
        assert.ok(assertEqual({ name: "city.map", map, mission }));
      }
    });
  }
});

it("a picture shows the plan", () => {
  const map = wb.mapFromMovingAI("type octile\nheight 1\nwidth 9\nmap\n....@....\n", { name: "one wall" });
  const agents = ["ground", "air"].map((kind) => ({ id: kind, kind, start: [0, 0], goal: [8, 0] }));
  const plan = wb.plan(map, { format: "waybreaker-mission/1", agents });
  const svg = wb.svg(map, plan);
  assert.match(svg, /^<svg [^]*<title>one wall<\/title>[^]*1 obstacle removed[^]*<\/svg>\n$/);
  assert.equal(svg, wb.svg(map, JSON.stringify(plan)));
});

it("grids and labels give the plans of the file with the same cells", () => {
  for (let seed = 1; seed <= 20; ++seed) {
    const from = random(1000 + seed);
    const [width, height] = [10 + from.below(40), 10 + from.below(40)];
    const blocked = drawnGrid(from, width, height);
    const mission = drawnMission(from, width, height, blocked);
    mission.agents = mission.agents.map(({ radius, ...agent }) => agent);
    const file = wb.mapFromMovingAI(movingAI(width, height, blocked));
    const grid = wb.mapFromGrid(width, height, blocked);
    const labels = wb.mapFromLabels(width, height, file.labels());
    assert.equal(grid.digest, file.digest);
    assert.deepEqual(labels.labels(), file.labels());
    let text;
    try {
      text = wb.planText(file, mission);
    } catch (error) {
      assert.ok(error instanceof InputError);
      assert.throws(() => wb.planText(grid, mission), { message: error.message });
      continue;
    }
    assert.equal(wb.planText(grid, mission), text);
    const { map: _, ...plan } = JSON.parse(text);
    const { map: __, ...labelled } = wb.plan(labels, mission);
    assert.deepEqual(labelled, plan);
  }
});

it("obstacles keep what labels say of them", () => {
  const labels = new Uint32Array(30);
  labels.set([7, 7, 9], 10);
  const map = wb.mapFromLabels(10, 3, labels, {
    attributes: Object.assign([], {
      7: { sourceId: 4711, weight: 2.5, breachTime: 3, destructible: false },
      9: { sourceId: -(2n ** 60n) },
    }),
  });
  assert.equal(map.obstacleCount, 2);
  assert.deepEqual(map.obstacle(1), {
    id: 1,
    cells: 2,
    min: [0, 1],
    max: [1, 1],
    sourceId: 4711,
    weight: 2.5,
    breachTime: 3,
    destructible: false,
  });
  assert.equal(map.obstacle(2).sourceId, -(2n ** 60n));
  assert.equal(map.obstacle(2).weight, 1);
  assert.equal(map.obstacle(3), undefined);
  assert.equal(map.obstacle(0), undefined);
});
