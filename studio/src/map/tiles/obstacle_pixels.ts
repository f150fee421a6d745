// Obstacles as pixels of a tile. Runs are written straight into the picture: a tile costs what stands on it, at any
// level and on any map, be it a city of ten thousand buildings or a maze of one.
import type { CellMap } from "../../domain/cell_map";
import { span, type TileId, tileSize } from "./tiles";

export interface ObstacleColours {
  obstacle: string;
  obstacleEdge: string;
  fixed: string;
  fixedEdge: string;
}

type Rgb = readonly [number, number, number];

function rgb(hex: string): Rgb {
  const n = Number.parseInt(hex.slice(1, 7), 16);
  return [n >> 16, (n >> 8) & 255, n & 255];
}

// As canvases keep them: red in the lowest byte.
function pixel([r, g, b]: Rgb, alpha = 255): number {
  return ((alpha << 24) | (b << 16) | (g << 8) | r) >>> 0;
}

function mix(a: Rgb, b: Rgb, share: number): Rgb {
  const part = (i: 0 | 1 | 2): number => Math.round(a[i] + (b[i] - a[i]) * share);
  return [part(0), part(1), part(2)];
}

export function fixedObstacles(cells: CellMap): Uint8Array {
  const fixed = new Uint8Array(cells.obstacles.length + 1);
  for (const obstacle of cells.obstacles) fixed[obstacle.id] = obstacle.destructible ? 0 : 1;
  return fixed;
}

// RGBA of tileSize² pixels, clear where no obstacle is. `fixed` is the result of fixedObstacles().
export function obstaclePixels(
  cells: CellMap,
  fixed: Uint8Array,
  tile: TileId,
  colours: ObstacleColours,
): Uint32Array<ArrayBuffer> {
  return tile.level < 0 ? coarse(cells, fixed, tile, colours) : fine(cells, fixed, tile, colours);
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

// One cell is several pixels. A line parts an obstacle from what it touches; between two obstacles, only that with the
// lower number draws it, so that it is no wider than towards a street.
function fine(cells: CellMap, fixed: Uint8Array, tile: TileId, colours: ObstacleColours): Uint32Array<ArrayBuffer> {
  const pixels = new Uint32Array(tileSize * tileSize);
  const scale = 2 ** tile.level;
  const count = span(tile.level);
  const left = tile.column * count;
  const top = tile.row * count;
  const edgeShare = scale === 1 ? 0.35 : scale === 2 ? 0.75 : 1; // a line of one pixel is wide where a cell is one
  const fill = [pixel(rgb(colours.obstacle)), pixel(rgb(colours.fixed))];
  const edge = [
    pixel(mix(rgb(colours.obstacle), rgb(colours.obstacleEdge), edgeShare)),
    pixel(mix(rgb(colours.fixed), rgb(colours.fixedEdge), edgeShare)),
  ];
  const parts = (own: number, other: number): boolean => own !== other && (other === 0 || own < other);

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
        const [from, until] = [first + (i - 1) * scale, first + (end - 1) * scale];
        pixels.fill(fill[fixed[own]!]!, from, until);
        if (parts(own, row[i - 1]!)) pixels[from] = edge[fixed[own]!]!;
        if (parts(own, row[end]!)) pixels[until - 1] = edge[fixed[own]!]!;
      }
      i = end;
    }
    for (let k = 1; k < scale; ++k) pixels.copyWithin(first + k * tileSize, first, first + tileSize);
    for (let i = 1; i <= count; ++i) {
      const own = row[i]!;
      if (own === 0) continue;
      const x = (i - 1) * scale;
      if (parts(own, above[i]!)) pixels.fill(edge[fixed[own]!]!, first + x, first + x + scale);
      if (parts(own, below[i]!)) pixels.fill(edge[fixed[own]!]!, last + x, last + x + scale);
    }
    [above, row, below] = [row, below, above as typeof below];
  }
  return pixels;
}

// One pixel is several cells: how many are blocked says how much of it is seen.
function coarse(cells: CellMap, fixed: Uint8Array, tile: TileId, colours: ObstacleColours): Uint32Array<ArrayBuffer> {
  const shift = -tile.level;
  const count = span(tile.level);
  const left = tile.column * count;
  const right = Math.min(left + count, cells.width);
  const top = tile.row * count;
  const bottom = Math.min(top + count, cells.height);
  const covered = new Uint32Array(tileSize * tileSize);
  const coveredFixed = new Uint32Array(tileSize * tileSize);
  for (let y = top; y < bottom; ++y) {
    const line = ((y - top) >> shift) * tileSize;
    for (let i = cells.firstRun(y, left); i < cells.rowStart[y + 1]! && cells.from[i]! < right; ++i) {
      const into = fixed[cells.label[i]!] ? coveredFixed : covered;
      let from = Math.max(cells.from[i]!, left) - left;
      const end = Math.min(cells.from[i]! + cells.length[i]!, right) - left;
      while (from < end) {
        const next = Math.min(((from >> shift) + 1) << shift, end);
        into[line + (from >> shift)]! += next - from;
        from = next;
      }
    }
  }
  const alphaOf = 255 / 4 ** shift;
  // Lines are too fine here: a shade stands for them.
  const colour = mix(rgb(colours.obstacle), rgb(colours.obstacleEdge), 0.25);
  const fixedColour = mix(rgb(colours.fixed), rgb(colours.fixedEdge), 0.25);
  const clear = pixel(colour, 0);
  const pixels = new Uint32Array(tileSize * tileSize);
  for (let i = 0; i < pixels.length; ++i) {
    const solid = coveredFixed[i]!;
    const sum = covered[i]! + solid;
    if (sum === 0) continue;
    const shade = solid === 0 ? clear : pixel(mix(colour, fixedColour, solid / sum), 0);
    pixels[i] = (shade | (Math.round(sum * alphaOf) << 24)) >>> 0;
  }
  return pixels;
}
