// Laying what the day brings over the map shown: a file is given, a person says what it is, and the mission goes on there.
import { signal } from "@preact/signals";
import { type Client, ServiceError } from "../api/client";
import type { CellMap } from "../domain/cell_map";
import type { MapDescription, Obstacle } from "../domain/map";
import type { Choice } from "../domain/mission";
import type { KeptFile } from "./kept_file";

// What the things of an overlay are, as the service calls it.
export type OverlayUse = "water" | "debris" | "closed" | "wall" | "free";

export interface OverlayState {
  file: KeptFile;
  map: string; // that it is laid over
  use: OverlayUse;
  width: number; // metres, of lines
  busy: boolean;
  failure: string | null;
}

const usualWidth = 6; // metres: a street

export class Overlays {
  readonly state = signal<OverlayState | null>(null);
  #control = new AbortController();

  constructor(
    private readonly client: Client,
    private readonly done: (map: MapDescription, file: KeptFile) => Promise<unknown>,
  ) {}

  begin(file: KeptFile, map: string): void {
    this.cancel();
    this.state.value = { file, map, use: "water", width: usualWidth, busy: false, failure: null };
  }

  choose(part: Partial<Pick<OverlayState, "use" | "width">>): void {
    this.#set({ ...part, failure: null });
  }

  async finish(): Promise<void> {
    const state = this.state.peek();
    if (!state || state.busy) return;
    const { signal } = (this.#control = new AbortController());
    this.#set({ busy: true, failure: null });
    try {
      const map = await this.client.overlay(state.map, state, signal);
      // The map's own file, to send it again if the service has lost it.
      const { bytes } = await this.client.file(map.id);
      if (signal.aborted) return;
      this.state.value = null;
      await this.done(map, { name: `${nameOf(state.file)}.tif`, bytes });
    } catch (error) {
      if (!signal.aborted) this.#set({ busy: false, failure: said(error) });
    }
  }

  cancel(): void {
    this.#control.abort();
    this.state.value = null;
  }

  #set(part: Partial<OverlayState>): void {
    const state = this.state.peek();
    if (state) this.state.value = { ...state, ...part };
  }
}

function nameOf(file: KeptFile): string {
  return file.name.replace(/\..*$/, "") || "map";
}

function said(error: unknown): string {
  if (error instanceof ServiceError) return error.message;
  console.error(error);
  return "What the server says of this file cannot be shown.";
}

// What is said of obstacles, by their numbers on the new map. What is gone needs nothing said of it; drawn walls stay.
export function moved(marks: ReadonlyMap<number, Choice>, from: CellMap, to: CellMap): Map<number, Choice> {
  const result = new Map<number, Choice>();
  for (const [key, mark] of marks) {
    const now = key < 0 ? key : foundAgain(key, from, to);
    if (now !== 0) result.set(now, mark);
  }
  return result;
}

// 0 where nothing of the obstacle is left.
function foundAgain(id: number, from: CellMap, to: CellMap): number {
  const before = from.obstacle(id);
  for (const [x, y, length] of from.runsOf(id)) {
    for (let i = x; i < x + length; ++i) {
      const now = to.at(i, y);
      if (now !== 0 && before && isSame(before, to.obstacle(now)!)) return now;
    }
  }
  return 0;
}

function isSame(a: Obstacle, b: Obstacle): boolean {
  return a.source_id === b.source_id && a.name === b.name && a.kind === b.kind && a.destructible === b.destructible;
}
