// What page and worker send each other.

export interface Call {
  id: number;
  /** Of a map; 0 where none is needed. */
  map: number;
  method: "make" | "free" | "planText" | "frontText" | "check" | "svg" | "labels" | "obstacle";
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

export type MapMaker = "mapFromMovingAI" | "mapFromGrid" | "mapFromLabels";
