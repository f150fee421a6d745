// By when ground is reached, as bands of time ("waybreaker-reach/1", docs/server.md): those of the command's pictures.
import type { Cell, Size } from "./geometry";

export interface ReachDocument extends Size {
  format: "waybreaker-reach/1";
  bands: number[]; // when each ends, in units of time; empty where there are none, and all else is left out
  inbound?: boolean;
  sooner?: number;
  before?: number[]; // runs: what cells show, how many there are
  after?: number[];
  gains?: number[];
}

// Of a cell's ground.
export const gain = { none: 0, sooner: 1, onlyNow: 2 } as const;

export class Bands {
  readonly width: number;
  readonly height: number;
  readonly isInbound: boolean; // by when one is at the hub from there
  readonly ends: readonly number[]; // in units of time
  readonly sooner: number; // how much sooner is clearly sooner
  // By cell, row by row. 0: an obstacle; bands count from 1; `unreached`.
  readonly before: Uint8Array;
  readonly after: Uint8Array;
  readonly gains: Uint8Array;

  // Null where there are none.
  static of(document: ReachDocument): Bands | null {
    return document.bands.length > 0 ? new Bands(document) : null;
  }

  private constructor({ width, height, bands, inbound = false, sooner = 0, before = [], after = [], gains = [] }: ReachDocument) {
    [this.width, this.height] = [width, height];
    this.isInbound = inbound;
    this.ends = bands;
    this.sooner = sooner;
    [this.before, this.after, this.gains] = [before, after, gains].map((runs) => cells(runs, width * height)) as [
      Uint8Array,
      Uint8Array,
      Uint8Array,
    ];
  }

  // What cells show that are not reached.
  get unreached(): number {
    return this.ends.length + 1;
  }

  // At a cell of free ground; null elsewhere.
  at([x, y]: Cell): { before: number; after: number } | null {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) return null;
    const [before, after] = [this.before[y * this.width + x]!, this.after[y * this.width + x]!];
    return after === 0 ? null : { before, after };
  }

  // How much of the free ground there is of each: by what cells show with the plan, and by gain.
  shares(): { after: number[]; gains: number[] } {
    const [after, gains] = [Array<number>(this.unreached + 1).fill(0), [0, 0, 0]];
    this.after.forEach((band, i) => {
      ++after[band]!;
      if (band !== 0) ++gains[this.gains[i]!]!;
    });
    const all = this.after.length - after[0]!;
    return { after: after.map((count) => count / all), gains: gains.map((count) => count / all) };
  }
}

function cells(runs: readonly number[], count: number): Uint8Array {
  const result = new Uint8Array(count);
  let at = 0;
  for (let i = 0; i + 1 < runs.length; i += 2) result.fill(runs[i]!, at, (at += runs[i + 1]!));
  return result;
}
