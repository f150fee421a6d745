// The page of a single plan, as `waybreaker plan --html` writes it.
import { expect, it } from "vitest";
import type { MapDescription } from "../../src/domain/map";
import type { FrontPoint } from "../../src/domain/plan";
import { sceneOf } from "../../src/mission/scene_of";
import { viewerOf } from "../../src/mission/viewer";
import { reach } from "../domain/reach_document";
import { planOf } from "../domain/plans";

const map = { id: "m", width: 10, height: 10, cell_size: 1, start: null, goal: null, georeference: null } as MapDescription;
const obstacles = { width: 10, height: 10, obstacles: [], runs: [0, 100] };
const unknown: FrontPoint = {
  makespan: null,
  flowtime: null,
  bound: null,
  removed: [],
  status: "limit_reached",
};

it("has the bands of time that the page was written with", () => {
  const plan = planOf({ after: 80 });
  const document = { map, obstacles, background: { features: [] }, plans: [{ name: "plan" as const, plan }] };
  expect(viewerOf(document).bands.value).toBeNull();
  const page = viewerOf({ ...document, reach });
  expect(page.bands.value!.ends).toEqual([100, 200]);
  expect(sceneOf(page, null)!.bands).toBe(page.bands.value);
});

it("shows what is known of the curve where the time has ended it", () => {
  const plan = planOf({ after: 80, removed: [1, 2] });
  const first: FrontPoint = { makespan: 100, flowtime: 200, bound: null, removed: [] };
  const front = [first, unknown, unknown, unknown];
  const page = viewerOf({ map, obstacles, background: { features: [] }, plans: [{ name: "plan", plan }], front });
  const points = page.results.front.value!.points;
  expect(points.map(({ makespan }) => makespan)).toEqual([100, null, 80, null]);
  expect(points.map(({ status }) => status)).toEqual([undefined, "limit_reached", undefined, "limit_reached"]);
});
