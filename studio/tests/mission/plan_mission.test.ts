// The mission that a plan file says.
import { expect, it } from "vitest";
import { leftOutOfPlan, mapsOfPlan, missionOfPlan } from "../../src/mission/plan_mission";
import { planOf } from "../domain/plans";

it("a plan file whose speeds are all 1 is at 1 m/s, unless its times are seconds", () => {
  const plan = planOf({ after: 9, options: { breach_time: 7, rubble: 3 } });
  plan.map.cell_size = 2;
  expect(missionOfPlan(plan, "m")).toMatchObject({ agents: [{ speed: 1 }, { speed: 1 }], breachTime: 14, rubble: 6 });
  plan.mission = { time_unit: "s", agents: [{}, {}] };
  expect(missionOfPlan(plan, "m")).toMatchObject({ agents: [{ speed: 2 }, { speed: 2 }], breachTime: 7, rubble: 3 });
});

it("a plan file says what was asked beside, and what is left out", () => {
  const plan = planOf({ after: 9, options: { removals: 12, select: "exact", timing: "ignore" } });
  Object.assign(plan.options, { budget_m2: 300, heuristic: "octile", planner: "optimal", corners: "none", connectivity: 4 });
  plan.mission = { agents: [{}, {}], rules: { minimise_demolition: 0.05 }, method: { moves: 4 } };
  const also = { budget_m2: 300, minimise_demolition: 0.05, timing: "ignore", moves: 4 };
  expect(missionOfPlan(plan, "m")).toMatchObject({ method: "exact", also });
  expect(leftOutOfPlan(plan)).toEqual(["12 removals: 8 are the most here"]);
});

it("a plan file says its mission, in metres and seconds", () => {
  const plan = planOf({ after: 9, options: { removals: 4, objective: "flowtime", protect: [3], force: [1], breach_time: 7 } });
  plan.map = { source: "yard.map", width: 10, height: 10, cell_size: 2, digest: `sha256:${"0123456789abcdef".repeat(4)}` };
  plan.agents[0]!.speed = 1.5;
  plan.agents[1]!.goal = [5, 5];
  expect(missionOfPlan(plan, "yard.map")).toMatchObject({
    agents: [
      { start: [0, 0], goal: [9, 0], speed: 3 },
      { start: null, goal: [5, 5], speed: 2 },
    ],
    removals: 4,
    objective: "flowtime",
    breachTime: 7,
    marks: new Map([
      [3, "protect"],
      [1, "force"],
    ]),
  });
  expect(mapsOfPlan(plan)).toEqual(["yard.map", "upload-0123456789abcdef", "upload-0123456789abcdef-8"]);
  expect(missionOfPlan(planOf({ after: null }), "m")).toBeNull();
});

it("a plan file of a team says its mission, in metres and seconds", () => {
  const plan = planOf({ after: 9, options: { removals: 2, radius: 0.5 } });
  plan.map = { source: "yard.map", width: 10, height: 10, cell_size: 2, digest: "sha256:0" };
  const [ground, air] = plan.agents;
  plan.agents = [{ ...ground!, id: "1" }, { ...ground!, id: "2", start: [0, 5], speed: 3 }, { ...air!, id: "air1" }];
  plan.after.routes = [];
  plan.mission = {
    agents: [{ radius: 1.5 }, { radius: 0, ready_at: 4 }, { breaches: 2 }],
    rules: { separation: 0.25, at_goal: "leave" },
  };
  expect(missionOfPlan(plan, "yard.map")).toMatchObject({
    agents: [
      { id: "1", radius: 1.5, speed: 2, readyAt: 0 },
      { id: "2", radius: 0, speed: 6, readyAt: 4, start: [0, 5] },
      { id: "air1", start: null, goal: null, breaches: 2 },
    ],
    separation: 0.25,
    atGoal: "leave",
  });
});
