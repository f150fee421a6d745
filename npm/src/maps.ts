// Maps: what is known of obstacles, how maps are made, and how they change.
import type { Cell } from "./documents.js";

/** What is known of an obstacle beside its cells. */
export interface Attributes {
  /** Who it is in your world, a whole number; 0: unknown. In plans it is a number, exact to 2^53. */
  sourceId?: number | bigint;
  /** What its removal counts for against a budget; 1. */
  weight?: number;
  /** How long its breach takes, beside what the mission says; 0. */
  breachTime?: number;
  /** Whether it can be removed; true. */
  destructible?: boolean;
}

export interface Obstacle extends Required<Attributes> {
  id: number;
  cells: number;
  /** The outermost of its cells. */
  min: Cell;
  max: Cell;
}

/** A change of a map. Obstacles that it does not name keep their ids. */
export type MapEdit =
  /** All cells of the obstacle are free then, and it is gone. */
  | { remove: number }
  /** A new obstacle has these cells, whatever they were; its id is the one after the last. */
  | { add: readonly Cell[]; attributes?: Attributes }
  /** The obstacle has these cells as well, whatever they were. */
  | { extend: number; cells: readonly Cell[] }
  /** These cells are free. */
  | { free: readonly Cell[] };

export interface MapOptions {
  /** What plans call the map's source; "map". */
  name?: string;
  /** Metres a cell measures; plans speak of cells alone without. */
  cellSize?: number;
}

export interface GridOptions extends MapOptions {
  /** Blocked cells are one obstacle if they share sides (4), or corners as well (8); 4. */
  connectivity?: 4 | 8;
}

export interface LabelOptions extends MapOptions {
  /** By label; entry 0 is not used. */
  attributes?: readonly (Attributes | undefined)[];
}
