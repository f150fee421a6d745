// Plans for tests: only what the page reads.
import type { Plan } from "../../src/domain/plan";

interface Wanted {
  removed?: number[];
  before?: number | null;
  after?: number | null;
  gap?: number | null;
  status?: Plan["status"];
  air?: number;
  options?: Plan["options"];
}

export function planOf({
  removed = [],
  before = 100,
  after = 100,
  gap = null,
  status,
  air,
  options = {},
}: Wanted): Plan {
  const outcome = (makespan: number | null) => ({
    ground: { length: makespan, expanded: 0, generated: 0 },
    air: { length: 1 },
    makespan,
    flowtime: makespan === null ? null : 2 * makespan,
    ground_makespan: makespan,
  });
  const agent = (kind: "ground" | "air", end: number): Plan["agents"][number] => ({
    id: kind,
    kind,
    speed: 1,
    start: [0, 0],
    goal: [9, 0],
    path: [
      [0, 0, 0],
      [9, 0, end],
    ],
  });
  return {
    format: "waybreaker-plan/1",
    status: status ?? (after === null ? "no_plan" : "solved"),
    map: { source: "m", width: 10, height: 10, cell_size: 1, digest: "" },
    options: { objective: "makespan", removals: removed.length, ...options },
    before: outcome(before),
    after: outcome(after),
    bound: gap === null ? null : { gap },
    removed: removed.map((obstacle, i) => ({
      obstacle,
      cells: 1,
      hits: 0,
      at: [0, 0],
      cleared_at: 10 * (i + 1),
      entered_at: 10 * (i + 1) + 5,
    })),
    agents: after === null ? [] : [agent("ground", after), agent("air", air ?? after)],
  };
}
