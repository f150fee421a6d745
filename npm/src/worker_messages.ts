// What page and worker send each other.
import type { MapEdit } from "./maps.js";

export interface Call {
  id: number;
  /** Of a map; 0 where none is needed. */
  map: number;
  method: "make" | "edit" | "free" | "planText" | "frontText" | "reviseText" | "check" | "svg" | "labels" | "obstacle";
  parameters: unknown[];
}

/** The first message to a worker is the compiled module, the others are calls. */
export type ToWorker = WebAssembly.Module | Call;

export type FromWorker =
  | { id: number; result: unknown }
  | { id: number; error: { name: string; message: string } };

export interface MapFacts {
  width: number;
  height: number;
  obstacleCount: number;
  digest: string;
}

/** What a map is made from: how, from what, and what has changed since. */
export interface Recipe {
  maker: MapMaker;
  parameters: unknown[];
  edits: readonly MapEdit[];
}

export type MapMaker = "mapFromMovingAI" | "mapFromGrid" | "mapFromLabels";
