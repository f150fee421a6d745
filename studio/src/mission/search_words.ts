// How far the search has come, in words that claim no more.
import { durations, percentUp, type Units } from "../domain/units";
import type { SearchState, Stage } from "../planning/search_state";

export type StepState = "done" | "now" | "open";

// The three steps of a search. The last is done where the plan is proven to be the best, or nearly.
export function searchSteps(stage: Stage, hasPlan: boolean, isSure: boolean): { name: string; state: StepState }[] {
  const quick = stage === "waiting" ? "now" : hasPlan ? "done" : "open";
  const looking = stage === "looking" ? "now" : stage === "ended" ? "done" : "open";
  return [
    { name: "Quick answer", state: quick },
    { name: stage === "ended" ? "Looked" : "Looking", state: looking },
    { name: "Proven", state: stage === "ended" && isSure ? "done" : "open" },
  ];
}

// What goes on; null where the search has ended, and its result says it all.
export function searchText({ stage, queued, seconds }: SearchState): string | null {
  const since = seconds !== null && seconds >= 0.5 ? `, ${Math.round(seconds)}\u00a0s` : "";
  if (stage === "ended") return null;
  if (stage === "stopped") return "Stopped: there may be a better plan.";
  if (queued) return `Waiting for the planner${since}`;
  return `${stage === "waiting" ? "Planning" : "Looking for a better plan"}${since}`;
}

// How good the best plan so far is, and what none can be better than.
export function knownText({ best, bound }: SearchState, units: Units): string | null {
  if (best === null && bound === null) return null;
  const [first, second] = durations([best, bound].filter((time) => time !== null), units);
  if (best === null) return `No plan is below ${first}`;
  if (bound === null) return `Best so far ${first}`;
  const gap = best / bound - 1;
  const most = Number.isFinite(gap) && gap > 1e-9 ? `: at most ${percentUp(1 - bound / best)} to gain` : "";
  return `Best so far ${first}; none is below ${second}${most}`;
}
