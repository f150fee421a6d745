// Plans in plain words: what the person reads first.
import { isTeam, objectiveOf, type Plan, valueOf } from "../domain/plan";
import { difference, durations, percent, percentUp, type Units } from "../domain/units";
import { agentOf, arrival } from "../play/motion";
import { gainWords, isNegligible } from "./gain";

export interface Headline {
  tone: "good" | "plain" | "bad";
  title: string;
  // The result, and the result without removals: shown large, as figures.
  figures: { after: number; before: number | null } | null;
  note?: string; // what else is to be said of the removals
  remedies: string[]; // what can be done where there is no plan
}

// How a plan is told.
export interface Telling {
  units: Units;
  buildings: boolean; // whether all that is removed is sure to be buildings
  isLooking: boolean; // whether a better plan may follow: then nothing is said that only the end of the search can say
  isFound?: boolean; // whether there is one already that is not shown yet
}

export interface Proof {
  tone: "sure" | "plain" | "unsure";
  text: string;
}

const few = ["no", "one", "2", "3", "4", "5", "6", "7", "8"];

// Only where the map knows them from OpenStreetMap are obstacles sure to be buildings.
export function nounOf(count: number, buildings: boolean): string {
  const noun = buildings ? "building" : "obstacle";
  return count === 1 ? noun : `${noun}s`;
}

export function counted(count: number, buildings: boolean): string {
  return `${few[count] ?? count} ${nounOf(count, buildings)}`;
}

// What all removals together save; null where that is nothing, or there is no way without.
export function savedBy(plan: Plan, units: Units): string | null {
  if (isTeam(plan)) return null; // its plan file compares with each alone
  const [before, after] = [valueOf(plan.before, objectiveOf(plan)), valueOf(plan.after, objectiveOf(plan))];
  return before === null || after === null || before <= after ? null : difference(after, before, units);
}

export function headline(plan: Plan, telling: Telling): Headline {
  return telling.isLooking ? soFar(headlineOf(plan, telling)) : headlineOf(plan, telling);
}

// As long as a better plan may follow.
export function soFar(words: Headline): Headline {
  const { tone, title } = words;
  return { ...words, tone: tone === "bad" ? "plain" : tone, title: `So far, ${title.charAt(0).toLowerCase()}${title.slice(1)}` };
}

function headlineOf(plan: Plan, telling: Telling): Headline {
  const { buildings, units } = telling;
  const objective = objectiveOf(plan);
  const before = valueOf(plan.before, objective);
  const after = valueOf(plan.after, objective);
  const count = plan.removed.length;
  if (after === null || plan.agents.length === 0) return without(plan, telling);
  const figures = { after, before };
  const removing = `Removing ${counted(count, buildings)}`;
  if (count === 0) return { tone: "plain", title: unhelped(plan, telling), figures: { after, before: null }, remedies: [] };
  if (before === null) {
    const none = plan.limit_reached ? "was not found" : "there is not";
    return { tone: "good", title: `${removing} opens a way that ${none} without`, figures, remedies: [] };
  }
  if (isNegligible({ before, after }, units)) {
    return asGood(plan, before, { flowtime: plan.before.flowtime }, telling);
  }
  const share = (before - after) / before;
  const change = `${percent(Math.abs(share))} ${share > 0 ? "sooner" : "later"}`;
  const tone = share > 0 ? "good" : "bad";
  if (objective === "flowtime") {
    const title = `${removing} ${share > 0 ? "saves" : "costs"} ${percent(Math.abs(share))} of the agents’ time on the way`;
    return { tone, title, figures, remedies: [] };
  }
  const what = isAirsArrival(plan) ? "ends the mission" : "gets the ground robot there";
  return { tone, title: `${removing} ${what} ${change}`, figures, remedies: [] };
}

// Nothing is worth a building that nobody notices. `before` is the objective with nothing removed, and the sum of all times.
export function asGood(plan: Plan, before: number, { flowtime }: { flowtime: number | null }, telling: Telling): Headline {
  const after = valueOf(plan.after, objectiveOf(plan))!;
  const said = gainWords({ before, after }, { before: flowtime, after: plan.after.flowtime }, telling.units);
  const count = counted(plan.removed.length, telling.buildings);
  return {
    tone: "plain",
    title: "Removing nothing is as good",
    figures: { after: before, before: null },
    note: `Removing ${count}, as shown, ${said}.`,
    remedies: [],
  };
}

// The result, and that without removals if it is known.
export function figureTexts({ after, before }: NonNullable<Headline["figures"]>, units: Units): string[] {
  return durations(before === null ? [after] : [after, before], units);
}

// “16 min 15 s instead of 20 min 55 s”
export function figuresText(figures: NonNullable<Headline["figures"]>, units: Units): string {
  return figureTexts(figures, units).join(" instead of ");
}

