import { expect, it } from "vitest";
import type { FrontPoint } from "../../src/domain/plan";
import { consistent } from "../../src/planning/curve";

const point = (makespan: number | null, bound: number | null, removed: number[] = []): FrontPoint => ({
  makespan,
  flowtime: null,
  bound: bound === null ? null : { makespan: bound, gap: 0 },
  removed,
});

it("a curve never rises, nor does what bounds it", () => {
  const points = consistent([point(null, 90), point(100, 60, [1]), point(120, 70, [2]), point(95, null)], "makespan");
  expect(points.map(({ makespan }) => makespan)).toEqual([null, 100, 100, 95]);
  expect(points.map(({ bound }) => bound?.makespan ?? null)).toEqual([90, 70, 70, null]);
  expect(points[2]!.removed).toEqual([1]);
});

it("a curve without faults stays as it is", () => {
  const points = [point(120, 110), point(100, 95, [1]), point(100, 95, [1, 2])];
  expect(consistent(points, "makespan")).toEqual(points);
});
