import { expect, it } from "vitest";
import type { TimedPoint } from "../../src/domain/plan";
import { usersOf } from "../../src/domain/users";
import { mapOf } from "./picture";
import { planOf } from "./plans";

it("for whom an obstacle is removed are those whose discs come over it", () => {
  const cells = mapOf("......", "..a...", "......", "......");
  const paths: Record<string, TimedPoint[]> = {
    through: [[0, 1, 0], [5, 1, 5]],
    corner: [[0, 0, 0], [2, 2, 3], [5, 2, 6]],
    beside: [[0, 2, 0], [5, 2, 5]], // touches it, and may
    far: [[0, 3, 0], [5, 3, 5]],
  };
  const plan = planOf({ removed: [1] });
  plan.agents = Object.entries(paths).map(([id, path]) => ({ ...plan.agents[0]!, id, path }));
  expect(usersOf(plan, cells, () => 0.5).get(1)).toEqual(["through", "corner"]);
  expect(usersOf(plan, cells, () => 0.6).get(1)).toEqual(["through", "corner", "beside"]);
  expect(usersOf(plan, cells, () => 0).get(1)).toEqual(["through"]);
});
