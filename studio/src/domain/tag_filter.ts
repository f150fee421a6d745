// Obstacles by what they are or are called, as --protect has it: amenity=hospital,school; heritage; name=St. Mary*.
import type { CellMap } from "./cell_map";
import type { Obstacle } from "./map";

export interface TagFilter {
  key: string;
  values: readonly string[]; // any, if empty
}

// One or more of KEY and KEY=VALUE,... with commas between: what follows a KEY=VALUE and has no = is another value of that
// key. Null where the text is something else.
export function parseTagFilters(text: string): TagFilter[] | null {
  const filters: { key: string; values: string[] }[] = [];
  for (const part of text.split(",")) {
    const [, key, value] = /^([^=]*)(?:=(.*))?$/s.exec(part)!;
    const last = filters.at(-1);
    if (value === undefined && last && last.values.length > 0) last.values.push(part);
    else filters.push({ key: key!, values: value === undefined ? [] : [value] });
    const isNothing = filters.at(-1)!.key === "" || filters.at(-1)!.values.at(-1) === "";
    if (isNothing || /["'\\]/.test(key!)) return null;
  }
  return filters;
}

export function filterText({ key, values }: TagFilter): string {
  return values.length === 0 ? key : `${key}=${values.join()}`;
}

// Several as one text. Keys alone come first: after a KEY=VALUE they would be values.
export function filtersText(filters: readonly TagFilter[]): string {
  const alone = filters.filter(({ values }) => values.length === 0);
  const valued = filters.filter(({ values }) => values.length > 0);
  return [...alone, ...valued].map(filterText).join();
}

// Texts of files as a link has them; the first that is no tag as it is, to be complained of.
export function inOne(texts: readonly string[]): string {
  const filters = texts.map(parseTagFilters);
  const wrong = filters.indexOf(null);
  return wrong < 0 ? filtersText(filters.flatMap((some) => some ?? [])) : texts[wrong]!;
}

// What any of the filters means of that which can be removed, with the first that does.
export function ruledObstacles(filters: readonly TagFilter[], { obstacles }: CellMap): Map<number, TagFilter> {
  const found = new Map<number, TagFilter>();
  if (filters.length === 0) return found;
  for (const obstacle of obstacles) {
    const filter = obstacle.destructible && filters.find((one) => matches(obstacle, one));
    if (filter) found.set(obstacle.id, filter);
  }
  return found;
}

// Whether the tags that the map keeps of an obstacle match, or with the key `name` what it is called. A section matches if
// anything does that it is a part of.
export function matches(obstacle: Obstacle, filter: TagFilter): boolean {
  if (filter.key === "name") return namesOf(obstacle).some((name) => name !== "" && accepts(filter, name));
  return (obstacle.tags ?? []).some((tag) => {
    const equals = tag.indexOf("=");
    return filter.key === "*" || (tag.slice(0, equals) === filter.key && accepts(filter, tag.slice(equals + 1)));
  });
}

function namesOf({ name, structures }: Obstacle): string[] {
  return structures && structures.length > 0 ? structures.map((one) => one.name ?? "") : [name];
}

function accepts({ values }: TagFilter, value: string): boolean {
  return value !== "no" && (values.length === 0 || values.some((pattern) => fits(value, pattern)));
}

// Whether a text is a pattern in which * stands for any text: its parts, each as far to the left as can be.
function fits(text: string, pattern: string): boolean {
  const [first, ...others] = pattern.split("*") as [string, ...string[]];
  const last = others.pop();
  if (last === undefined) return text === first;
  if (!text.startsWith(first)) return false;
  let at = first.length;
  for (const part of others) {
    const found = text.indexOf(part, at);
    if (found < 0) return false;
    at = found + part.length;
  }
  return text.length - at >= last.length && text.endsWith(last);
}
