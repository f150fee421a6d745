// What bands of time mean: a strip on the map, with what is under the pointer, and a list in the panel that says it all.
import type { Bands } from "../domain/bands";
import { clockTime } from "../domain/units";
import { bandLines, bandsHere, gainsNothing } from "../mission/band_words";
import type { PageState } from "../mission/page_state";

// The bands that are shown.
export function shownBands(page: PageState): Bands | null {
  return page.mission.value?.bands && !page.rehearsed.value ? page.bands.value : null;
}

// For those who see the map. The list has all of it.
export function BandStrip({ page }: { page: PageState }) {
  const bands = shownBands(page);
  if (!bands) return null;
  const units = page.units.value;
  const { pointed } = page;
  const here = pointed.value ? bandsHere(bands, pointed.value.cell, units) : "";
  const title = bands.isInbound ? "Ground by when one is at the goal" : "Ground by when it is reached";
  return (
    <div class={`band-strip ${page.bandsAreOld.value ? "old" : ""} ${here && pointed.value?.isChosen ? "chosen" : ""}`}>
      <p aria-hidden="true">{page.bandsAreOld.value ? "Of the plan before" : here || title}</p>
      <ul aria-hidden="true">
        {bands.ends.map((end, i) => (
          <li key={end}>
            <span class={`swatch swatch-band-${i + 1}`} />
            {clockTime(end, units)}
          </li>
        ))}
      </ul>
      <p class="spoken" aria-live="polite">
        {pointed.value?.isChosen ? here : ""}
      </p>
    </div>
  );
}

export function BandList({ page }: { page: PageState }) {
  const bands = shownBands(page);
  if (!bands) return null;
  const units = page.units.value;
  return (
    <div class="bands" aria-busy={page.bandsAreOld.value}>
      <ul aria-label="Bands of time, and how much of the ground they are">
        {bandLines(bands, units).map(({ look, band, text, share }) => (
          <li key={text}>
            <span class={`swatch swatch-${look} ${look === "band" ? `swatch-band-${band}` : ""}`} aria-hidden="true" />
            {`${text} `}
            <span class="band-share">{share}</span>
          </li>
        ))}
      </ul>
      {page.bandsAreOld.value && <p>Of the plan before: new ones are being worked out.</p>}
      {gainsNothing(bands) && <p>No ground is reached clearly sooner.</p>}
    </div>
  );
}
