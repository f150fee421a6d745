// How many obstacles may go: a slider, and under it what each number reaches.
import { canOpen } from "../domain/agents";
import { mostRemovals, withEnoughRemovals } from "../domain/mission";
import { duration } from "../domain/units";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { nounOf } from "../mission/words";
import { FrontChart } from "./front_chart";
import { NumberField } from "./number_field";
import { hasBuildings } from "./obstacle_words";

export function Removals({ page, studio }: { page: PageState; studio: Studio | null }) {
  const mission = page.mission.value;
  const shown = page.shown.value;
  if (!mission || !shown) return null;
  if (!studio && !page.results.front.value) return null;
  if (!canOpen(mission.agents)) return null;
  const auto = mission.removals === "auto";
  const price = `≥ ${duration(mission.price, page.units.value)}`;
  const count =
    mission.removals === "auto" ? (page.results.plans.value.after?.plan.removed.length ?? 0) : mission.removals;
  const set = (removals: number | "auto") =>
    studio?.editor.change((old) => withEnoughRemovals({ ...old, removals }), "removals");
  const setAtOnce = (removals: number | "auto") => {
    set(removals);
    studio?.editor.endGesture();
  };
  return (
    <section class="section removals" aria-labelledby="removals-title">
      <div class="removals-head">
        <h2 id="removals-title">{studio ? <label for="removals">Removals</label> : "Removals"}</h2>
        <output class="removals-count">{auto ? count : `up to ${count}`}</output>
        {studio && (
          <label class="switch" title={`As many removals as save at least ${price} each`}>
            <input
              type="checkbox"
              checked={auto}
              onChange={(event) => setAtOnce(event.currentTarget.checked ? "auto" : count)}
            />
            <span>Auto: {price} each</span>
          </label>
        )}
      </div>
      {studio && auto && (
        <NumberField
          label="Only if each saves at least"
          unit={page.units.value.metric ? "s" : "steps"}
          min={0}
          max={1_000_000}
          value={mission.price}
          onInput={(price) => studio.editor.change((old) => ({ ...old, price }), "price")}
          onDone={() => studio.editor.endGesture()}
        />
      )}
      {studio && (
        <input
          id="removals"
          class="slider"
          type="range"
          min={0}
          max={mostRemovals}
          step={1}
          value={count}
          aria-valuetext={`${count} ${nounOf(count, hasBuildings(shown))} may be removed`}
          onInput={(event) => set(event.currentTarget.valueAsNumber)}
          onChange={() => studio.editor.endGesture()}
        />
      )}
      <FrontChart page={page} count={count} onChoose={studio ? setAtOnce : null} />
    </section>
  );
}
