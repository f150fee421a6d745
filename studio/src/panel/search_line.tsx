// How far the search for a plan has come, and a way to end it.
import { isSure } from "../mission/words";
import { knownText, searchSteps, searchText, type StepState } from "../mission/search_words";
import type { Studio } from "../mission/studio";
import { searchState } from "../planning/search_state";
import { Icon } from "./icons";

const spoken: Record<StepState, string> = { done: "done", now: "now", open: "not yet" };
const soon = 0.4; // seconds: what takes less is not announced

export function SearchLine({ studio }: { studio: Studio }) {
  const { results } = studio.page;
  const after = results.plans.value.after;
  const isNew = !after || studio.page.old.value; // what takes but a moment to follow is not told
  const state = searchState(results, isNew);
  const plan = isNew ? undefined : after.plan;
  const isSoon = state.stage === "waiting" || (state.stage === "looking" && after?.rough === "draft");
  const isShort = isSoon && (state.seconds ?? 0) < soon;
  const text = isShort ? null : searchText(state);
  const known = state.stage === "ended" || isShort ? null : knownText(state, studio.page.objectiveUnits.value);
  const isHeld = studio.gone.value || studio.maps.lost.value !== null; // goes on by itself, or not at all
  return (
    <div class="search-state" role="group" aria-label="State of the search">
      <ol class="search-steps">
        {searchSteps(state.stage, plan !== undefined && plan.agents.length > 0, plan !== undefined && isSure(plan)).map((step) => (
          <li key={step.name} class={step.state} aria-current={step.state === "now" ? "step" : undefined}>
            {step.name}
            <span class="spoken">, {spoken[step.state]}</span>
          </li>
        ))}
      </ol>
      {text && (
        <div class="working">
          {state.stage !== "stopped" && <progress aria-label="Planning" />}
          <span>{text}</span>
          {state.stage !== "stopped" ? (
            <button type="button" class="button" onClick={() => studio.planner.stop()}>
              <Icon name="stop" /> Stop
            </button>
          ) : (
            !isHeld && (
              <button type="button" class="button" onClick={() => studio.planAgain()}>
                {plan ? "Look on" : "Plan again"}
              </button>
            )
          )}
        </div>
      )}
      {known && <p class="known">{known}</p>}
    </div>
  );
}
