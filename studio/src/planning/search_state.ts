// How far the search for a plan has come: what is shown is a first answer, or all that the search gave.
import { objectiveOf, reached, valueOf } from "../domain/plan";
import type { Results } from "./results";

export type Stage =
  | "waiting" // for a first answer to what is asked now
  | "looking" // a better one may follow
  | "stopped" // none follows, though the search has not ended
  | "ended";

export interface SearchState {
  stage: Stage;
  queued: boolean; // the service is busy with others
  seconds: number | null; // since it was asked for
  best: number | null; // the objective of the best plan so far, which is shown or will be
  bound: number | null; // what no plan is below
}

// `outdated`: whether the plan that is shown answers an older question.
export function searchState({ plans, working, progress, failure }: Results, outdated: boolean): SearchState {
  const shown = plans.value.after;
  const now = progress.value;
  const known = shown && !outdated ? shown.plan : null;
  const least = (values: readonly number[]) => (values.length > 0 ? Math.min(...values) : null);
  const limit = known?.bound ? valueOf(known.bound, objectiveOf(known)) : null;
  const bounds = [limit, now?.bound].filter((bound) => bound != null);
  return {
    stage: stageOf(),
    queued: now?.state === "queued",
    seconds: now?.seconds ?? null,
    best: least([known && reached(known), now?.best].filter((best) => best != null && Number.isFinite(best)) as number[]),
    bound: bounds.length > 0 ? Math.max(...bounds) : null,
  };

  function stageOf(): Stage {
    if (failure.value?.trouble === "stopped") return "stopped";
    if (!known) return working.value ? "waiting" : "stopped";
    if (!shown?.rough) return "ended";
    return working.value ? "looking" : "stopped";
  }
}
