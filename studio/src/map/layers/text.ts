// Text that reads on any ground: with a halo behind it.
import type { Point } from "../../domain/geometry";
import { type Frame, typeface } from "../viewport/frame";

interface TextStyle {
  font: string; // weight and size, such as "600 12px"
  align: CanvasTextAlign;
  baseline?: CanvasTextBaseline;
  colour: string | CanvasGradient | CanvasPattern;
}

export function drawText({ context, theme }: Frame, text: string, [x, y]: Point, style: TextStyle): void {
  context.font = `${style.font} ${typeface}`;
  context.textAlign = style.align;
  context.textBaseline = style.baseline ?? "middle";
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = theme.halo;
  context.strokeText(text, x, y);
  context.fillStyle = style.colour;
  context.fillText(text, x, y);
}
