// Which part of the map is seen. Map points are as in plans: a whole point is the centre of a cell, y down; pixels are
// CSS pixels from the upper-left corner of the view.
import { type Box, mapBox, type Point, type Size } from "../../domain/geometry";

export interface Camera {
  x: number; // the map point in the middle of the view
  y: number;
  scale: number; // pixels per cell
}

export const maxScale = 48;

export function toScreen(camera: Camera, view: Size, [x, y]: Point): Point {
  return [(x - camera.x) * camera.scale + view.width / 2, (y - camera.y) * camera.scale + view.height / 2];
}

export function toMap(camera: Camera, view: Size, [x, y]: Point): Point {
  return [(x - view.width / 2) / camera.scale + camera.x, (y - view.height / 2) / camera.scale + camera.y];
}

export function visibleBox(camera: Camera, view: Size): Box {
  const [left, top] = toMap(camera, view, [0, 0]);
  const [right, bottom] = toMap(camera, view, [view.width, view.height]);
  return { left, top, right, bottom };
}

// Whether what lies in a box is to be seen, clear of the edge: all of it, or what fills all of the view.
export function isSeen(box: Box, seen: Box, margin: number): boolean {
  const within = (from: number, until: number, low: number, high: number) =>
    (from >= low + margin && until <= high - margin) || (from <= low && until >= high);
  return within(box.left, box.right, seen.left, seen.right) && within(box.top, box.bottom, seen.top, seen.bottom);
}

// Pixels at the sides of a view that are to stay free: something else is there.
export type Insets = Box;

export function evenly(inset: number): Insets {
  return { left: inset, top: inset, right: inset, bottom: inset };
}

// Shows all of a box in the middle of what the insets leave.
export function fitted(box: Box, view: Size, insets: Insets): Camera {
  const width = Math.max(1, view.width - insets.left - insets.right);
  const height = Math.max(1, view.height - insets.top - insets.bottom);
  const scale = Math.min(width / (box.right - box.left), height / (box.bottom - box.top), maxScale);
  return {
    x: (box.left + box.right) / 2 + (insets.right - insets.left) / 2 / scale,
    y: (box.top + box.bottom) / 2 + (insets.bottom - insets.top) / 2 / scale,
    scale,
  };
}

// All of a map, with room below it for scale bar and attribution, and in a high view above it for the tools.
export function wholeMap(map: Size, view: Size): Camera {
  return fitted(mapBox(map), view, { left: 12, top: view.height < 480 ? 12 : 68, right: 12, bottom: 34 });
}

// The camera kept to what makes sense: not much smaller than the whole map, never off it.
export function limited(camera: Camera, view: Size, map: Size): Camera {
  const box = mapBox(map);
  const smallest = Math.min(fitted(box, view, evenly(0)).scale * 0.7, maxScale);
  return {
    x: Math.min(Math.max(camera.x, box.left), box.right),
    y: Math.min(Math.max(camera.y, box.top), box.bottom),
    scale: Math.min(Math.max(camera.scale, smallest), maxScale),
  };
}

export function panned(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, x: camera.x - dx / camera.scale, y: camera.y - dy / camera.scale };
}

// Zoomed so that the map point under pixel `at` stays there, unless a limit keeps it from that.
export function zoomed(camera: Camera, view: Size, map: Size, factor: number, at: Point): Camera {
  const [x, y] = toMap(camera, view, at);
  const scale = limited({ ...camera, scale: camera.scale * factor }, view, map).scale;
  const pulled = camera.scale / scale;
  return limited({ x: x + (camera.x - x) * pulled, y: y + (camera.y - y) * pulled, scale }, view, map);
}
