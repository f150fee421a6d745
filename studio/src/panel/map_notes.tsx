// What to know of a map before one plans on it: how much of it nobody knows, what was noticed when it was made, and how
// its file was read where that leaves it open.
import { isUnknown, unknownSentence } from "../domain/unknown_ground";
import type { ShownMap } from "../mission/maps";
import type { PageState } from "../mission/page_state";

export function MapNotes({ page }: { page: PageState }) {
  const shown = page.shown.value;
  const notes = shown?.base.description.notes ?? [];
  const unknown = shown && unknownOf(shown);
  if (notes.length === 0 && !unknown) return null;
  return (
    <ul class="map-notes" aria-label="About this map">
      {unknown && (
        <li>
          <span class="swatch swatch-unknown" aria-hidden="true" />
          {unknown}
        </li>
      )}
      {notes.map((note) => (
        <li key={note}>{sentence(note)}</li>
      ))}
    </ul>
  );
}

function unknownOf({ base }: ShownMap): string | null {
  const { width, height, unknown } = base.description;
  return unknownSentence(unknown / (width * height), base.cells.obstacles.some(isUnknown));
}

function sentence(text: string): string {
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}
