// Obstacles as pixels of a tile. Runs are written straight into the picture: a tile costs what stands on it, at any
// level and on any map, be it a city of ten thousand buildings or a maze of one.
import type { CellMap } from "../../domain/cell_map";
import { type Look, lookOf, looks, type Ruled } from "../../domain/looks";
import { pixel, type Rgb, rgb } from "./pixel";
import { span, type TileId, tileSize } from "./tiles";

export type ObstacleColours = Record<Look, { fill: string; edge: string }>;

function mix(a: Rgb, b: Rgb, share: number): Rgb {
  const part = (i: 0 | 1 | 2): number => Math.round(a[i] + (b[i] - a[i]) * share);
  return [part(0), part(1), part(2)];
}

const faint = 0.3;

// What drawing asks of each obstacle, by its id.
export class ObstacleLooks {
  readonly of: Uint8Array; // index into `looks`
  readonly #ofOne = new Map<number, boolean>();
  readonly #there: ReadonlySet<number>;

  constructor(
    private readonly cells: CellMap,
    ruled?: Ruled,
  ) {
    this.of = new Uint8Array(cells.obstacles.length + 1);
    for (const obstacle of cells.obstacles) this.of[obstacle.id] = looks.indexOf(lookOf(obstacle, ruled));
    this.#there = new Set(this.of.subarray(1));
  }

  // Whether any obstacle has this look.
  has(look: number): boolean {
    return this.#there.has(look);
  }

  // How strongly an obstacle is parted from what it touches: 0, faint, or 1. Between two, only that with the lower number
  // draws a line, so that it is no wider than towards a street. Waters run into each other, and sections of one
  // building are parted faintly.
  line(own: number, other: number): number {
    if (own === other || (other !== 0 && other < own)) return 0;
    if (other === 0) return 1;
    const look = looks[this.of[own]!]!;
    const ground = look === "water" || look === "cliff" || look === "forbidden" || look === "off_road" || look === "unknown";
    if (ground && this.of[own] === this.of[other]) return 0;
    return this.#areOfOne(own, other) ? faint : 1;
  }

  // Asked for each cell along their border.
  #areOfOne(a: number, b: number): boolean {
    const pair = a * this.of.length + b;
    let known = this.#ofOne.get(pair);
    if (known === undefined) this.#ofOne.set(pair, (known = this.#shareStructure(a, b)));
    return known;
  }

  #shareStructure(a: number, b: number): boolean {
    const [of, others] = [this.cells.obstacle(a)?.structures, this.cells.obstacle(b)?.structures];
    if (!of || !others) return false;
    return of.some(({ source_id }) => source_id !== undefined && others.some((one) => one.source_id === source_id));
  }
}

// RGBA of tileSize² pixels, clear where no obstacle is.
export function obstaclePixels(
  cells: CellMap,
  obstacles: ObstacleLooks,
  tile: TileId,
  colours: ObstacleColours,
): Uint32Array<ArrayBuffer> {
  const shades = looks.map((look) => ({ fill: rgb(colours[look].fill), edge: rgb(colours[look].edge) }));
  const paint = tile.level < 0 ? coarse : fine;
  const pixels = paint(cells, obstacles, tile, shades);
  addPatterns(pixels, shades, tile.level, obstacles);
  return pixels;
}

interface Shade {
  fill: Rgb;
  edge: Rgb;
}

// Lines are too fine in overviews: a shade stands for them.
function overviewFill({ fill, edge }: Shade): Rgb {
  return mix(fill, edge, 0.25);
}

// So that ground differs by more than its colour, in print as well: waves on water, stripes on what is forbidden,
// dots off the roads, a lattice where nobody knows. They go on from tile to tile, whose side is a multiple of theirs.
const patterns: Partial<Record<Look, (x: number, y: number) => boolean>> = {
  water: (x, y) => y % 8 === 4 && (x + (y & 8)) % 16 < 8,
  forbidden: (x, y) => ((x - y) & 7) < 2, // across those of what is removed
  off_road: (x, y) => y % 8 === 4 && (x + (y & 8) / 2) % 8 === 2,
  unknown: (x, y) => ((x - y) & 7) === 0 || ((x + y) & 7) === 0,
};

function addPatterns(pixels: Uint32Array, shades: Shade[], level: number, obstacles: ObstacleLooks): void {
  looks.forEach((look, i) => {
    const marks = patterns[look];
    if (!marks || !obstacles.has(i)) return;
    const shade = shades[i]!;
    const plain = pixel(level < 0 ? overviewFill(shade) : shade.fill);
    const marked = pixel(mix(shade.fill, shade.edge, 0.6));
    for (let k = pixels.indexOf(plain); k >= 0; k = pixels.indexOf(plain, k + 1)) {
      if (marks(k % tileSize, Math.floor(k / tileSize))) pixels[k] = marked;
    }
  });
}

