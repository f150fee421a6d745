// The pyramid of tiles: level n has 2ⁿ pixels per cell, cut into squares of `tileSize` pixels from the map's corner.
import type { Box, Size } from "../../domain/geometry";

export const tileSize = 256;
export const finestLevel = 6;

export interface TileId {
  level: number;
  column: number;
  row: number;
}

export function keyOf({ level, column, row }: TileId): string {
  return `${level}/${column}/${row}`;
}

// The level whose whole map is one tile: always there, for lack of better.
export function coarsestLevel(map: Size): number {
  return Math.min(0, Math.floor(Math.log2(tileSize / Math.max(map.width, map.height))));
}

// The level to draw at so many device pixels per cell: pictures are rather made smaller than larger, which blurs.
export function levelFor(scale: number, coarsest: number): number {
  return Math.min(finestLevel, Math.max(coarsest, Math.ceil(Math.log2(scale) - 0.2)));
}

// Cells on a side of a tile.
export function span(level: number): number {
  return tileSize / 2 ** level;
}

// In map points.
export function boxOf(tile: TileId): Box {
  const cells = span(tile.level);
  const left = tile.column * cells - 0.5;
  const top = tile.row * cells - 0.5;
  return { left, top, right: left + cells, bottom: top + cells };
}

// The tiles over a part of the map, those nearest to its middle first.
export function tilesOver(box: Box, level: number, map: Size): TileId[] {
  const cells = span(level);
  const index = (at: number, limit: number): number =>
    Math.min(Math.max(Math.floor((at + 0.5) / cells), 0), Math.ceil(limit / cells) - 1);
  const columns = [index(box.left, map.width), index(box.right, map.width)] as const;
  const rows = [index(box.top, map.height), index(box.bottom, map.height)] as const;
  const tiles: TileId[] = [];
  for (let row = rows[0]; row <= rows[1]; ++row) {
    for (let column = columns[0]; column <= columns[1]; ++column) tiles.push({ level, column, row });
  }
  const [x, y] = [(columns[0] + columns[1]) / 2, (rows[0] + rows[1]) / 2];
  const distance = (tile: TileId): number => (tile.column - x) ** 2 + (tile.row - y) ** 2;
  return tiles.sort((a, b) => distance(a) - distance(b));
}

export function parentOf({ level, column, row }: TileId): TileId {
  return { level: level - 1, column: column >> 1, row: row >> 1 };
}

// The part of an ancestor's picture where a tile's is, in pixels.
export function partOf(tile: TileId, ancestor: TileId): { x: number; y: number; size: number } {
  const ratio = 2 ** (tile.level - ancestor.level);
  const size = tileSize / ratio;
  return { x: (tile.column - ancestor.column * ratio) * size, y: (tile.row - ancestor.row * ratio) * size, size };
}
