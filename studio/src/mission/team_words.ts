// Plans of teams in plain words.
import { type Agents, canOpen } from "../domain/agents";
import { plainName } from "../domain/plain_name";
import { type Agent, objectiveOf, type Plan, valueOf } from "../domain/plan";
import { duration, durations, percent, type Units } from "../domain/units";
import { isWeighed } from "../domain/weights";
import { arrival } from "../play/motion";
import { isNegligible } from "./gain";
import { asGood, counted, type Headline, isProven, soFar, type Telling, unasked } from "./words";

// `closed`: the plan with nothing removed, where it is known; what a team gains is said against it.
export function teamHeadline(plan: Plan, closed: Plan | null, telling: Telling): Headline {
  return telling.isLooking ? soFar(teamHeadlineOf(plan, closed, telling)) : teamHeadlineOf(plan, closed, telling);
}

function teamHeadlineOf(plan: Plan, closed: Plan | null, telling: Telling): Headline {
  const after = valueOf(plan.after, objectiveOf(plan));
  if (after === null || plan.agents.length === 0) return noPlan(plan, telling);
  const vehicles = countOf(plan, "ground");
  const say = (tone: Headline["tone"], title: string, before: number | null = null): Headline => {
    return { tone, title, figures: { after, before }, remedies: [] };
  };
  if (plan.removed.length === 0) return say("plain", unhelped(plan, vehicles, telling));
  const removing = `Removing ${counted(plan.removed.length, telling.buildings)}`;
  if (!closed) return say("plain", `${removing} for ${vehicleCount(vehicles)}`);
  const before = closed.agents.length > 0 ? valueOf(closed.after, objectiveOf(plan)) : null;
  if (before === null) {
    const none = closed.status === "no_plan" ? "there are not" : "were not found";
    return say("good", `${removing} opens ways that ${none} without`);
  }
  if (isNegligible({ before, after }, telling.units)) return asGood(plan, before, closed.after, telling);
  const share = (before - after) / before;
  return say(share > 0 ? "good" : "bad", `${removing} ${gain(plan, share)}`, before);
}

function gain(plan: Plan, share: number): string {
  const size = percent(Math.abs(share));
  const when = `${size} ${share > 0 ? "sooner" : "later"}`;
  if (objectiveOf(plan) === "flowtime" && isWeighed(plan)) return `makes the weighted average arrival ${when}`;
  if (objectiveOf(plan) === "flowtime") return `${share > 0 ? "saves" : "costs"} ${size} of the agents’ time on the way`;
  if (objectiveOf(plan) === "ground-makespan") return `gets the last vehicle there ${when}`;
  return `ends the mission ${when}`;
}

function unhelped(plan: Plan, vehicles: number, { isLooking }: Telling): string {
  if (String(plan.options.select) === "none") return unasked;
  const clears = plan.mission ? canOpen(plan.mission.agents as Agents) : false;
  const mayRemove = (countOf(plan, "air") > 0 || clears) && plan.options.removals !== 0;
  if (!mayRemove && plan.mission?.rules?.collisions === false) return "With nothing removed";
  if (!mayRemove) return vehicles === 1 ? "The vehicle arrives" : `${vehicles === 2 ? "Both" : `All ${vehicles}`} vehicles arrive without touching`;
  const none = isProven(plan) && !isLooking ? "No removal" : "No removal was found that";
  const gains = {
    flowtime: isWeighed(plan) ? "makes the weighted average arrival sooner" : "saves any of the agents’ time on the way",
    "ground-makespan": "gets the last vehicle there sooner",
    makespan: "ends the mission sooner",
  };
  return `${none} ${gains[objectiveOf(plan)]}`;
}

function noPlan(plan: Plan, { isLooking, isFound = false }: Telling): Headline {
  if (plan.status === "no_plan") {
    const remedies = ["Move its start or its goal, or remove it.", "Try smaller vehicles."];
    const passes = plan.mission?.rules?.collisions === false;
    if (passes) remedies.push("Say in the mission settings what a place counts as that is not reached.");
    if (plan.options.removals !== 0) remedies.unshift("Allow more removals, or add aircraft.");
    return { tone: "bad", title: "A vehicle cannot get to its goal", figures: null, remedies };
  }
  const remedies = ["Put starts and goals farther apart from each other.", "Take fewer or smaller vehicles."];
  const ended = isLooking || plan.status === "not_found";
  const title = isFound ? "A plan was found that is not shown yet" : ended ? "No plan was found" : "No plan was found in the time there was";
  return { tone: "bad", title, figures: null, remedies: isLooking ? [] : remedies };
}

// Who arrives last, and what it would be if each were alone, with nothing removed.
export function teamArrivals(plan: Plan, units: Units): string | null {
  if (plan.agents.length < 2) return null;
  const objective = objectiveOf(plan);
  const counts = objective === "ground-makespan" ? plan.agents.filter((agent) => agent.kind === "ground") : plan.agents;
  const last = counts.reduce((a, b) => (arrival(b) > arrival(a) ? b : a));
  const when = objective === "flowtime" ? `, after ${duration(arrival(last), units)}` : "";
  const alone = valueOf(plan.before, objective);
  const what = objective === "flowtime" ? "they would take" : "the last would arrive after";
  const said = valueOf(plan.after, objective) ?? 0; // by the headline
  const compared = alone === null ? "" : ` If each were alone, with nothing removed, ${what} ${durations([alone, said], units)[0]}.`;
  return `${nameOf(last)} arrives last${when}.${compared}`;
}

// A number alone is no name.
function nameOf({ id, kind }: Agent): string {
  return /^\d+$/.test(id) ? `${kind === "ground" ? "Vehicle" : "Aircraft"} ${id}` : plainName(id);
}

function countOf(plan: Plan, kind: Agent["kind"]): number {
  return plan.agents.filter((agent) => agent.kind === kind).length;
}

function vehicleCount(count: number): string {
  return count === 1 ? "one vehicle" : `${count} vehicles`;
}

// How much sooner an agent arrives than in the same team with nothing removed; null where that is not known.
export function gainOf(plan: Plan, closed: Plan | null, id: string): number | null {
  if (!closed || plan.removed.length === 0) return null;
  const [now, then] = [plan, closed].map(({ agents }) => agents.find((agent) => agent.id === id));
  return now && then ? arrival(then) - arrival(now) : null;
}

// When a vehicle would arrive if it were alone and nothing were removed; null where there is no way.
export function aloneArrival(plan: Plan, index: number): number | null {
  const length = plan.before.routes?.[index]?.length;
  const agent = plan.agents[index];
  if (length == null || !agent) return null;
  const said = plan.mission?.agents[index] as { ready_at?: number } | undefined;
  return (said?.ready_at ?? 0) + length / agent.speed;
}
