// Where a marker may be set down.
import type { CellMap } from "../../domain/cell_map";
import type { Cell, Point } from "../../domain/geometry";

export function cellAt([x, y]: Point): Cell {
  return [Math.round(x), Math.round(y)];
}

export function onMap(cells: CellMap, [x, y]: Cell): Cell {
  return [Math.min(Math.max(x, 0), cells.width - 1), Math.min(Math.max(y, 0), cells.height - 1)];
}

// The free cell whose centre is nearest to a point; that point's own cell where the whole map is blocked.
export function nearestFree(cells: CellMap, point: Point): Cell {
  const [cx, cy] = onMap(cells, cellAt(point));
  let best: Cell = [cx, cy];
  let distance = Infinity;
  const last = Math.max(cells.width, cells.height);
  // Rings of cells around the first: a ring farther out than the best so far holds none nearer.
  for (let ring = 0; ring <= last && ring - 1 < Math.sqrt(distance); ++ring) {
    for (let y = cy - ring; y <= cy + ring; ++y) {
      const step = Math.abs(y - cy) === ring ? 1 : Math.max(1, 2 * ring);
      for (let x = cx - ring; x <= cx + ring; x += step) {
        const away = (x - point[0]) ** 2 + (y - point[1]) ** 2;
        const inside = x >= 0 && y >= 0 && x < cells.width && y < cells.height;
        if (away >= distance || !inside || cells.at(x, y) !== 0) continue;
        best = [x, y];
        distance = away;
      }
    }
  }
  return best;
}
