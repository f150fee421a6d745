// Rubble on the street: the free cells of a disc.
import type { CellMap } from "./cell_map";
import type { Cell, Point, Run } from "./geometry";

// As wide as a street of a city map; less on small maps.
export function rubbleRadius({ width, height }: Pick<CellMap, "width" | "height">): number {
  return Math.min(Math.max(Math.round(Math.min(width, height) / 100), 1), 4);
}

// None falls on a vehicle: `clear` are discs that stay free.
export function rubbleAt([cx, cy]: Cell, cells: CellMap, clear: readonly { at: Point; radius: number }[]): Run[] {
  const radius = rubbleRadius(cells);
  const isFree = (x: number, y: number) =>
    Math.hypot(x - cx, y - cy) <= radius + 0.5 &&
    x >= 0 && y >= 0 && x < cells.width && y < cells.height &&
    cells.at(x, y) === 0 &&
    clear.every((disc) => awayFromCell(disc.at, x, y) >= disc.radius);
  const runs: Run[] = [];
  for (let y = cy - radius; y <= cy + radius; ++y) {
    for (let x = cx - radius; x <= cx + radius; ++x) {
      if (!isFree(x, y)) continue;
      const last = runs.at(-1);
      if (last && last[1] === y && last[0] + last[2] === x) ++last[2];
      else runs.push([x, y, 1]);
    }
  }
  return runs;
}

function awayFromCell([px, py]: Point, x: number, y: number): number {
  return Math.hypot(Math.max(Math.abs(px - x) - 0.5, 0), Math.max(Math.abs(py - y) - 0.5, 0));
}

export function cellsOf(runs: readonly Run[]): Cell[] {
  return runs.flatMap(([x, y, length]) => Array.from({ length }, (_, i): Cell => [x + i, y]));
}
