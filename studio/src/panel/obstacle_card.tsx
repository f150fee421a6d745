// What is known about the obstacle that was clicked, and what may be said about it.
import { area, duration } from "../domain/units";
import type { PageState } from "../mission/page_state";
import { IconButton } from "./controls";
import { MarkButtons } from "./mark_buttons";
import { nameOf } from "./obstacle_words";
import { OsmLink } from "./osm_link";

export function ObstacleCard({ page }: { page: PageState }) {
  const id = page.selected.value;
  const shown = page.shown.value;
  const obstacle = id === null ? undefined : shown?.map.cells.obstacle(id);
  if (!shown || !obstacle) return null;
  const units = page.units.value;
  const name = nameOf(shown, obstacle.id);
  const removed = page.results.plans.value.after?.plan.removed.find((one) => one.obstacle === obstacle.id);
  return (
    <aside class="card" aria-label={`About ${name.text}`}>
      <div class="card-head">
        <h2>{name.text}</h2>
        <IconButton icon="close" label="Close" onClick={() => (page.selected.value = null)} />
      </div>
      <p class="obstacle-facts">
        {area(obstacle.cells, units)}
        <OsmLink name={name} />
      </p>
      {obstacle.breach_time > 0 && <p>Opening it takes {duration(obstacle.breach_time, units)} longer.</p>}
      {removed && (
        <p>
          Opened at {duration(removed.cleared_at, units)}
          {removed.entered_at !== null && <>, entered at {duration(removed.entered_at, units)}</>}
          {removed.saves != null && <>; if it had to stay, {duration(removed.saves, units)} later</>}.
        </p>
      )}
      {obstacle.destructible ? (
        <MarkButtons page={page} id={obstacle.id} name={name.text} large />
      ) : (
        <p>It cannot be removed.</p>
      )}
    </aside>
  );
}
