// Where there is room beside what is marked already.
import { type Box, overlap, type Point } from "../../domain/geometry";

export function boxAround([x, y]: Point, width: number, height: number): Box {
  return { left: x - width / 2, top: y - height / 2, right: x + width / 2, bottom: y + height / 2 };
}

export function middleOf({ left, top, right, bottom }: Box): Point {
  return [(left + right) / 2, (top + bottom) / 2];
}

const side = 64; // pixels of a square

// Boxes by the squares they are in: cost must not grow with all pairs.
export class Boxes {
  readonly #squares = new Map<string, Box[]>();

  add(box: Box): void {
    for (const key of squares(box)) this.#squares.set(key, [...(this.#squares.get(key) ?? []), box]);
  }

  isFree(box: Box): boolean {
    return !squares(box).some((key) => this.#squares.get(key)?.some((other) => overlap(box, other)));
  }

  // The first of the places where a box of this size has room, and is kept free from then on.
  take(places: Iterable<Point>, width: number, height: number): Box | null {
    for (const place of places) {
      const box = boxAround(place, width, height);
      if (!this.isFree(box)) continue;
      this.add(box);
      return box;
    }
    return null;
  }
}

function squares({ left, top, right, bottom }: Box): string[] {
  const keys: string[] = [];
  for (let y = Math.floor(top / side); y <= Math.floor(bottom / side); ++y) {
    for (let x = Math.floor(left / side); x <= Math.floor(right / side); ++x) keys.push(`${x},${y}`);
  }
  return keys;
}

// A point, then above it, below and beside, further and further away.
export function* nearby([x, y]: Point, across: number, down: number, rings: number): Generator<Point> {
  yield [x, y];
  for (let ring = 1; ring <= rings; ++ring) {
    for (let column = 0; column <= ring; ++column) {
      for (const row of column < ring ? [-ring, ring] : upAndDown(ring)) {
        yield [x + column * across, y + row * down];
        if (column > 0) yield [x - column * across, y + row * down];
      }
    }
  }
}

const clearOfPlace = 14; // pixels from a place to what stands beside it

export function sideways([x, y]: Point, width: number, side: -1 | 1, away: number): Point {
  return [x + side * (clearOfPlace + width / 2 + away), y];
}

// Left, right, above and below a point that itself stays in sight, further and further away.
export function* beside(at: Point, width: number, height: number): Generator<Point> {
  for (let away = 0; away <= 160; away += 20) {
    yield sideways(at, width, -1, away);
    yield sideways(at, width, 1, away);
    yield [at[0], at[1] - clearOfPlace - height / 2 - away];
    yield [at[0], at[1] + clearOfPlace + height / 2 + away];
  }
}

// 0, -1, 1, ... -most, most
function upAndDown(most: number): number[] {
  return [0, ...Array.from({ length: most }, (_, i) => [-i - 1, i + 1]).flat()];
}
