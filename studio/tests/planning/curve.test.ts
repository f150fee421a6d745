import { expect, it } from "vitest";
import type { FrontPoint } from "../../src/domain/plan";
import { consistent, Curve } from "../../src/planning/curve";
import { planOf } from "../domain/plans";

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

it("says nothing of what is not known, and goes on past it", () => {
  const unknown: FrontPoint = { ...point(null, null), status: "limit_reached" };
  const points = [point(120, 90), unknown, point(125, 80), unknown];
  const still = { makespan: null, status: "limit_reached" };
  expect(consistent(points, "makespan")).toMatchObject([{ makespan: 120 }, still, { makespan: 120 }, still]);
  const curve = new Curve("", 0);
  curve.add(planOf({ after: null, status: "limit_reached" }));
  curve.add(planOf({ after: 95, removed: [1] }));
  expect(curve.front("makespan").points.map(({ makespan, status }) => [makespan, status])).toEqual([
    [null, "limit_reached"],
    [95, undefined],
  ]);
});

it("a curve without faults stays as it is", () => {
  const points = [point(120, 110), point(100, 95, [1]), point(100, 95, [1, 2])];
  expect(consistent(points, "makespan")).toEqual(points);
});

it("what is proven for fewer removals is not said of more", () => {
  const curve = new Curve("", 0);
  const plan = (removals: number, makespan: number, bound: number) => ({
    ...planOf({ after: makespan, removed: [], options: { removals } }),
    mission: { agents: [], rules: { removals } },
    next: [],
    bound: { makespan: bound, gap: makespan / bound - 1 },
  });
  curve.add({ ...plan(0, 100, 100), limit_reached: true });
  curve.add(plan(1, 120, 80));
  const kept = curve.plans[1]!;
  expect(kept).toMatchObject({ options: { removals: 1 }, mission: { rules: { removals: 1 } }, after: { makespan: 100 } });
  expect(kept.bound).toEqual({ makespan: 80, gap: 0.25 });
  expect(kept).not.toHaveProperty("next");
  expect(kept).not.toHaveProperty("limit_reached");
  expect(curve.front("makespan").points[1]!.bound).toEqual(kept.bound);
  curve.add({ ...plan(2, 130, 70), bound: null, limit_reached: true });
  expect(curve.plans[2]).toMatchObject({ bound: null, limit_reached: true, options: { removals: 2 } });
});

it("a gap is that of the value that it stands beside", () => {
  const [none, one] = consistent([point(100, 50), point(120, 80, [1])], "makespan");
  expect([none!.bound, one!.bound]).toEqual([{ makespan: 80, gap: 0.25 }, { makespan: 80, gap: 0.25 }]);
});

it("takes a better plan that comes later, for more removals as well", () => {
  const curve = new Curve("", 0);
  const plan = (removals: number, after: number) => planOf({ after, removed: [], options: { removals } });
  for (const [removals, after] of [100, 95, 95, 80].entries()) curve.add(plan(removals, after));
  curve.improve(1, plan(1, 90));
  expect(curve.front("makespan").points.map(({ makespan }) => makespan)).toEqual([100, 90, 90, 80]);
  expect(curve.plans[2]!.options.removals).toBe(2);
});
