import { describe, expect, it } from "vitest";
import type { Outcome, Plan } from "../../src/domain/plan";
import type { Units } from "../../src/domain/units";
import { aloneArrival, gainOf, teamArrivals, teamHeadline } from "../../src/mission/team_words";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 1, time: "seconds", seconds: 1 };
const plain = (text: string) => text.replaceAll(/[\u00a0\u202f]/g, " ");

// Two vehicles that arrive at these times, and an aircraft.
function teamOf(arrivals: [number, number], wanted: Parameters<typeof planOf>[0] = {}): Plan {
  const last = Math.max(...arrivals);
  const plan = planOf({ after: last, ...wanted });
  const [ground, air] = plan.agents;
  const outcome = (times: number[]): Outcome => ({
    routes: [{ id: "1", length: times[0]! }, { id: "2", length: times[1]! }, { id: "air1", length: 3 }],
    makespan: Math.max(...times),
    flowtime: times[0]! + times[1]!,
    ground_makespan: Math.max(...times),
  });
  const agents = ground
    ? [
        ...arrivals.map((at, i) => ({ ...ground, id: String(i + 1), path: [[0, 0, 0], [9, 0, at]] as [number, number, number][] })),
        { ...air!, id: "air1", path: [[0, 0, 0], [9, 0, 5]] as [number, number, number][] },
      ]
    : [];
  return { ...plan, agents, before: outcome([100, 60]), after: { ...outcome(arrivals), ...(wanted.after === null && { makespan: null }) } };
}

const closed = teamOf([100, 70]);
it("says what each agent gains", () => {
  const plan = teamOf([90, 75], { removed: [4] });
  expect(["1", "2", "air1", "3"].map((id) => gainOf(plan, closed, id))).toEqual([10, -5, 0, null]);
  expect(gainOf(plan, null, "1")).toBeNull();
  expect(gainOf(teamOf([90, 75]), closed, "1")).toBeNull();
  expect(gainOf(plan, teamOf([1, 1], { after: null }), "1")).toBeNull();
});

const told = { units: city, buildings: true, isLooking: false };
const title = (plan: Plan, other: Plan | null = closed) => plain(teamHeadline(plan, other, told).title);

describe("headline of a team", () => {
  it("says what removals gain against the plan without them", () => {
    expect(title(teamOf([90, 70], { removed: [4] }))).toBe("Removing one building ends the mission 10 % sooner");
    expect(teamHeadline(teamOf([90, 70], { removed: [4] }), closed, told).figures).toEqual({ after: 90, before: 100 });
    expect(title(teamOf([110, 70], { removed: [4] }))).toContain("10 % later");
      const sum = teamOf([90, 63], { removed: [4, 5], options: { objective: "flowtime" } });
    expect(title(sum)).toBe("Removing 2 buildings saves 10 % of the agents’ time on the way");
    expect(title(teamOf([90, 70], { removed: [4], options: { objective: "ground-makespan" } }))).toContain("gets the last vehicle there 10 % sooner");
  });

  it("leads with removing nothing where the last gains nothing, and says what the others do", () => {
    const words = (arrivals: [number, number]) => teamHeadline(teamOf(arrivals, { removed: [4, 5] }), closed, told);
    expect(words([100, 40])).toMatchObject({ tone: "plain", title: "Removing nothing is as good", figures: { after: 100, before: null } });
    expect(plain(words([100, 40]).note!)).toBe(
      "Removing 2 buildings, as shown, gains nothing, and takes 30 s off the sum of all times, 2 min 50 s.",
    );
    expect(plain(words([99.95, 80]).note!)).toBe(
      "Removing 2 buildings, as shown, gains 0.05 %, and adds 10 s to the sum of all times, 2 min 50 s.",
    );
  });

  it("claims nothing that only the end of the search can say", () => {
    const looking = (plan: Plan) => teamHeadline(plan, closed, { ...told, isLooking: true });
    expect(plain(looking(teamOf([90, 70], { removed: [4] })).title)).toBe("So far, removing one building ends the mission 10 % sooner");
    expect(looking(teamOf([100, 70], { gap: 0, options: { removals: 3 } })).title).toBe("So far, no removal was found that ends the mission sooner");
    expect(looking(teamOf([100, 70], { after: null, status: "limit_reached" }))).toMatchObject({
      tone: "plain",
      title: "So far, no plan was found",
      remedies: [],
    });
  });

  it("claims no gain before that plan is known, and no way that may be there", () => {
    expect(title(teamOf([90, 70], { removed: [4] }), null)).toBe("Removing one building for 2 vehicles");
    const none = (status: Plan["status"]) => title(teamOf([90, 70], { removed: [4] }), planOf({ after: null, status }));
    expect(none("no_plan")).toContain("opens ways that there are not without");
    expect(none("limit_reached")).toContain("opens ways that were not found without");
    expect(none("not_found")).toContain("opens ways that were not found without");
  });

  it("says that nothing helps only where that is proven", () => {
    const options = { removals: 3 };
    expect(title(teamOf([100, 70], { gap: 0, options }))).toBe("No removal ends the mission sooner");
    expect(title(teamOf([100, 70], { gap: 0.1, options }))).toBe("No removal was found that ends the mission sooner");
    expect(title(teamOf([100, 70], { options: { removals: 0 } }))).toBe("Both vehicles arrive without touching");
  });

  it("says what can be done where there is no plan", () => {
    expect(title(teamOf([100, 70], { after: null }))).toBe("A vehicle cannot get to its goal");
    expect(title(teamOf([100, 70], { after: null, status: "limit_reached" }))).toBe("No plan was found in the time there was");
    expect(title(teamOf([100, 70], { after: null, status: "not_found" }))).toBe("No plan was found");
  });
});

it("names who arrives last, and what each would need alone", () => {
  expect(plain(teamArrivals(teamOf([90, 120]), city)!)).toBe(
    "Vehicle 2 arrives last. If each were alone, with nothing removed, the last would arrive after 1 min 40 s.",
  );
  expect(plain(teamArrivals(teamOf([90, 70], { options: { objective: "flowtime" } }), city)!)).toBe(
    "Vehicle 1 arrives last, after 1 min 30 s. If each were alone, with nothing removed, they would take 2 min 40 s.",
  );
});

it("knows when each would arrive alone", () => {
  const plan = teamOf([90, 120]);
  plan.agents[1]!.speed = 2;
  plan.mission = { agents: [{}, { ready_at: 7 }, {}] };
  expect([0, 1].map((i) => aloneArrival(plan, i))).toEqual([100, 37]);
  plan.before.routes![0]!.length = null;
  expect(aloneArrival(plan, 0)).toBeNull();
});
