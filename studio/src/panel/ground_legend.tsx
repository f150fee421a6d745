// What obstacles look like on the map, those kinds that this map has, and bands of time. In print it is always open.
import { useId, useState } from "preact/hooks";
import { type Look, looksOn } from "../domain/looks";
import { bandLines } from "../mission/band_words";
import type { PageState } from "../mission/page_state";
import { BandStrip, shownBands } from "./band_legend";

const words: Record<Look, string> = {
  removable: "can be removed",
  barrier: "wall, fence, hedge: can be removed",
  fixed: "has to stay",
  water: "water",
  cliff: "cliff or ditch",
  forbidden: "forbidden ground",
  off_road: "off the roads",
  unknown: "unknown: no data",
};

export function GroundLegend({ page }: { page: PageState }) {
  const [open, setOpen] = useState(false);
  const id = useId();
  const cells = page.shown.value?.map.cells;
  if (!cells) return null;
  const looks = looksOn(cells, page.ruled.value);
  const hasRemoved = (page.results.plans.value.after?.plan.removed.length ?? 0) > 0;
  const bands = shownBands(page);
  if (looks.length < 2 && !bands) return null;
  return (
    <div class={`ground-legend ${open ? "open" : ""}`}>
      <BandStrip page={page} />
      <ul id={id} hidden={!open} aria-label={bands ? "Legend of the map" : "Legend of obstacles"}>
        {looks.map((look) => (
          <li key={look}>
            <span class={`swatch swatch-${look}`} aria-hidden="true" />
            {words[look]}
          </li>
        ))}
        {hasRemoved && (
          <li>
            <span class="swatch swatch-removed" aria-hidden="true" />
            removed in this plan
          </li>
        )}
        {bands &&
          bandLines(bands, page.units.value)
            .filter(({ look }) => look !== "band")
            .map(({ look, text }) => (
              <li key={look}>
                <span class={`swatch swatch-${look}`} aria-hidden="true" />
                {text}
              </li>
            ))}
      </ul>
      <button type="button" aria-expanded={open} aria-controls={id} onClick={() => setOpen(!open)}>
        {open ? "Hide legend" : "Legend"}
      </button>
    </div>
  );
}
