// Which obstacle stands on which cell, as runs row by row: small enough for 4096² cells, and all that drawing and
// pointing need.
import { type Box, mapBox, type Run } from "./geometry";
import type { Obstacle, Obstacles } from "./map";

export class CellMap {
  readonly width: number;
  readonly height: number;
  readonly obstacles: readonly Obstacle[]; // obstacle n at n - 1
  // Runs of blocked cells by row, from left to right, each as long as can be: those of row y are rowStart[y] up to rowStart[y + 1].
  readonly rowStart: Uint32Array;
  readonly from: Uint32Array;
  readonly length: Uint32Array;
  readonly label: Uint32Array;

  constructor(answer: Obstacles) {
    this.width = answer.width;
    this.height = answer.height;
    this.obstacles = answer.obstacles;
    this.rowStart = new Uint32Array(this.height + 1);
    const runs: number[] = [];
    let x = 0;
    let y = 0;
    for (let i = 0; i + 1 < answer.runs.length && y < this.height; i += 2) {
      const label = answer.runs[i]!;
      let left = answer.runs[i + 1]!;
      while (left > 0 && y < this.height) {
        const length = Math.min(left, this.width - x);
        const last = runs.length - 3;
        const goesOn = x > 0 && last >= 3 * this.rowStart[y]! && runs[last]! + runs[last + 1]! === x;
        if (goesOn && runs[last + 2] === label) runs[last + 1]! += length;
        else if (label !== 0) runs.push(x, length, label);
        left -= length;
        x += length;
        if (x === this.width) {
          x = 0;
          this.rowStart[++y] = runs.length / 3;
        }
      }
    }
    this.rowStart.fill(runs.length / 3, y + 1);
    const count = runs.length / 3;
    this.from = new Uint32Array(count);
    this.length = new Uint32Array(count);
    this.label = new Uint32Array(count);
    for (let i = 0; i < count; ++i) {
      this.from[i] = runs[3 * i]!;
      this.length[i] = runs[3 * i + 1]!;
      this.label[i] = runs[3 * i + 2]!;
    }
  }

  // The first run of row y that ends beyond column x; rowStart[y + 1] if none does.
  firstRun(y: number, x: number): number {
    let low = this.rowStart[y]!;
    let high = this.rowStart[y + 1]!;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.from[middle]! + this.length[middle]! <= x) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  // The obstacle on a cell; 0 where it is free or off the map.
  at(x: number, y: number): number {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) return 0;
    const run = this.firstRun(y, x);
    return run < this.rowStart[y + 1]! && this.from[run]! <= x ? this.label[run]! : 0;
  }

  obstacle(id: number): Obstacle | undefined {
    return this.obstacles[id - 1];
  }

  // All of an obstacle's runs, or those that reach into a part of the map.
  runsOf(id: number, part: Box = mapBox(this)): Run[] {
    const bounds = this.obstacle(id)?.bounds;
    const runs: Run[] = [];
    if (!bounds) return runs;
    const [left, right] = [Math.max(bounds[0], part.left), Math.min(bounds[2], part.right)];
    const last = Math.min(bounds[3], Math.floor(part.bottom));
    for (let y = Math.max(bounds[1], Math.ceil(part.top)); y <= last; ++y) {
      for (let i = this.firstRun(y, left); i < this.rowStart[y + 1]! && this.from[i]! <= right; ++i) {
        if (this.label[i] === id) runs.push([this.from[i]!, y, this.length[i]!]);
      }
    }
    return runs;
  }
}
