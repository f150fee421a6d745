// What an agent opens as text for an address: time,time for each cell,area,17_20!barrier,building=garage.
import type { Abilities } from "../domain/abilities";
import { filterText, inOne, parseTagFilters } from "../domain/tag_filter";

const betweenIds = "_";
const beforeTags = "!"; // stands alone where nothing is opened
const most = { time: 1e9, area: 1e12 };

// In the order of `abilitiesIn`; empty: as usual.
export function abilityTexts({ breachTime, breachTimePerCell, mostArea, only }: Abilities): (string | number)[] {
  return [breachTime ?? "", breachTimePerCell ?? "", mostArea ?? "", only === null ? "" : onlyText(only)];
}

// Null where a text is none.
export function abilitiesIn([time, timePerCell, area, named]: readonly string[]): Abilities | null {
  const breachTime = numberIn(time, 0, most.time);
  const breachTimePerCell = numberIn(timePerCell, 0, most.time);
  const mostArea = numberIn(area, 1e-6, most.area);
  const only = named ? onlyIn(decodeURIComponent(named)) : null;
  const isWrong = [breachTime, breachTimePerCell, mostArea, only].includes(undefined as never);
  return isWrong ? null : ({ breachTime, breachTimePerCell, mostArea, only } as Abilities);
}

function onlyText(only: readonly (number | string)[]): string {
  const tags = only.filter((one) => typeof one === "string");
  const ids = only.filter((one) => typeof one === "number").join(betweenIds);
  return ids !== "" && tags.length === 0 ? ids : `${ids}${beforeTags}${inOne(tags)}`;
}

function onlyIn(text: string): (number | string)[] | undefined {
  const [, ids, tags] = /^([^!]*)(?:!(.*))?$/s.exec(text)!;
  const numbers = ids ? ids.split(betweenIds) : [];
  const filters = tags ? parseTagFilters(tags) : [];
  if (filters === null || !numbers.every((id) => /^[1-9]\d{0,8}$/.test(id))) return undefined;
  return [...numbers.map(Number), ...filters.map(filterText)];
}

// Null where nothing is said, undefined where it is no such number.
function numberIn(text: string | undefined, least: number, greatest: number): number | null | undefined {
  if (!text) return null;
  const value = Number(text);
  return value >= least && value <= greatest ? value : undefined;
}