export const unasked = "No removals were asked for";

function unhelped(plan: Plan, { isLooking }: Telling): string {
  if (String(plan.options.select) === "none") return unasked;
  if (plan.options.removals === 0) return "With nothing removed, the ground robot takes the way round";
  const none = isProven(plan) && !isLooking ? "No removal" : "No removal was found that";
  if (objectiveOf(plan) === "flowtime") return `${none} saves any of the agents’ time on the way`;
  return isAirsArrival(plan) ? `${none} ends the mission sooner` : `${none} gets the ground robot there sooner`;
}

// Who arrives when, as far as the figures do not say so.
export function arrivals(plan: Plan, units: Units): string | null {
  const [ground, air] = [agentOf(plan, "ground"), agentOf(plan, "air")];
  if (!ground || !air) return null;
  const last = valueOf(plan.after, objectiveOf(plan)) ?? 0; // what the headline says
  const after = (agent: typeof ground) => `after ${durations([arrival(agent), last], units)[0]}`;
  if (objectiveOf(plan) === "flowtime") return `The ground robot is there ${after(ground)}, the aircraft ${after(air)}.`;
  if (objectiveOf(plan) === "ground-makespan") return `The aircraft is there ${after(air)}.`;
  const who = lastOf(plan);
  if (who === "both") return "Both arrive then.";
  if (who === "air") return `The aircraft arrives last; the ground robot is there ${after(ground)}.`;
  return `The ground robot arrives last; the aircraft is there ${after(air)}.`;
}

function isAirsArrival(plan: Plan): boolean {
  return objectiveOf(plan) === "makespan" && lastOf(plan) === "air";
}

// The agent that arrives last; both if the difference is too small to see.
function lastOf(plan: Plan): "ground" | "air" | "both" {
  const [ground, air] = (["ground", "air"] as const).map((kind) => {
    const agent = agentOf(plan, kind);
    return agent ? arrival(agent) : 0;
  });
  if (Math.abs(ground! - air!) <= 0.001 * air!) return "both";
  return ground! > air! ? "ground" : "air";
}

function without(plan: Plan, { buildings, isLooking, isFound = false }: Telling): Headline {
  const allowed = plan.options.removals ?? 0;
  if (plan.status !== "no_plan") {
    const tried = ["Ask for fewer removals.", "Move start and goal nearer to each other."];
    const ended = isLooking || plan.status === "not_found";
    const title = isFound ? "A way was found that is not shown yet" : ended ? "No way was found" : "No way was found in the time there was";
    return { tone: "bad", title, figures: null, remedies: isLooking ? [] : tried };
  }
  const remedies = ["Move the start or the goal."];
  if (allowed < 8) remedies.unshift("Allow more removals.");
  if ((plan.options.protect ?? []).length > 0) remedies.push("Protect fewer of them.");
  if ((plan.options.radius ?? 0) > 0) remedies.push("Try a smaller robot, in the mission settings.");
  const how = allowed === 0 ? "with nothing removed" : `even with ${counted(allowed, buildings)} removed`;
  return { tone: "bad", title: `The ground robot cannot get there, ${how}`, figures: null, remedies };
}

const proven = 1e-9; // a gap that is none
const wide = 0.01; // a gap that says little

export function isProven({ bound }: Plan): boolean {
  return (bound?.gap ?? 1) < proven;
}

// Whether what is proven leaves next to nothing to gain.
export function isSure(plan: Plan): boolean {
  return proof(plan)?.tone === "sure";
}

// How good the choice is known to be. The gap is what is proven; the choice may be better than that.
export function proof(plan: Plan): Proof | null {
  if (plan.agents.length === 0) return null;
  const gap = plan.bound?.gap;
  if (gap === null || gap === undefined) {
    return { tone: "unsure", text: "Not proven: this method does not say how good its choice is" };
  }
  if (gap < proven) return { tone: "sure", text: "Proven best possible" };
  if (gap > wide) return { tone: "plain", text: `May be up to ${percentUp(gap)} from the best possible` };
  return { tone: "sure", text: `Proven within ${percentUp(gap)} of the best possible` };
}

// What is said of a value that is not known, of a plan or of what it compares with.
export function noWay(plan: Plan): string {
  const isOpen = plan.status === "not_found" || plan.status === "limit_reached" || plan.status === "stopped";
  return plan.limit_reached || isOpen ? "none found" : "no way";
}

// What the paper's rules permit and the world does not: driving through what still stands.
export function tooEarly(plan: Plan): number {
  return plan.removed.filter((one) => one.entered_at !== null && one.entered_at < one.cleared_at - 1e-9).length;
}
