import { describe, expect, it } from "vitest";
import type { Cell } from "../../src/domain/geometry";
import type { Agent, ExplainedWait, Plan } from "../../src/domain/plan";
import { activityAt, lanes } from "../../src/play/activity";
import { Story } from "../../src/play/story";
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

  it("shows of who is not reached what it drove before that was known", () => {
    const [first, second] = plan.agents as [Agent, Agent];
    const left: Agent = { ...first, reached: false, path: [[0, 0, 0], [3, 0, 3], [3, 0, 4], [3, 0, 60]] };
    const never: Agent = { ...second, reached: false, path: [[0, 0, 0], [0, 0, 60]] };
    expect(duration({ ...plan, agents: [left, never] })).toBe(3);
    expect(lanes({ ...plan, agents: [left, never] }).map(({ spans }) => spans)).toEqual([[{ kind: "move", from: 0, until: 3 }], []]);
    expect(waits(left)).toEqual([]);
  });

  it("of a team has a number in the lane of the aircraft that breaches, and nobody's entry", () => {
    const [one, two] = plan.agents;
    const agents = [{ ...two!, id: "air1" }, { ...two!, id: "air2" }, { ...one!, id: "1" }];
    const removed = plan.removed.map((each, i) => ({ ...each, by: i === 0 ? "air1" : "air2" }));
    const moments = lanes({ ...plan, agents, removed }).map(({ id, moments }) => [id, moments.map(({ obstacle }) => obstacle)]);
    expect(moments).toEqual([["1", []], ["air1", [plan.removed[0]!.obstacle]], ["air2", [plan.removed[1]!.obstacle]]]);
  });

  it("says what goes on", () => {
    const waiting: Agent = { ...ground, waits: [{ at: [6, 0], from: 6, until: 9, reason: "opening", obstacle: 7, agent: "B" }] };
    const story = new Story({ ...plan, agents: [waiting, air] });
    expect(activityAt(story, 0.5)).toBe("A moves, B moves, 0 of 2 removed");
    expect(activityAt(story, 8)).toBe("A waits for B to open 2, B opens 2, 1 of 2 removed");
    expect(activityAt(story, 12)).toBe("A moves, B has arrived, 2 of 2 removed");
    expect(story.at(0.5)).toBeNull();
    expect(story.at(8)).toBe("A waits for B to open 2; B opens 2");
  });

  it("says what the plan says each waits for, and is brief where many do", () => {
    const truck = (id: string, ...waits: Partial<ExplainedWait>[]): Agent => {
      const whole = waits.map((wait) => ({ at: [2, 0], from: 2, until: 6, ...wait }) as ExplainedWait);
      return { ...ground, id, path: [[0, 0, 0], [2, 0, 2], [2, 0, 6], [9, 0, 13]], ...(waits.length > 0 && { waits: whole }) };
    };
    const told = (...agents: Agent[]) => new Story({ ...plan, agents }).at(3);
    expect(told(truck("truck", { reason: "agent", agent: "9" }))).toBe("truck lets vehicle 9 pass");
    expect(told(truck("truck", { reason: "readiness" }))).toBe("truck is not ready yet");
    expect(told(truck("truck", { reason: "nothing" }))).toBe("truck waits");
    expect(told(truck("truck", { reason: "rubble", obstacle: 7 }))).toBe("truck gets over the rubble of 2");
    expect(told(truck("truck", { reason: "rubble", obstacle: 99 }))).toBe("truck gets over rubble");
    expect(told(truck("truck", { reason: "zone", zone: 2 }))).toBe("truck waits until zone 2 is over");
    expect(told(truck("ground", { reason: "opening", obstacle: 7, agent: "air" }))).toBe("the ground robot waits for the aircraft to open 2");
    expect(told({ ...ground, path: [[4, -4, 2], [4, 5, 11]] })).toBeNull();
    const trucks = ["1", "2", "3", "4", "5"].map((id) => truck(id));
    expect(told(...trucks)).toBe("vehicle 1 waits; vehicle 2 waits; vehicle 3 waits; 2 more wait");
  });

  it("says where an aircraft recharges, while it does", () => {
    const recharges = [{ at: [6, 2] as Cell, from: 4, until: 8, flown: 4 }];
    const story = new Story({ ...plan, agents: [ground, { ...air, recharges }] });
    expect([1, 5, 8].map((time) => activityAt(story, time).split(", ")[1])).toEqual(["B moves", "B recharges at 6,2", "B opens 2"]);
    expect(story.at(5)).toBe("B recharges at 6,2");
    expect(new Story({ ...plan, agents: [{ ...air, id: "air", recharges }] }).at(7.5)).toBe("the aircraft recharges at 6,2");
  });

  it("opens for as long as that takes itself, whatever the rules say", () => {
    const own = { options: { breach_time: 1 }, mission: { agents: [{ id: "A" }, { id: "B", breach_time: 5 }] } };
    const story = new Story({ ...plan, ...own });
    expect([3.9, 4.5, 8.9, 9.1].map((time) => activityAt(story, time).split(", ")[1])).toEqual(["B moves", "B opens 2", "B opens 2", "B moves"]);
    expect(lanes(story.plan)[1]!.spans).toContainEqual({ kind: "wait", from: 4, until: 9 });
    const breaks: ExplainedWait = { at: [6, 0], from: 6, until: 9, reason: "opening", obstacle: 7, agent: "A" };
    const alone = new Story({ ...plan, ...own, agents: [{ ...ground, waits: [breaks] }] });
    expect([6.5, 8.9].map((time) => alone.at(time))).toEqual(["A opens 2", "A opens 2"]);
  });

  it("tells the reasons of one wait apart", () => {
    const parts: ExplainedWait[] = [
      { at: [6, 0], from: 6, until: 7, reason: "agent", agent: "9" },
      { at: [6, 0], from: 7, until: 9, reason: "opening", obstacle: 7, agent: "B" },
    ];
    const story = new Story({ ...plan, agents: [{ ...ground, waits: parts }, air] });
    expect(lanes(story.plan)[0]!.spans.filter(({ kind }) => kind === "wait")).toMatchObject([{ from: 6, until: 7 }, { from: 7, until: 9 }]);
    expect([6.5, 8].map((time) => story.verbAt("A", time))).toEqual(["lets vehicle 9 pass", "waits for B to open 2"]);
  });

  it("says of an aircraft what it opens where it hovers", () => {
    const one = { obstacle: 1, by: "B", at: [6, 2], cleared_at: 7 };
    const story = new Story({ ...plan, removed: [one, { ...one, obstacle: 2, by: "C", cleared_at: 8 }] } as Plan);
    expect([1, 5, 8].map((time) => story.verbAt("B", time))).toEqual(["waits", "opens 1", "waits"]);
  });
});
