// How the map's file was read, where it leaves that open.
import type { PageState } from "../mission/page_state";

export function MapNotes({ page }: { page: PageState }) {
  const notes = page.shown.value?.base.description.notes ?? [];
  if (notes.length === 0) return null;
  return (
    <ul class="map-notes" aria-label="How the map was read">
      {notes.map((note) => (
        <li key={note}>{sentence(note)}</li>
      ))}
    </ul>
  );
}

function sentence(text: string): string {
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}
