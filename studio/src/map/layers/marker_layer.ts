// Draws the markers.
import type { Point } from "../../domain/geometry";
import { cellOf, type Handle, isAir, type Markers } from "../../domain/mission";
import { type Frame, place } from "../viewport/frame";
import { glyphs } from "./glyphs";
import { type Spot, spots } from "./marker_spots";
import { drawText } from "./text";

const radius = 13;
const smallRadius = 9; // of one that sits with another

const tags: Record<Handle, string> = {
  start: "Start",
  goal: "Goal",
  air_start: "Air start",
  air_goal: "Air goal",
};

export function drawMarkers(frame: Frame, markers: Markers, active: Handle | null, editable: boolean): void {
  const all = spots(markers, (point) => place(frame, point));
  // Goals below starts, attached handles below what they are attached to.
  const order = [...all].sort((a, b) => Number(b.attached) - Number(a.attached) || Number(a.handle < b.handle));
  for (const spot of order) {
    if (spot.attached && !editable) continue;
    drawMarker(frame, spot, spot.handle === active);
  }
  for (const spot of all) {
    if (!spot.attached) drawTag(frame, tags[spot.handle], spot.at, isAbove(markers, spot.handle));
  }
}

// Names stand on the side that the way does not leave or come from.
function isAbove(markers: Markers, handle: Handle): boolean {
  const other: Record<Handle, Handle> = { start: "goal", goal: "start", air_start: "air_goal", air_goal: "air_start" };
  return cellOf(markers, handle)[1] < cellOf(markers, other[handle])[1];
}

function drawMarker(frame: Frame, { handle, at, attached }: Spot, active: boolean): void {
  const { context, theme } = frame;
  const air = isAir(handle);
  const size = attached ? smallRadius : radius;
  context.save();
  context.translate(at[0], at[1]);
  context.shadowColor = "#0006";
  context.shadowBlur = 5 * frame.pixelRatio;
  context.shadowOffsetY = 1.5 * frame.pixelRatio;
  context.fillStyle = theme.halo;
  disc(context, size + 2.2);
  context.shadowColor = "transparent";
  context.fillStyle = air ? theme.air : theme.ground;
  disc(context, size);
  if (active) {
    context.strokeStyle = theme.select;
    context.lineWidth = 2.5;
    context.beginPath();
    context.arc(0, 0, size + 6, 0, 2 * Math.PI);
    context.stroke();
  }
  context.fillStyle = air ? theme.onAir : theme.onGround;
  const goal = handle === "goal" || handle === "air_goal";
  const grow = (attached ? 0.62 : 0.92) * (goal && !(air && attached) ? 1 : 0.88);
  context.scale(grow, grow);
  if (air && attached) context.rotate(-Math.PI / 4);
  context.fill(air && attached ? glyphs.plane : goal ? glyphs.star : air ? glyphs.plane : glyphs.rover);
  context.restore();
}

function drawTag(frame: Frame, text: string, at: Point, above: boolean): void {
  const [x, y] = above ? [at[0] - 12, at[1] - radius - 11] : [at[0], at[1] + radius + 12]; // past an attached handle
  drawText(frame, text, [x, y], { font: "600 12px", align: "center", colour: frame.theme.ink });
}

export function disc(context: CanvasRenderingContext2D, size: number): void {
  context.beginPath();
  context.arc(0, 0, size, 0, 2 * Math.PI);
  context.fill();
}
