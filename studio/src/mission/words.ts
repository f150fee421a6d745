// Plans in plain words: what the person reads first.
import type { Objective, Plan } from "../api/answers";
import { duration, percent, percentUp, type Units } from "./units";

export interface Headline {
  tone: "good" | "plain" | "bad";
  title: string;
  // What is reached, and what would be without removals: shown large, as figures.
  figures: { after: number; before: number | null } | null;
  remedies: string[]; // what can be done where there is no plan
}

export interface Proof {
  proven: boolean;
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

export function objectiveOf(plan: Plan): Objective {
  return plan.options.objective ?? "makespan";
}

export function valueOf(outcome: Plan["after"], objective: Objective): number | null {
  return objective === "makespan" ? outcome.makespan : outcome.flowtime;
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
  const subject = groundDecides(plan) ? "gets the ground robot there" : "gets the last of the two there";
  return { tone, title: `${removing} ${subject} ${change}`, figures, remedies: [] };
}

// “16 min 15 s instead of 20 min 55 s”
export function figuresText(figures: NonNullable<Headline["figures"]>, units: Units): string {
  const after = duration(figures.after, units);
  return figures.before === null ? after : `${after} instead of ${duration(figures.before, units)}`;
}

function unhelped(plan: Plan): string {
  if (plan.options.removals === 0) return "With nothing removed, the ground robot takes the way round";
  return "No removal gets the ground robot there sooner";
}

// Whether the ground agent is the last to arrive, or so near to it that nobody would see it.
function groundDecides(plan: Plan): boolean {
  const arrival = (kind: "ground" | "air") => plan.agents.find((agent) => agent.kind === kind)?.path.at(-1)?.[2] ?? 0;
  return arrival("ground") >= 0.999 * arrival("air");
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

// How good the choice is known to be.
export function proof(plan: Plan): Proof | null {
  if (plan.agents.length === 0) return null;
  const gap = plan.bound?.gap;
  if (gap === null || gap === undefined) {
    return { proven: false, text: "Not proven: this method does not say how good its choice is" };
  }
  if (gap < 1e-9) return { proven: true, text: "Proven best possible" };
  return { proven: true, text: `Proven within ${percentUp(gap)} of the best possible` };
}

// What the paper's rules permit and the world does not: driving through what still stands.
export function tooEarly(plan: Plan): number {
  return plan.removed.filter((one) => one.entered_at !== null && one.entered_at < one.cleared_at - 1e-9).length;
}
