// From the place of something on the map to where it stands instead, so that others can be seen.
import type { Point } from "../../domain/geometry";
import type { Frame } from "../viewport/frame";

export function drawLeader({ context }: Frame, from: Point, to: Point, colour: string): void {
  if (Math.hypot(to[0] - from[0], to[1] - from[1]) < 1) return;
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.lineWidth = 2;
  context.strokeStyle = colour;
  context.stroke();
}
