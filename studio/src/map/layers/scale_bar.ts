// How long the metres are; or the cells, where the map does not say how large they are.
import type { MapDescription } from "../../domain/map";
import type { Frame } from "../viewport/frame";
import { drawText } from "./text";

// The longest of 1, 2, 5, 10, 20, ... metres that is at most so many pixels long.
export function roundLength(metresPerPixel: number, pixels: number): number {
  const most = metresPerPixel * pixels;
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((digit) => digit * power).find((length) => length <= most) ?? power;
}

export function lengthText(metres: number): string {
  if (metres >= 1000) return `${metres / 1000} km`;
  return metres >= 1 ? `${metres} m` : `${Math.round(metres * 100)} cm`;
}

export function cellsText(cells: number): string {
  return cells === 1 ? "1 cell" : `${cells} cells`;
}

export function drawScaleBar(frame: Frame, map: MapDescription): void {
  const { context, theme, view, camera } = frame;
  const metric = map.georeference !== null || map.cell_size !== 1;
  const unitsPerPixel = map.cell_size / camera.scale;
  const units = roundLength(unitsPerPixel, Math.min(120, view.width / 4));
  const text = metric ? lengthText(units) : cellsText(units);
  const length = units / unitsPerPixel;
  const x = 16;
  const y = view.height - 16;
  const line = (): void => {
    context.beginPath();
    context.moveTo(x, y - 6);
    context.lineTo(x, y);
    context.lineTo(x + length, y);
    context.lineTo(x + length, y - 6);
    context.stroke();
  };
  context.lineCap = "butt";
  context.lineJoin = "miter";
  context.strokeStyle = theme.halo;
  context.lineWidth = 4.5;
  line();
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  line();
  drawText(frame, text, [x + 6, y - 5], { font: "500 11.5px", align: "left", baseline: "alphabetic", colour: theme.ink });
}
