// What removals do for places: an arrow up on those that are reached sooner or only now, a cross on those that are not.
import type { Point } from "../../domain/geometry";
import type { PlaceState } from "../../domain/reach";
import type { Scene } from "../../domain/scene";
import type { Frame } from "../viewport/frame";
import type { Spot } from "./marker_spots";

const size = 7; // pixels
const arrow = "M0 4V-4M-3.2 -0.8L0 -4L3.2 -0.8";
const cross = "M-3 -3L3 3M3 -3L-3 3";
const shapes: Partial<Record<PlaceState, string>> = { sooner: arrow, "only now": arrow, "not reached": cross };

export function drawPlaceBadge(frame: Frame, { reach }: Scene, { agent, handle, box, named, place }: Spot): void {
  const state = reach && handle.end === reach.end ? reach.states.get(agent.id) : undefined;
  const shape = state && shapes[state];
  if (!shape) return;
  const [x, y]: Point = named ? [box.right - 3, box.top + 3] : [place[0] + size, place[1] - size];
  const { context, theme } = frame;
  const isMissed = state === "not reached";
  context.save();
  context.translate(x, y);
  for (const [radius, colour] of [[size + 1.5, theme.halo], [size, isMissed ? theme.ink : theme.breach]] as const) {
    context.fillStyle = colour;
    context.beginPath();
    context.arc(0, 0, radius, 0, 2 * Math.PI);
    context.fill();
  }
  context.strokeStyle = isMissed ? theme.halo : theme.onBreach;
  context.lineWidth = 2;
  context.lineCap = "round";
  context.stroke(new Path2D(shape));
  context.restore();
}
