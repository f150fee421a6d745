// Zones: an outline over a tint, those for aircraft dashed as their paths are; a name where there is room for it.
import type { Point } from "../../domain/geometry";
import type { Scene } from "../../domain/scene";
import type { Zone, ZoneKind } from "../../domain/zone";
import { type Frame, inMapPoints, place } from "../viewport/frame";
import type { Theme } from "../viewport/theme";
import { drawText } from "./text";

const tint = 0.16;

export function drawZones(frame: Frame, { zones, pointedZone }: Scene): void {
  if (zones.length === 0) return;
  inMapPoints(frame, (pixel) => {
    zones.forEach((zone, i) => drawZone(frame, zone, pixel, i === pointedZone));
  });
  for (const zone of zones) if (zone.name !== "") drawName(frame, zone);
}

export function zoneColour(theme: Theme, kind: ZoneKind): string {
  return kind === "no_fly" ? theme.noFly : theme.keepOut;
}

function drawZone({ context, theme }: Frame, { kind, rings }: Zone, pixel: number, isPointed: boolean): void {
  const path = new Path2D();
  for (const ring of rings) {
    ring.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    path.closePath();
  }
  const colour = zoneColour(theme, kind);
  context.fillStyle = colour;
  context.globalAlpha = isPointed ? 2 * tint : tint;
  context.fill(path, "evenodd");
  context.globalAlpha = 1;
  context.strokeStyle = colour;
  context.lineJoin = "round";
  context.lineWidth = (isPointed ? 4 : 2) * pixel;
  context.setLineDash(kind === "no_fly" ? [7 * pixel, 4 * pixel] : []);
  context.stroke(path);
  context.setLineDash([]);
}

function drawName(frame: Frame, { kind, name, rings }: Zone): void {
  const corners = rings[0]!.map((corner) => place(frame, corner));
  const middle = (i: 0 | 1) => (Math.min(...corners.map((p) => p[i])) + Math.max(...corners.map((p) => p[i]))) / 2;
  const width = Math.max(...corners.map(([x]) => x)) - Math.min(...corners.map(([x]) => x));
  const roomForLetter = 7; // pixels
  if (width < roomForLetter * name.length) return;
  const at: Point = [middle(0), middle(1)];
  drawText(frame, name, at, { font: "600 12px", align: "center", colour: zoneColour(frame.theme, kind) });
}
