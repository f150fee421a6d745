// How obstacles look on the map: by what they are, and by whether they can be removed.
import type { CellMap } from "./cell_map";
import type { Obstacle } from "./map";
import { isUnknown } from "./unknown_ground";

export const looks = ["removable", "barrier", "fixed", "water", "cliff", "forbidden", "off_road", "unknown"] as const;

export type Look = (typeof looks)[number];

// `ruled`: what the mission protects by tag or name looks as if the map did.
export type Ruled = Pick<ReadonlyMap<number, unknown>, "has">;
const none: Ruled = new Map();

export function lookOf(obstacle: Obstacle, ruled = none): Look {
  const { id, kind, destructible } = obstacle;
  if (isUnknown(obstacle)) return "unknown";
  if (destructible && ruled.has(id)) return "fixed";
  if (destructible) return kind === "barrier" ? "barrier" : "removable";
  return kind === "water" || kind === "cliff" || kind === "forbidden" || kind === "off_road" ? kind : "fixed";
}

// Those of a map, in the order above.
export function looksOn(cells: CellMap, ruled = none): Look[] {
  const found = new Set(cells.obstacles.map((one) => lookOf(one, ruled)));
  return looks.filter((look) => found.has(look));
}
