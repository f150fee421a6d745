// What an agent that breaches can open, and how long that takes it.
import type { Obstacle } from "./map";
import { filterText, matches, parseTagFilters } from "./tag_filter";
import { type Scale, scaled } from "./units";

// Null: as the rules say, or any.
export interface Abilities {
  breachTime: number | null; // of one obstacle
  breachTimePerCell: number | null;
  mostArea: number | null; // of an obstacle that it opens: square metres, or cells
  only: readonly (number | string)[] | null; // what it opens: ids, then tags, each such as “barrier” or “building=garage,shed”
}

export const usualAbilities: Abilities = { breachTime: null, breachTimePerCell: null, mostArea: null, only: null };

export const mostReach = 100; // cells that may be between a vehicle and what it breaches

export function abilitiesOnly({ breachTime, breachTimePerCell, mostArea, only }: Abilities): Abilities {
  return { breachTime, breachTimePerCell, mostArea, only };
}

export function hasOwnAbilities(agent: Abilities): boolean {
  return Object.values(abilitiesOnly(agent)).some((value) => value !== null);
}

// As mission files, plan files and requests have them (docs/contract.md).
export interface AbilitiesDocument {
  breach_time?: number; // units of time
  breach_time_per_cell?: number;
  can_breach?: { most_cells?: number; only?: readonly (number | string)[] };
}

export function abilitiesDocument({ breachTime, breachTimePerCell, mostArea, only }: Abilities, cell: number): AbilitiesDocument {
  const can = { ...(mostArea !== null && { most_cells: cellsWithin(mostArea, cell) }), ...(only && { only }) };
  return {
    ...(breachTime !== null && { breach_time: breachTime }),
    ...(breachTimePerCell !== null && { breach_time_per_cell: breachTimePerCell }),
    ...(Object.keys(can).length > 0 && { can_breach: can }),
  };
}

// What cannot be is kept as it is, or as NaN: links refuse it.
export function abilitiesOf(document: AbilitiesDocument, { cell, seconds }: Scale): Abilities {
  const can = document.can_breach;
  const { most_cells: most, only } = isChoice(can) ? can : {};
  const timeOf = (time: number | undefined) => (time === undefined ? null : typeof time === "number" ? scaled(time, seconds) : NaN);
  return {
    breachTime: timeOf(document.breach_time),
    breachTimePerCell: timeOf(document.breach_time_per_cell),
    mostArea: most === undefined ? null : Number.isInteger(most) && most > 0 ? scaled(most, cell * cell) : NaN,
    only: only === undefined ? null : [...only.filter((one) => typeof one === "number"), ...only.flatMap(singleTags)],
  };
}

// Whether it says nothing but what can be read.
export function isChoice(can: unknown): can is NonNullable<AbilitiesDocument["can_breach"]> {
  if (typeof can !== "object" || can === null || Array.isArray(can)) return false;
  const isNamed = (one: unknown) => typeof one === "number" || (typeof one === "string" && one !== "");
  const { only = [] } = can as Record<string, unknown>;
  const isKnown = (name: string) => name === "most_cells" || name === "only";
  return Object.keys(can).every(isKnown) && Array.isArray(only) && only.every(isNamed);
}

function singleTags(one: number | string): string[] {
  return typeof one === "number" ? [] : (parseTagFilters(one)?.map(filterText) ?? [one]);
}

const mostCells = 2 ** 32 - 1; // that a file can say

function cellsWithin(area: number, cell: number): number {
  return Math.min(Math.max(Math.floor(area / (cell * cell) + 1e-6), 1), mostCells);
}

// Whether an agent that breaches opens that obstacle of the map as it was before anything was drawn.
export function opens({ mostArea, only }: Pick<Abilities, "mostArea" | "only">, obstacle: Obstacle, cell: number): boolean {
  if (mostArea !== null && obstacle.cells > cellsWithin(mostArea, cell)) return false;
  const isMeant = (one: number | string) =>
    typeof one === "number" ? one === obstacle.id : (parseTagFilters(one) ?? []).some((filter) => matches(obstacle, filter));
  return only === null || only.some(isMeant);
}
