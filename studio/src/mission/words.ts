// Plans in plain words: what the person reads first.
import { isTeam, objectiveOf, type Plan, valueOf } from "../domain/plan";
import { difference, durations, percent, percentUp, type Units } from "../domain/units";
import { agentOf, arrival } from "../play/motion";

export interface Headline {
  tone: "good" | "plain" | "bad";
  title: string;
  // The result, and the result without removals: shown large, as figures.
  figures: { after: number; before: number | null } | null;
  remedies: string[]; // what can be done where there is no plan
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

export function headline(plan: Plan, buildings: boolean): Headline {
  const objective = objectiveOf(plan);
  const before = valueOf(plan.before, objective);
  const after = valueOf(plan.after, objective);
  const count = plan.removed.length;
  if (after === null || plan.agents.length === 0) return without(plan, buildings);
  const figures = { after, before };
  const removing = `Removing ${counted(count, buildings)}`;
  if (count === 0) return { tone: "plain", title: unhelped(plan), figures: { after, before: null }, remedies: [] };
  if (before === null) {
    const title = `${removing} opens a way that there is not without`;
    return { tone: "good", title, figures, remedies: [] };
  }
  const share = (before - after) / before;
  if (Math.abs(share) < 1e-9) return { tone: "plain", title: `${removing} gains nothing here`, figures, remedies: [] };
  const change = `${percent(Math.abs(share))} ${share > 0 ? "sooner" : "later"}`;
  const tone = share > 0 ? "good" : "bad";
  if (objective === "flowtime") {
    const title = `${removing} ${share > 0 ? "saves" : "costs"} ${percent(Math.abs(share))} of the agents’ time on the way`;
    return { tone, title, figures, remedies: [] };
  }
  const what = isAirsArrival(plan) ? "ends the mission" : "gets the ground robot there";
  return { tone, title: `${removing} ${what} ${change}`, figures, remedies: [] };
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

function unhelped(plan: Plan): string {
  if (String(plan.options.select) === "none") return unasked;
  if (plan.options.removals === 0) return "With nothing removed, the ground robot takes the way round";
  const none = isProven(plan) ? "No removal" : "No removal was found that";
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

function without(plan: Plan, buildings: boolean): Headline {
  const allowed = plan.options.removals ?? 0;
  if (plan.status === "limit_reached" || plan.status === "stopped") {
    return {
      tone: "bad",
      title: "No way was found in the time there was",
      figures: null,
      remedies: ["Ask for fewer removals.", "Move start and goal nearer to each other."],
    };
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

// What the paper's rules permit and the world does not: driving through what still stands.
export function tooEarly(plan: Plan): number {
  return plan.removed.filter((one) => one.entered_at !== null && one.entered_at < one.cleared_at - 1e-9).length;
}
