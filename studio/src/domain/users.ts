// For whom obstacles are removed: which vehicles drive where one was.
import type { CellMap } from "./cell_map";
import { type Box, type Point, type Run } from "./geometry";
import type { Plan } from "./plan";

const rounding = 1e-6; // cells

// Ids of the vehicles whose discs, of the radius that `radiusOf` says, come over a cell of each removed obstacle.
export function usersOf(plan: Plan, cells: CellMap, radiusOf: (id: string) => number): ReadonlyMap<number, string[]> {
  const vehicles = plan.agents.filter((agent) => agent.kind === "ground");
  return new Map(
    plan.removed.map(({ obstacle }) => {
      const runs = cells.runsOf(obstacle);
      const users = vehicles.filter(({ id, path }) => runs.some((run) => isCrossed(run, path, radiusOf(id) - rounding)));
      return [obstacle, users.map(({ id }) => id)];
    }),
  );
}

type Path = readonly (readonly [number, number, number])[];

function isCrossed([x, y, length]: Run, path: Path, radius: number): boolean {
  const box = { left: x - 0.5, top: y - 0.5, right: x + length - 0.5, bottom: y + 0.5 };
  for (let i = 1; i < path.length; ++i) {
    const [[ax, ay], [bx, by]] = [path[i - 1]!, path[i]!];
    const isFar = Math.max(ax, bx) + radius < box.left || Math.min(ax, bx) - radius > box.right;
    if (isFar || Math.max(ay, by) + radius < box.top || Math.min(ay, by) - radius > box.bottom) continue;
    if (distance([ax, ay], [bx, by], box) <= Math.max(radius, 0)) return true;
  }
  return false;
}

// Of a segment and a box. It is convex along the segment: golden section would do, and so do thirds.
function distance(a: Point, b: Point, box: Box): number {
  let [from, until] = [0, 1];
  const at = (share: number) => away([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])], box);
  for (let step = 0; step < 40; ++step) {
    const third = (until - from) / 3;
    if (at(from + third) <= at(until - third)) until -= third;
    else from += third;
  }
  return at((from + until) / 2);
}

function away([x, y]: Point, { left, top, right, bottom }: Box): number {
  return Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
}
