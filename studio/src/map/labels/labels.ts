// Which names are written at a zoom, so that none covers another.
import { type Box, overlap, type Point } from "../../domain/geometry";
import type { Name } from "./names";

export interface Label {
  name: Name;
  at: Point; // the middle, in map points
  angle: number; // radians; upright enough to be read
}

export interface TextSize {
  width: number; // pixels
  height: number;
}

const gap = 6; // pixels between labels
const apart = 260; // between two labels of the same name
const repeat = 480; // pixels of a street for each time its name is written
const mostRepeats = 1000; // whatever a file says of its streets
const bend = 3; // pixels by which a street may leave the straight line of its name

// For pictures of at least `scale` pixels per cell. Names come in the order of their rank. Labels lie within `part` as a
// whole, so that those of different parts of a map cannot meet and each can be worked out when it is first seen.
export function placed(
  names: readonly Name[],
  scale: number,
  cellSize: number,
  part: Box,
  sizeOf: (name: Name) => TextSize,
): Label[] {
  const labels: Label[] = [];
  const taken = new Taken(part, scale);
  for (const name of names) {
    if (scale / cellSize < name.nearest || !overlap(name.box, part)) continue;
    const size = sizeOf(name);
    if (name.room > 0 && name.room * scale < size.width + 4) continue;
    const text = name.lines.join(" ");
    for (const { at, angle } of name.along ? spotsAlong(name.along, scale, size, part) : [{ at: name.at, angle: 0 }]) {
      const middle: Point = [at[0] * scale, at[1] * scale];
      if (taken.near(text, middle) || !taken.take(middle, angle, size)) continue;
      taken.remember(text, middle);
      labels.push({ name, at, angle });
    }
  }
  return labels;
}

// Upright boxes that cover a label: of one that lies aslant, the box around all of it would hold much else.
export function boxesAlong([x, y]: Point, angle: number, { width, height }: TextSize): Box[] {
  const count = Math.max(1, Math.ceil(width / height));
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  const length = width / count;
  const halfWidth = (Math.abs(dx) * length + Math.abs(dy) * height) / 2;
  const halfHeight = (Math.abs(dy) * length + Math.abs(dx) * height) / 2;
  return Array.from({ length: count }, (_, i) => {
    const along = (i + 0.5) * length - width / 2;
    const [cx, cy] = [x + along * dx, y + along * dy];
    return { left: cx - halfWidth, right: cx + halfWidth, top: cy - halfHeight, bottom: cy + halfHeight };
  });
}

// Where a name fits along a line that is straight for its length.
function spotsAlong(
  line: readonly Point[],
  scale: number,
  { width, height }: TextSize,
  part: Box,
): { at: Point; angle: number }[] {
  const lengths = [0];
  for (let i = 1; i < line.length; ++i) {
    const [ax, ay] = line[i - 1]!;
    const [bx, by] = line[i]!;
    lengths.push(lengths[i - 1]! + scale * Math.hypot(bx - ax, by - ay));
  }
  const total = lengths.at(-1)!;
  const length = width + height;
  if (total < length) return [];
  const found: { at: Point; angle: number }[] = [];
  const count = Math.min(Math.max(1, Math.floor(total / repeat)), mostRepeats);
  for (let k = 0; k < count; ++k) {
    const middle = (total * (k + 0.5)) / count;
    const [x, y] = pointAt(line, lengths, middle);
    const reach = (2 * length) / scale;
    if (!overlap({ left: x - reach, right: x + reach, top: y - reach, bottom: y + reach }, part)) continue;
    for (const shift of [0, -0.5, 0.5, -1, 1, -1.5, 1.5]) {
      const from = middle + shift * length - length / 2;
      if (from < 0 || from + length > total) continue;
      const spot = straight(line, lengths, from, from + length, scale);
      if (!spot) continue;
      found.push(spot);
      break;
    }
  }
  return found;
}