// Labels of cells [left, left + row.length) of row y; 0 off the map.
function labelsInto(row: Uint32Array, cells: CellMap, left: number, y: number): Uint32Array {
  row.fill(0);
  if (y < 0 || y >= cells.height) return row;
  for (let i = cells.firstRun(y, left); i < cells.rowStart[y + 1]!; ++i) {
    const from = cells.from[i]! - left;
    if (from >= row.length) break;
    row.fill(cells.label[i]!, Math.max(from, 0), from + cells.length[i]!);
  }
  return row;
}

// One cell is several pixels. A line parts an obstacle from what it touches.
function fine(cells: CellMap, obstacles: ObstacleLooks, tile: TileId, shades: Shade[]): Uint32Array<ArrayBuffer> {
  const pixels = new Uint32Array(tileSize * tileSize);
  const scale = 2 ** tile.level;
  const count = span(tile.level);
  const left = tile.column * count;
  const top = tile.row * count;
  const edgeShare = scale === 1 ? 0.35 : scale === 2 ? 0.75 : 1; // a line of one pixel is wide where a cell is one
  const fills = shades.map(({ fill }) => pixel(fill));
  const edges = shades.map((shade) => pixel(mix(shade.fill, shade.edge, edgeShare)));
  const faintEdges = shades.map((shade) => pixel(mix(shade.fill, shade.edge, faint * edgeShare)));
  // The colour of the line that parts two; 0 where there is none.
  const line = (own: number, other: number): number => {
    if (own === other) return 0;
    const strength = obstacles.line(own, other);
    return strength === 0 ? 0 : (strength === faint ? faintEdges : edges)[obstacles.of[own]!]!;
  };

  let above = labelsInto(new Uint32Array(count + 2), cells, left - 1, top - 1);
  let row = labelsInto(new Uint32Array(count + 2), cells, left - 1, top);
  let below = new Uint32Array(count + 2);
  for (let j = 0; j < count; ++j) {
    below = labelsInto(below, cells, left - 1, top + j + 1) as typeof below;
    const first = j * scale * tileSize;
    const last = first + (scale - 1) * tileSize;
    // The first line of pixels has the sides, the others are like it; then come tops and bottoms.
    for (let i = 1; i <= count; ) {
      const own = row[i]!;
      let end = i + 1;
      while (end <= count && row[end] === own) ++end;
      if (own !== 0) {
        const from = first + (i - 1) * scale;
        const until = first + (end - 1) * scale;
        pixels.fill(fills[obstacles.of[own]!]!, from, until);
        pixels[from] = line(own, row[i - 1]!) || pixels[from]!;
        pixels[until - 1] = line(own, row[end]!) || pixels[until - 1]!;
      }
      i = end;
    }
    for (let k = 1; k < scale; ++k) pixels.copyWithin(first + k * tileSize, first, first + tileSize);
    for (let i = 1; i <= count; ++i) {
      const own = row[i]!;
      if (own === 0) continue;
      const x = (i - 1) * scale;
      const upper = line(own, above[i]!);
      const lower = line(own, below[i]!);
      if (upper !== 0) pixels.fill(upper, first + x, first + x + scale);
      if (lower !== 0) pixels.fill(lower, last + x, last + x + scale);
    }
    [above, row, below] = [row, below, above as typeof below];
  }
  return pixels;
}

// One pixel is several cells: how many are blocked says how much of it is seen, and each look has its share of the
// colour.
function coarse(cells: CellMap, obstacles: ObstacleLooks, tile: TileId, shades: Shade[]): Uint32Array<ArrayBuffer> {
  const shift = -tile.level;
  const count = span(tile.level);
  const left = tile.column * count;
  const right = Math.min(left + count, cells.width);
  const top = tile.row * count;
  const bottom = Math.min(top + count, cells.height);
  const colours = shades.map(overviewFill);
  const sum = () => new Uint32Array(tileSize * tileSize);
  const [covered, red, green, blue] = [sum(), sum(), sum(), sum()];
  for (let y = top; y < bottom; ++y) {
    const start = ((y - top) >> shift) * tileSize;
    for (let i = cells.firstRun(y, left); i < cells.rowStart[y + 1]! && cells.from[i]! < right; ++i) {
      const colour = colours[obstacles.of[cells.label[i]!]!]!;
      let from = Math.max(cells.from[i]!, left) - left;
      const end = Math.min(cells.from[i]! + cells.length[i]!, right) - left;
      while (from < end) {
        const next = Math.min(((from >> shift) + 1) << shift, end);
        const at = start + (from >> shift);
        covered[at]! += next - from;
        red[at]! += (next - from) * colour[0];
        green[at]! += (next - from) * colour[1];
        blue[at]! += (next - from) * colour[2];
        from = next;
      }
    }
  }
  const alphaOf = 255 / 4 ** shift;
  const pixels = new Uint32Array(tileSize * tileSize);
  for (let i = 0; i < pixels.length; ++i) {
    const sum = covered[i]!;
    if (sum !== 0) pixels[i] = pixel([red[i]! / sum, green[i]! / sum, blue[i]! / sum], Math.round(sum * alphaOf));
  }
  return pixels;
}
