import { describe, expect, it } from "vitest";
import type { Agent, Plan } from "../../src/domain/plan";
import { activityAt, lanes } from "../../src/play/activity";
import { Story } from "../../src/play/story";
import { mapOf } from "../domain/picture";
import { breachOrder, clearedAt, duration, positionAt, splitAt, waits } from "../../src/play/motion";

const ground: Agent = {
  id: "A",
  kind: "ground",
  speed: 1,
  start: [0, 0],
  goal: [6, 4],
  path: [
    [0, 0, 0],
    [6, 0, 6],
    [6, 0, 8],
    [6, 0, 9],
    [6, 4, 13],
  ],
};
const air: Agent = {
  id: "B",
  kind: "air",
  speed: 2,
  start: [0, 0],
  goal: [6, 4],
  path: [
    [0, 0, 0],
    [6, 2, 4],
    [6, 2, 9],
    [6, 4, 10],
  ],
};
const plan = {
  options: {},
  agents: [ground, air],
  removed: [
    { obstacle: 7, cells: 1, hits: 0, at: [6, 2], cleared_at: 9, entered_at: 10 },
    { obstacle: 3, cells: 1, hits: 0, at: [3, 1], cleared_at: 2, entered_at: null },
  ],
} as unknown as Plan;

describe("an agent", () => {
  it("is on its path in proportion to the time", () => {
    expect(positionAt(ground, 3)).toMatchObject({ x: 3, y: 0, heading: 0, state: "moving" });
    expect(positionAt(air, 1)).toMatchObject({ x: 1.5, y: 0.5 });
    expect(positionAt(ground, 11)).toMatchObject({ x: 6, y: 2, heading: Math.PI / 2 });
  });

  it("stands at the ends before and after", () => {
    expect(positionAt(ground, -5)).toMatchObject({ x: 0, y: 0, state: "ready" });
    expect(positionAt(ground, 13)).toMatchObject({ x: 6, y: 4, heading: Math.PI / 2, state: "arrived" });
    expect(positionAt(ground, 99)).toMatchObject({ x: 6, y: 4, state: "arrived" });
    expect(positionAt({ ...ground, path: [] }, 1)).toBeNull();
  });

  it("waits where two points are the same, looking where it will go", () => {
    expect(positionAt(ground, 7)).toMatchObject({ x: 6, y: 0, heading: Math.PI / 2, state: "waiting" });
    expect(waits(ground)).toEqual([{ at: [6, 0], from: 6, until: 9 }]);
    expect(waits(air)).toEqual([{ at: [6, 2], from: 4, until: 9 }]);
  });

  it("is never anywhere else between its points", () => {
    for (const agent of [ground, air]) {
      for (let t = 0; t < 14; t += 0.1) {
        const now = positionAt(agent, t)!;
        const soon = positionAt(agent, t + 0.01)!;
        expect(Math.hypot(soon.x - now.x, soon.y - now.y)).toBeLessThanOrEqual(0.01 * agent.speed + 1e-9);
      }
    }
  });

  it("has its way split in two where it is", () => {
    expect(splitAt(ground, 3)).toEqual({
      travelled: [
        [0, 0],
        [3, 0],
      ],
      ahead: [
        [3, 0],
        [6, 0],
        [6, 0],
        [6, 0],
        [6, 4],
      ],
    });
  });
});

describe("a plan", () => {
  it("lasts until the last agent has arrived", () => {
    expect(duration(plan)).toBe(13);
    expect(duration({ ...plan, agents: [] })).toBe(0);
  });

  it("knows what is cleared when, and in which order", () => {
    expect([1, 2, 9].map((t) => clearedAt(plan, t).map(({ obstacle }) => obstacle))).toEqual([[], [3], [7, 3]]);
    expect(breachOrder(plan).map(({ obstacle }) => obstacle)).toEqual([3, 7]);
  });

  it("has a lane for each agent, without gaps", () => {
    const [first, second] = lanes(plan);
    expect(first!.spans.map(({ kind, from, until }) => [kind, from, until])).toEqual([
      ["move", 0, 6],
      ["wait", 6, 9],
      ["move", 9, 13],
    ]);
    expect(first!.moments).toEqual([{ number: 2, obstacle: 7, time: 10 }]);
    expect(second!.moments.map(({ number, time }) => [number, time])).toEqual([
      [1, 2],
      [2, 9],
    ]);
  });

  it("of a team has a number in the lane of the aircraft that breaches, and nobody's entry", () => {
    const [one, two] = plan.agents;
    const agents = [{ ...two!, id: "air1" }, { ...two!, id: "air2" }, { ...one!, id: "1" }];
    const removed = plan.removed.map((each, i) => ({ ...each, by: i === 0 ? "air1" : "air2" }));
    const moments = lanes({ ...plan, agents, removed }).map(({ id, moments }) => [id, moments.map(({ obstacle }) => obstacle)]);
    expect(moments).toEqual([["1", []], ["air1", [plan.removed[0]!.obstacle]], ["air2", [plan.removed[1]!.obstacle]]]);
  });

  it("says what goes on", () => {
    const story = new Story(plan, mapOf("a.b.c..", "d.e.f..", "......g"));
    expect(activityAt(story, 0.5)).toBe("A moves, B moves, 0 of 2 removed");
    expect(activityAt(story, 8)).toBe("A waits for the aircraft to open 2, B opens 2, 1 of 2 removed");
    expect(activityAt(story, 12)).toBe("A moves, B has arrived, 2 of 2 removed");
    expect(story.at(0.5)).toBeNull();
    expect(story.at(8)).toBe("A waits for the aircraft to open 2; B opens 2");
  });

  it("says who waits for whom, and is brief where many do", () => {
    const truck = (id: string, y: number): Agent => ({ ...ground, id, path: [[0, y, 0], [2, y, 2], [2, y, 6], [9, y, 13]] });
    const rover: Agent = { ...ground, id: "9", path: [[4, -4, 2], [4, 5, 11]] };
    const told = (...agents: Agent[]) => {
      return new Story({ ...plan, agents, removed: [] }, mapOf(".........")).at(3);
    };
    expect(told(truck("truck", 0), rover)).toBe("truck lets vehicle 9 pass");
    expect(told(rover)).toBeNull();
    const trucks = [10, 20, 30, 40, 50].map((y, i) => truck(String(i + 1), y));
    expect(told(...trucks)).toBe("vehicle 1 waits; vehicle 2 waits; vehicle 3 waits; 2 more wait");
  });
});
