// Outlines of obstacles as paths to fill and stroke, made when first needed. A building's is made whole. One of a maze
// or of a whole country would take long to make and to draw: of those, the part in view is made, and no finer than the
// screen shows.
import type { CellMap } from "../../domain/cell_map";
import { type Box, intersection, overlap, type Point, type Run } from "../../domain/geometry";
import type { Obstacle } from "../../domain/map";
import { middleOf } from "../labels/names";
import { visibleBox } from "../viewport/camera";
import type { Frame } from "../viewport/frame";
import { outline } from "./outline";

const large = 20000; // cells
const finest = 3; // pixels: the finest detail of a large one
const block = 256; // its parts have corners at multiples of so many of its squares
const mostPaths = 500;

export class Outlines {
  readonly #paths = new Map<string, Path2D>();
  readonly #middles = new Map<number, Point>();

  constructor(private readonly cells: CellMap) {}

  of(id: number, { camera, view }: Frame): Path2D {
    const obstacle = this.cells.obstacle(id);
    if (!obstacle) return new Path2D();
    if (obstacle.cells <= large) return this.#path(String(id), () => outline(this.cells.runsOf(id)));
    const side = 2 ** Math.max(0, Math.ceil(Math.log2(finest / camera.scale)));
    const part = partInView(obstacle, visibleBox(camera, view), side);
    if (!part) return new Path2D();
    return this.#path(`${id} ${side} ${part.left} ${part.top} ${part.right} ${part.bottom}`, () => {
      const loops = outline(coarser(this.cells.runsOf(id, part), side));
      return loops.map((loop) => loop.map(([x, y]): Point => [(x + 0.5) * side - 0.5, (y + 0.5) * side - 0.5]));
    });
  }

  middleOf(id: number): Point | null {
    const obstacle = this.cells.obstacle(id);
    if (!obstacle) return null;
    const middle = this.#middles.get(id) ?? middleOf(obstacle, this.cells).at;
    this.#middles.set(id, middle);
    return middle;
  }

  #path(key: string, loops: () => Point[][]): Path2D {
    let path = this.#paths.get(key);
    if (path) return path;
    if (this.#paths.size >= mostPaths) this.#paths.clear();
    path = new Path2D();
    for (const loop of loops()) {
      loop.forEach(([x, y], i) => (i === 0 ? path!.moveTo(x, y) : path!.lineTo(x, y)));
      path.closePath();
    }
    this.#paths.set(key, path);
    return path;
  }
}

function partInView({ bounds: [left, top, right, bottom] }: Obstacle, seen: Box, side: number): Box | null {
  const whole = { left, top, right, bottom };
  if (!overlap(whole, seen)) return null;
  const step = block * side;
  return intersection(whole, {
    left: Math.floor(seen.left / step) * step - side, // a square more: its edge is not to be seen
    top: Math.floor(seen.top / step) * step - side,
    right: Math.ceil(seen.right / step) * step + side,
    bottom: Math.ceil(seen.bottom / step) * step + side,
  });
}

// Squares of so many cells on a side that hold at least one of the cells, as runs.
export function coarser(runs: readonly Run[], side: number): Run[] {
  if (side === 1) return [...runs];
  const rows = new Map<number, Set<number>>();
  for (const [x, y, length] of runs) {
    const row = Math.floor(y / side);
    let squares = rows.get(row);
    if (!squares) rows.set(row, (squares = new Set()));
    for (let k = Math.floor(x / side); k <= Math.floor((x + length - 1) / side); ++k) squares.add(k);
  }
  return [...rows].flatMap(([y, squares]) => [...squares].map((x): Run => [x, y, 1]));
}
