// What a freehand stroke covers: the cells whose centres lie within its radius, as runs.
import type { CellMap } from "../../domain/cell_map";
import type { Point, Run } from "../../domain/geometry";

// Points of the pointer, in map points; none of the result is off the map.
export function strokeRuns(points: readonly Point[], radius: number, cells: CellMap): Run[] {
  const covered = new Set<number>();
  points.forEach((point, i) => {
    const [ax, ay] = points[Math.max(i - 1, 0)]!;
    const [bx, by] = point;
    const steps = Math.max(1, Math.ceil(2 * Math.hypot(bx - ax, by - ay)));
    for (let k = 0; k <= steps; ++k) {
      dab(covered, ax + ((bx - ax) * k) / steps, ay + ((by - ay) * k) / steps, radius, cells);
    }
  });
  return runsOf([...covered].sort((a, b) => a - b), cells.width);
}

// Only blocked cells: what the eraser changes.
export function blocked(runs: readonly Run[], cells: CellMap): Run[] {
  const found: number[] = [];
  for (const [x, y, length] of runs) {
    for (let k = x; k < x + length; ++k) if (cells.at(k, y) !== 0) found.push(y * cells.width + k);
  }
  return runsOf(found, cells.width);
}

function dab(covered: Set<number>, x: number, y: number, radius: number, cells: CellMap): void {
  const bottom = Math.min(Math.floor(y + radius), cells.height - 1);
  for (let row = Math.max(Math.ceil(y - radius), 0); row <= bottom; ++row) {
    const half = Math.sqrt(Math.max(0, radius ** 2 - (row - y) ** 2));
    const right = Math.min(Math.floor(x + half), cells.width - 1);
    for (let column = Math.max(Math.ceil(x - half), 0); column <= right; ++column) {
      covered.add(row * cells.width + column);
    }
  }
}

// Of cells y * width + x in rising order.
function runsOf(sorted: readonly number[], width: number): Run[] {
  const runs: Run[] = [];
  for (const cell of sorted) {
    const [x, y] = [cell % width, Math.floor(cell / width)];
    const last = runs.at(-1);
    if (last && last[1] === y && last[0] + last[2] === x) ++last[2];
    else runs.push([x, y, 1]);
  }
  return runs;
}
