// A small mission for tests: a rover waits at a wall that a drone opens at 10, and a truck follows it.
import type { Agent, Order, Plan, TimedPoint } from "../../src/domain/plan";
import { planOf } from "../domain/plans";

export function agent(id: string, kind: Agent["kind"], path: TimedPoint[]): Agent {
  const [first, last] = [path[0]!, path.at(-1)!];
  return { id, kind, speed: 1, start: [first[0], first[1]], goal: [last[0], last[1]], path };
}

const rover = agent("rover", "ground", [[0, 0, 0], [4, 0, 4], [4, 0, 10], [12, 0, 18]]);
const truck = agent("truck", "ground", [[0, 4, 0], [4, 4, 4], [4, 4, 12], [4, 0, 16], [12, 0, 24]]);
const drone = agent("drone", "air", [[0, 2, 0], [6, 2, 6], [6, 2, 10], [12, 2, 16]]);

const orders: Order[] = [
  { before: { agent: "drone", point: 2 }, after: { agent: "rover", point: 2 }, why: "opening", obstacle: 7, slack: 0 },
  // The truck turns into the lane once the rover has left it.
  { before: { agent: "rover", point: 2, fraction: 0.25 }, after: { agent: "truck", point: 3 }, why: "passing", slack: 4 },
];

export function yard(): Plan {
  const plan = planOf({ removed: [7], after: 24, before: 40 });
  return {
    ...plan,
    agents: [rover, truck, drone],
    orders,
    removed: [{ ...plan.removed[0]!, at: [6, 2], cleared_at: 10, entered_at: 11, by: "drone" }],
    mission: { agents: [], rules: {} },
  };
}

// What is left of it after a time, the drone's breach failed: around the wall.
export function roundTheWall(now: number, makespan: number): Plan {
  const plan = yard();
  const path: TimedPoint[] = [[4, 0, now], [4, 8, now + 8], [12, 8, now + 16], [12, 0, makespan]];
  return {
    ...plan,
    agents: [agent("rover", "ground", path), agent("truck", "ground", [[4, 4, now], [12, 0, now + 9]])],
    removed: [],
    orders: [],
    after: { ...plan.after, makespan },
    mission: { agents: [], rules: { opened: [] } },
    revision: {
      number: 1,
      sequence: 1,
      now,
      decided: [
        { agent: "rover", point: 0, time: now },
        { agent: "truck", point: 0, time: now + 2 },
      ],
    },
  };
}
