import { describe, expect, it } from "vitest";
import type { Plan } from "../../src/domain/plan";
import { stateOf } from "../../src/rehearse/state";
import { yard } from "./yard";

// Rubble far away says nothing of agents.
function agentsAt(plan: Plan, at: number) {
  return Object.fromEntries(stateOf(plan, { kind: "rubble", runs: [[0, 9, 2]], at }).agents.map((one) => [one.id, one]));
}

describe("the state of a plan", () => {
  it("says between which points each agent is, and where", () => {
    expect(agentsAt(yard(), 3)).toEqual({
      rover: { id: "rover", passed: 0, at: [3, 0], doing: "driving" },
      truck: { id: "truck", passed: 0, at: [3, 4], doing: "driving" },
      drone: { id: "drone", passed: 0, at: [3, 2], doing: "driving" },
    });
  });

  it("has passed a point when it is there", () => {
    expect(agentsAt(yard(), 0).rover).toEqual({ id: "rover", passed: 0, at: [0, 0], doing: "driving" });
    expect(agentsAt(yard(), 16).truck).toEqual({ id: "truck", passed: 3, at: [4, 0], doing: "driving" });
  });

  it("says who waits, who breaches, and who has arrived", () => {
    const half = agentsAt(yard(), 8);
    expect(half.rover).toEqual({ id: "rover", passed: 1, at: [4, 0], doing: "waiting" });
    expect(half.drone).toEqual({ id: "drone", passed: 1, at: [6, 2], doing: "breaching" });
    const late = agentsAt(yard(), 20);
    expect(late.rover).toEqual({ id: "rover", passed: 3, at: [12, 0], doing: "waiting" });
    expect(late.drone).toEqual({ id: "drone", passed: 3, at: [12, 2], doing: "driving" });
  });

  it("has an aircraft that hovers for nothing at no work", () => {
    const plan = yard();
    expect(agentsAt({ ...plan, removed: [] }, 8).drone!.doing).toBe("driving");
    expect(agentsAt({ ...plan, removed: [{ ...plan.removed[0]!, by: "kite" }] }, 8).drone!.doing).toBe("driving");
  });

  it("has a vehicle at work that opens its own way", () => {
    const plan = yard();
    const [rover] = plan.agents;
    const own = { ...rover!, waits: [{ at: [4, 0] as [number, number], from: 4, until: 10, reason: "opening" as const, obstacle: 7, agent: "rover" }] };
    expect(agentsAt({ ...plan, agents: [own] }, 8).rover!.doing).toBe("breaching");
    expect(agentsAt({ ...plan, agents: [own] }, 14).rover!.doing).toBe("driving");
  });

  it("counts reports upwards", () => {
    expect(stateOf(yard(), { kind: "lost", agent: "drone", at: 1 }).sequence).toBe(1);
    const revised = { ...yard(), revision: { number: 2, sequence: 5, now: 0, decided: [] } };
    expect(stateOf(revised, { kind: "lost", agent: "drone", at: 1 }).sequence).toBe(6);
  });
});

describe("news", () => {
  it("of a breach that failed comes when it was to be made", () => {
    const state = stateOf(yard(), { kind: "failed", obstacle: 7, at: 10 });
    expect([state.now, state.failed, state.found]).toEqual([10, [{ obstacle: 7, at: 10 }], []]);
  });

  it("of rubble names its cells", () => {
    const state = stateOf(yard(), { kind: "rubble", runs: [[5, 0, 2], [5, 1, 1]], at: 2 });
    expect(state.found).toEqual([{ cells: [[5, 0], [6, 0], [5, 1]], blocked: true }]);
  });

  it("of an aircraft that is lost says where that was", () => {
    const { agents } = stateOf(yard(), { kind: "lost", agent: "drone", at: 3 });
    expect(agents[2]).toEqual({ id: "drone", passed: 0, at: [3, 2], doing: "lost" });
    expect(agents[0]!.doing).toBe("driving");
  });
});

describe("a delay", () => {
  const delayed = (agent: string, at: number, by: number) => {
    const state = stateOf(yard(), { kind: "delayed", agent, at, by });
    const [rover, truck, drone] = state.agents;
    return { now: state.now, rover, truck, drone };
  };

  it("is known when it is over: the vehicle is where it was", () => {
    const state = delayed("rover", 2, 5);
    expect(state.now).toBe(7);
    expect(state.rover).toEqual({ id: "rover", passed: 0, at: [2, 0], doing: "driving" });
    expect(state.drone).toEqual({ id: "drone", passed: 1, at: [6, 2], doing: "breaching" });
  });

  it("of one that waits anyway changes nothing until it is longer than the wait", () => {
    expect(delayed("rover", 5, 3).rover).toEqual({ id: "rover", passed: 1, at: [4, 0], doing: "waiting" });
    expect(delayed("rover", 5, 9).rover).toEqual({ id: "rover", passed: 2, at: [4, 0], doing: "driving" });
  });

  it("makes those wait that keep to their orders behind it", () => {
    // The rover leaves at 19 and is out of the lane at 21: until then the truck stands at the turn.
    const state = delayed("rover", 9, 10);
    expect(state.now).toBe(19);
    expect(state.truck).toEqual({ id: "truck", passed: 3, at: [4, 0], doing: "waiting" });
    // A delay that leaves the slack as it is makes nobody wait.
    expect(delayed("rover", 9, 5).truck).toEqual({ id: "truck", passed: 2, at: [4, 2], doing: "driving" });
  });

  it("never makes a vehicle leave a place before it was to", () => {
    expect(delayed("truck", 1, 6).truck).toEqual({ id: "truck", passed: 0, at: [1, 4], doing: "driving" });
    const later = stateOf(yard(), { kind: "delayed", agent: "truck", at: 1, by: 2 });
    expect(later.agents[1]).toEqual({ id: "truck", passed: 0, at: [1, 4], doing: "driving" });
  });
});
