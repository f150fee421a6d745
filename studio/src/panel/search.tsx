// Finds a street, a water or a building by name, shows where it is and selects it.
import { useId, useMemo, useRef, useState } from "preact/hooks";
import type { Point } from "../domain/geometry";
import { type Place, PlaceIndex } from "../domain/places";
import type { PageState } from "../mission/page_state";
import { Name } from "./name";

interface SearchProps {
  page: PageState;
  show: (what: number | Point) => void; // on the map
}

export function Search({ page, show }: SearchProps) {
  const map = page.shown.value?.map;
  const index = useMemo(() => map && new PlaceIndex(map.background, map.cells), [map]);
  const [query, setQuery] = useState("");
  const [active, setActive] = useState(0);
  const [open, setOpen] = useState(false);
  const field = useRef<HTMLInputElement>(null);
  const id = useId();
  if (!index || index.isEmpty) return null;
  const found = open ? index.find(query) : [];
  const take = (place: Place) => {
    page.selected.value = place.obstacle;
    show(place.obstacle ?? place.at);
    setQuery(place.name);
    setOpen(false);
  };
  const press = (event: KeyboardEvent) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step !== undefined && found.length > 0) setActive((active + step + found.length) % found.length);
    else if (event.key === "Enter" && found[active]) take(found[active]);
    else if (event.key === "Escape") open ? setOpen(false) : setQuery("");
    else return;
    event.preventDefault();
  };
  return (
    <div class="search" onFocusOut={(event) => event.currentTarget.contains(event.relatedTarget as Node) || setOpen(false)}>
      <input
        ref={field}
        id="search"
        type="search"
        role="combobox"
        autocomplete="off"
        aria-label="Find a street or obstacle"
        placeholder="Find a street or obstacle"
        aria-expanded={found.length > 0}
        aria-controls={id}
        aria-activedescendant={found.length > 0 ? `${id}-${active}` : undefined}
        value={query}
        onInput={(event) => {
          setQuery(event.currentTarget.value);
          setActive(0);
          setOpen(true);
        }}
        onKeyDown={press}
      />
      <ul id={id} class="search-results" role="listbox" aria-label="Found">
        {found.map((place, i) => (
          <li
            key={`${place.name} ${place.obstacle}`}
            id={`${id}-${i}`}
            role="option"
            aria-selected={i === active}
            onPointerDown={(event) => event.preventDefault()} // the field keeps the focus
            onClick={() => take(place)}
          >
            <Name of={place.name} /> <span class="search-what">{place.what}</span>
          </li>
        ))}
      </ul>
      <p class="search-none" role="status">
        {open && query.trim() !== "" && found.length === 0 && "Nothing on this map is called so."}
      </p>
    </div>
  );
}
