// How obstacles look on the map: by what they are, and by whether they can be removed.
import type { CellMap } from "./cell_map";
import type { Obstacle } from "./map";

export const looks = ["removable", "barrier", "fixed", "water", "cliff", "forbidden"] as const;

export type Look = (typeof looks)[number];

export function lookOf({ kind, destructible }: Obstacle): Look {
  if (destructible) return kind === "barrier" ? "barrier" : "removable";
  return kind === "water" || kind === "cliff" || kind === "forbidden" ? kind : "fixed";
}

// Those of a map, in the order above.
export function looksOn(cells: CellMap): Look[] {
  const found = new Set(cells.obstacles.map(lookOf));
  return looks.filter((look) => found.has(look));
}