function straight(
  line: readonly Point[],
  lengths: readonly number[],
  from: number,
  until: number,
  scale: number,
): { at: Point; angle: number } | null {
  const a = pointAt(line, lengths, from);
  const b = pointAt(line, lengths, until);
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const chord = Math.hypot(dx, dy);
  if (chord === 0 || chord * scale < 0.97 * (until - from)) return null;
  for (let i = 0; i < line.length; ++i) {
    if (lengths[i]! <= from || lengths[i]! >= until) continue;
    const away = Math.abs((line[i]![0] - a[0]) * dy - (line[i]![1] - a[1]) * dx) / chord;
    if (away * scale > bend) return null;
  }
  const angle = Math.atan2(dy, dx);
  const upright = angle > Math.PI / 2 ? angle - Math.PI : angle <= -Math.PI / 2 ? angle + Math.PI : angle;
  return { at: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], angle: upright };
}

function pointAt(line: readonly Point[], lengths: readonly number[], length: number): Point {
  let i = 1;
  while (i < line.length - 1 && lengths[i]! < length) ++i;
  const [ax, ay] = line[i - 1]!;
  const [bx, by] = line[i]!;
  const whole = lengths[i]! - lengths[i - 1]!;
  const share = whole > 0 ? (length - lengths[i - 1]!) / whole : 0;
  return [ax + share * (bx - ax), ay + share * (by - ay)];
}

// A label's rectangle, in pixels of the whole map at this zoom.
interface Plate {
  x: number; // the middle
  y: number;
  cos: number;
  sin: number;
  halfWidth: number;
  halfHeight: number;
}

const side = 128; // of the squares by which plates are found

// Room taken by labels.
class Taken {
  readonly #squares = new Map<number, Plate[]>();
  readonly #texts = new Map<string, Point[]>();

  constructor(
    private readonly part: Box,
    private readonly scale: number,
  ) {}

  take([x, y]: Point, angle: number, { width, height }: TextSize): boolean {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const plate = { x, y, cos, sin, halfWidth: (width + gap) / 2, halfHeight: (height + gap) / 2 };
    const box = around(plate);
    if (box.left < this.part.left * this.scale || box.right > this.part.right * this.scale) return false;
    if (box.top < this.part.top * this.scale || box.bottom > this.part.bottom * this.scale) return false;
    const keys = squares(box);
    for (const key of keys) {
      if (this.#squares.get(key)?.some((other) => cover(plate, other))) return false;
    }
    for (const key of keys) {
      const known = this.#squares.get(key);
      if (known) known.push(plate);
      else this.#squares.set(key, [plate]);
    }
    return true;
  }

  near(text: string, [x, y]: Point): boolean {
    return this.#texts.get(text)?.some(([ox, oy]) => Math.hypot(ox - x, oy - y) < apart) ?? false;
  }

  remember(text: string, at: Point): void {
    const known = this.#texts.get(text);
    if (known) known.push(at);
    else this.#texts.set(text, [at]);
  }
}

function around({ x, y, cos, sin, halfWidth, halfHeight }: Plate): Box {
  const dx = Math.abs(cos) * halfWidth + Math.abs(sin) * halfHeight;
  const dy = Math.abs(sin) * halfWidth + Math.abs(cos) * halfHeight;
  return { left: x - dx, top: y - dy, right: x + dx, bottom: y + dy };
}

function squares({ left, top, right, bottom }: Box): number[] {
  const keys: number[] = [];
  for (let j = Math.floor(top / side); j <= Math.floor(bottom / side); ++j) {
    for (let i = Math.floor(left / side); i <= Math.floor(right / side); ++i) keys.push(j * 0x100000 + i);
  }
  return keys;
}

// Whether two rectangles have a point in common: unless a line along a side of one parts them.
function cover(a: Plate, b: Plate): boolean {
  return !parts(a, b) && !parts(b, a);
}

function parts(a: Plate, b: Plate): boolean {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const cos = Math.abs(a.cos * b.cos + a.sin * b.sin);
  const sin = Math.abs(a.cos * b.sin - a.sin * b.cos);
  return (
    Math.abs(dx * a.cos + dy * a.sin) >= a.halfWidth + b.halfWidth * cos + b.halfHeight * sin ||
    Math.abs(dy * a.cos - dx * a.sin) >= a.halfHeight + b.halfWidth * sin + b.halfHeight * cos
  );
}
