// Cells are [x, y], counted from the upper-left one; points are in cells, a whole point is the centre of a cell, y down.

export type Cell = [number, number];
export type Point = [number, number];

// Runs of cells to the right.
export type Run = [x: number, y: number, length: number];

export interface Size {
  width: number;
  height: number;
}

// Map points; a map of 3 cells reaches from -0.5 to 2.5.
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export function mapBox(map: Size): Box {
  return { left: -0.5, top: -0.5, right: map.width - 0.5, bottom: map.height - 0.5 };
}

export function grown(box: Box, by: number): Box {
  return { left: box.left - by, top: box.top - by, right: box.right + by, bottom: box.bottom + by };
}

export function overlap(a: Box, b: Box): boolean {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

export function intersection(a: Box, b: Box): Box {
  return {
    left: Math.max(a.left, b.left),
    top: Math.max(a.top, b.top),
    right: Math.min(a.right, b.right),
    bottom: Math.min(a.bottom, b.bottom),
  };
}
