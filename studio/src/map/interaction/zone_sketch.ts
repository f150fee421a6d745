// The outline of a zone that is being drawn, corner by corner.
import type { Point } from "../../domain/geometry";
import { type Frame, place } from "../viewport/frame";

const nearby = 10; // pixels

export class ZoneSketch {
  #corners: Point[] = [];
  #pointer: Point | null = null; // a point of the map

  get corners(): readonly Point[] {
    return this.#corners;
  }

  hover(at: Point | null): void {
    this.#pointer = at && snapped(at);
  }

  // Sets a corner at a point of the map; the whole outline where that closes it: at the first or the last corner again.
  // `scale`: pixels of a cell.
  add(at: Point, scale: number): Point[] | null {
    const corner = snapped(at);
    const [first, last] = [this.#corners[0], this.#corners.at(-1)];
    const isNear = (other: Point | undefined) =>
      other !== undefined && Math.hypot(other[0] - corner[0], other[1] - corner[1]) * scale < nearby;
    if (this.#corners.length >= 3 && (isNear(first) || isNear(last))) {
      const outline = this.#corners;
      this.drop();
      return outline;
    }
    if (!isNear(last)) this.#corners.push(corner);
    return null;
  }

  takeBack(): void {
    this.#corners.pop();
  }

  drop(): void {
    this.#corners = [];
  }

  draw(frame: Frame, colour: string): void {
    const { context, theme } = frame;
    const corners = this.#corners.map((corner) => place(frame, corner));
    const next = this.#pointer && place(frame, this.#pointer);
    if (corners.length > 0) {
      context.beginPath();
      [...corners, ...(next ? [next] : [])].forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
      for (const [stroke, width] of [[theme.halo, 5], [colour, 2.5]] as const) {
        context.strokeStyle = stroke;
        context.lineWidth = width;
        context.stroke();
      }
    }
    corners.forEach(([x, y], i) => {
      context.beginPath();
      context.arc(x, y, i === 0 ? 6 : 4, 0, 2 * Math.PI);
      context.fillStyle = i === 0 ? theme.card : colour;
      context.fill();
      context.strokeStyle = colour;
      context.lineWidth = 2;
      context.stroke();
    });
  }
}

// To halves of cells: centres and sides.
function snapped([x, y]: Point): Point {
  return [Math.round(2 * x) / 2, Math.round(2 * y) / 2];
}
