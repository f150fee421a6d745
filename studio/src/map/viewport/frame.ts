// One picture being drawn: what every part of the map's drawing is given.
import type { Point, Size } from "../../domain/geometry";
import { type Camera, toScreen } from "./camera";
import type { Theme } from "./theme";

export interface Frame {
  context: CanvasRenderingContext2D; // one unit is a CSS pixel
  camera: Camera;
  view: Size;
  pixelRatio: number;
  theme: Theme;
  now: number; // milliseconds, for what moves by itself
  still: boolean; // whether people asked for less motion
}

export function place(frame: Pick<Frame, "camera" | "view">, point: Point): Point {
  return toScreen(frame.camera, frame.view, point);
}

// Draws in map points; `pixel` is as much as one CSS pixel.
export function inMapPoints(frame: Frame, draw: (pixel: number) => void): void {
  const { context, camera, view } = frame;
  context.save();
  context.translate(view.width / 2, view.height / 2);
  context.scale(camera.scale, camera.scale);
  context.translate(-camera.x, -camera.y);
  draw(1 / camera.scale);
  context.restore();
}

export const typeface = '"Inter", "Segoe UI", system-ui, -apple-system, "DejaVu Sans", sans-serif';
