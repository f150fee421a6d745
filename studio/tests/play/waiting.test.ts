// Who waits for whom.
import { describe, expect, it } from "vitest";
import type { Agent, Plan, Removed, TimedPoint } from "../../src/domain/plan";
import { waits } from "../../src/play/motion";
import { Waiting } from "../../src/play/waiting";
import { mapOf } from "../domain/picture";

const vehicle = (id: string, path: TimedPoint[]): Agent => {
  const [start, goal] = [path[0]!, path.at(-1)!].map(([x, y]) => [x, y] as [number, number]);
  return { id, kind: "ground", speed: 1, start: start!, goal: goal!, path };
};
const removed = (obstacle: number, cleared_at: number, by?: string): Removed =>
  ({ obstacle, cleared_at, entered_at: null, ...(by && { by }) }) as Removed;

interface Wanted {
  agents: Agent[];
  removed?: Removed[];
  radii?: number[];
  rules?: Record<string, unknown>;
}

// The causes of the first agent's waits.
function causes({ agents, removed = [], radii = [], rules = {} }: Wanted, map = mapOf("..........")) {
  const mission = { agents: agents.map((_, i) => ({ radius: radii[i] ?? 0.5 })), rules };
  const waiting = new Waiting({ agents, removed, options: {}, mission } as unknown as Plan, map);
  return waits(agents[0]!).map((wait) => waiting.causeOf(agents[0]!, wait));
}

const wall = mapOf(".....a....", ".....a....", ".....a....", "..........");

describe("a vehicle waits", () => {
  it("for what is opened just before it gets there, wherever it stands", () => {
    // Its disc reaches the wall, whose side is at 4.5, with its middle at 4: 2 s after it goes on.
    const truck = vehicle("truck", [[0, 1, 0], [2, 1, 2], [2, 1, 8], [3, 1, 9], [9, 1, 15]]);
    const opened = removed(1, 10, "heli");
    expect(causes({ agents: [truck], removed: [opened] }, wall)).toEqual([{ kind: "opening", removed: opened }]);
    expect(causes({ agents: [truck], removed: [opened], radii: [0] }, wall)).toEqual([{ kind: "opening", removed: opened }]);
    expect(causes({ agents: [truck], removed: [removed(1, 1)] }, wall)).toEqual([null]); // open long before
  });

  it("not for what it only passes", () => {
    const below = vehicle("truck", [[0, 3, 0], [2, 3, 2], [2, 3, 8], [9, 3, 15]]); // touches the wall's foot
    expect(causes({ agents: [below], removed: [removed(1, 10)] }, wall)).toEqual([null]);
  });

  it("for the one that it lets pass", () => {
    const truck = vehicle("truck", [[0, 0, 0], [2, 0, 2], [2, 0, 6], [9, 0, 13]]);
    const crossing = vehicle("rover", [[4, -4, 2], [4, 5, 11]]); // is clear of the road after 7
    const far = vehicle("van", [[1, 3, 0], [3, 3, 13]]); // nearer all the time, and in nobody's way
    expect(causes({ agents: [truck, far, crossing] })).toEqual([{ kind: "vehicle", id: "rover" }]);
    expect(causes({ agents: [truck, far] })).toEqual([null]);
    expect(causes({ agents: [truck, far], rules: { separation: 2.5 } })).toEqual([{ kind: "vehicle", id: "van" }]);
  });

  it("for one that stands in its way until it leaves, or vanishes", () => {
    const truck = vehicle("truck", [[0, 0, 0], [2, 0, 2], [2, 0, 6], [9, 0, 13]]);
    const late = vehicle("rover", [[4, 0, 7], [4, 5, 12]]);
    expect(causes({ agents: [truck, late] })).toEqual([{ kind: "vehicle", id: "rover" }]);
    const arrived = vehicle("rover", [[4, 5, 0], [4, 0, 7]]);
    expect(causes({ agents: [truck, arrived], rules: { at_goal: "leave" } })).toEqual([{ kind: "vehicle", id: "rover" }]);
    expect(causes({ agents: [truck, { ...arrived, path: [[4, 5, 0], [4, 0, 2]] }], rules: { at_goal: "leave" } })).toEqual([null]);
  });

  it("or, if it flies, opens what it hovers at", () => {
    const heli: Agent = { ...vehicle("heli", [[0, 0, 0], [5, 0, 2], [5, 0, 7], [5, 0, 9], [9, 0, 11]]), kind: "air" };
    const opened = { ...removed(1, 7, "heli"), at: [5, 0] } as Removed;
    expect(causes({ agents: [heli], removed: [{ ...opened, by: "drone" }, opened] })).toEqual([{ kind: "breach", removed: opened }]);
    expect(causes({ agents: [heli], removed: [{ ...opened, by: "drone" }] })).toEqual([null]);
  });

  it("before another wait for what that one is for", () => {
    const truck = vehicle("truck", [[0, 1, 0], [0, 1, 3], [2, 1, 5], [2, 1, 8], [9, 1, 15]]);
    const opened = removed(1, 10, "heli");
    expect(causes({ agents: [truck], removed: [opened] }, wall)).toEqual(Array(2).fill({ kind: "opening", removed: opened }));
  });
});
