// What lies below everything: the map's own picture, its edge, and the cells where one is near enough to count them.
import { mapBox } from "../../domain/geometry";
import type { Scene } from "../../domain/scene";
import type { TileCache } from "../tiles/tile_cache";
import { toMap } from "../viewport/camera";
import { type Frame, inMapPoints, place } from "../viewport/frame";

const gridFrom = 14; // pixels per cell

// Before there is a map: a canvas that nobody has drawn on is black.
export function drawNothing({ context, theme, view }: Pick<Frame, "context" | "theme" | "view">): void {
  context.fillStyle = theme.outside;
  context.fillRect(0, 0, view.width, view.height);
}

export function drawGround(frame: Frame, scene: Scene, tiles: TileCache): void {
  const { context, theme, view } = frame;
  drawNothing(frame);
  const box = mapBox(scene.map);
  const [left, top] = place(frame, [box.left, box.top]);
  const [right, bottom] = place(frame, [box.right, box.bottom]);
  context.save();
  context.beginPath(); // the last tiles reach beyond the map
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  context.imageSmoothingQuality = "low";
  tiles.draw(context, frame.camera, view, frame.pixelRatio, scene.map);
  context.restore();
  context.strokeStyle = theme.frame;
  context.lineWidth = 1;
  context.strokeRect(left - 0.5, top - 0.5, right - left + 1, bottom - top + 1);
}

export function drawGrid(frame: Frame, scene: Scene): void {
  const { context, theme, view, camera } = frame;
  if (camera.scale < gridFrom) return;
  const box = mapBox(scene.map);
  const [x0, y0] = toMap(camera, view, [0, 0]);
  const [x1, y1] = toMap(camera, view, [view.width, view.height]);
  const [left, right] = [Math.max(x0, box.left), Math.min(x1, box.right)];
  const [top, bottom] = [Math.max(y0, box.top), Math.min(y1, box.bottom)];
  inMapPoints(frame, (pixel) => {
    context.beginPath();
    for (let x = Math.ceil(left + 0.5) - 0.5; x < right; ++x) {
      context.moveTo(x, top);
      context.lineTo(x, bottom);
    }
    for (let y = Math.ceil(top + 0.5) - 0.5; y < bottom; ++y) {
      context.moveTo(left, y);
      context.lineTo(right, y);
    }
    context.globalAlpha = 0.35 * Math.min(1, (camera.scale - gridFrom) / 10);
    context.strokeStyle = theme.frame;
    context.lineWidth = pixel;
    context.stroke();
    context.globalAlpha = 1;
  });
}

// The middle of the view, where the keyboard selects.
export function drawCross(frame: Frame): void {
  const { context, theme, view } = frame;
  const [x, y] = [Math.round(view.width / 2) + 0.5, Math.round(view.height / 2) + 0.5];
  context.beginPath();
  for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
    context.moveTo(x + 4 * dx, y + 4 * dy);
    context.lineTo(x + 13 * dx, y + 13 * dy);
  }
  context.lineCap = "round";
  context.strokeStyle = theme.halo;
  context.lineWidth = 5;
  context.stroke();
  context.strokeStyle = theme.ink;
  context.lineWidth = 2;
  context.stroke();
}
