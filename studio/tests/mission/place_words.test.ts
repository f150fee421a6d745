import { expect, it } from "vitest";
import { changed, isPair, pair } from "../../src/domain/agents";
import { freshMission, shownPer } from "../../src/domain/mission";
import type { Agent, Plan } from "../../src/domain/plan";
import type { Units } from "../../src/domain/units";
import { reachOf, reachWords } from "../../src/mission/place_words";
import { teamHeadline } from "../../src/mission/team_words";
import { questionOf } from "../../src/planning/request";
import { duration, waits } from "../../src/play/motion";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 2, time: "seconds", seconds: 1 };

// By place: when it is reached; null where it is not.
function placesOf(times: Record<string, number | null>, inbound = false): Plan {
  const plan = planOf({ after: 9, removed: [4], options: { objective: "flowtime" } });
  const agents = Object.entries(times).map(([id, at], i): Agent => {
    const [base, place] = [[0, 0], [9, i]] as const;
    const ends = inbound ? { start: [...place], goal: [...base] } : { start: [...base], goal: [...place] };
    const path: Agent["path"] = [[0, 0, 0], at === null ? [0, 0, 600] : [9, i, at]];
    return { ...plan.agents[0]!, id, ...(ends as Pick<Agent, "start" | "goal">), path, ...(at === null && { reached: false }) };
  });
  const sum = agents.reduce((all, { path }) => all + path.at(-1)![2], 0);
  const after = { routes: [], makespan: 600, ground_makespan: 600, flowtime: sum };
  const said = agents.map(({ id }) => ({ id, weight: 2 }));
  return { ...plan, agents, after, mission: { agents: said, rules: { collisions: false } } };
}

const before = placesOf({ school: 100, mill: null, yard: null, inn: 50 });
const plan = placesOf({ school: 90, mill: 300, yard: null, inn: 50 });

it("tells places that are reached, sooner, only now, or not", () => {
  expect([...reachOf(plan, before)!.states.values()]).toEqual(["sooner", "only now", "not reached", "as before"]);
  expect(reachWords(reachOf(plan, before)!)).toBe("3 of 4 places are reached, 1 of them sooner, 1 only now. Not reached: yard.");
  expect(reachWords(reachOf(placesOf({ a: 1, b: 2 }), null)!)).toBe("All 2 places are reached.");
  const missed = Object.fromEntries(Array.from({ length: 6 }, (_, i) => [`p${i}`, null]));
  expect(reachWords(reachOf(placesOf(missed), null)!)).toBe("0 of 6 places are reached. Not reached: p0, p1, p2, p3 and 2 more.");
  expect(reachOf({ ...plan, mission: { agents: [] } }, before)).toBeNull();
  expect([reachOf(plan, null)!.end, reachOf(placesOf({ a: 1, b: 2 }, true), null)!.end]).toEqual(["goal", "start"]);
});

it("plays until the last place is reached, and nobody waits to be left", () => {
  expect(duration(plan)).toBe(300);
  expect(plan.agents.map((agent) => waits(agent).length)).toEqual([0, 0, 0, 0]);
});

it("shows averages where arrivals count by weights", () => {
  const fresh = freshMission("m", { start: [0, 0], goal: [9, 9] });
  const weighed = { ...fresh, agents: changed(fresh.agents, 0, { weight: 4 }), objective: "flowtime" as const };
  expect([shownPer(fresh), shownPer(weighed), shownPer({ ...weighed, objective: "makespan" })]).toEqual([1, 5, 1]);
  expect(questionOf(weighed, city, "m", (key) => key).price).toBe(5 * fresh.price);
  const words = teamHeadline(plan, before, { units: { ...city, seconds: 1 / 8 }, buildings: false, isLooking: false });
  expect(words.title.replaceAll("\u00a0", " ")).toBe("Removing one obstacle makes the weighted average arrival 23 % sooner");
});

it("two that do not count alike are a team, which the paper's method does not know", () => {
  const two = pair([0, 0], [9, 9]);
  expect([isPair(two), isPair(changed(two, 1, { weight: 0 }))]).toEqual([true, false]);
  const paper = { ...freshMission("m", { start: [0, 0], goal: [9, 9] }), method: "paper" as const, collisions: false };
  const asked = (unreached: number | null) => questionOf({ ...paper, unreached }, city, "m", (key) => key);
  expect([asked(null).method, asked(90).method]).toEqual(["paper", "exact"]);
  expect(asked(90).mission.rules).toEqual({ separation: 0, at_goal: "stay", collisions: false, unreached: 90 });
});
