// What of a mission is rehearsed: rubble, the way that was planned before, what is committed of the new one, and what
// went wrong. Ways differ by width, dashes and casing, not by colour alone.
import type { Point } from "../../domain/geometry";
import type { Agent } from "../../domain/plan";
import type { Rehearsed } from "../../domain/rehearsed";
import type { Scene } from "../../domain/scene";
import { duration, partOf, positionAt, splitAt } from "../../play/motion";
import { type Frame, inMapPoints, place } from "../viewport/frame";
import { Hatching } from "./hatching";
import { outline } from "./outline";
import { begin, lineStyle, type LineStyle, stroker } from "./path_layer";
import { drawText } from "./text";

const moment = 1e-6; // of time: less is none

export class RehearsalLayer {
  readonly #hatching = new Hatching();

  draw(frame: Frame, scene: Scene, rehearsed: Rehearsed): void {
    inMapPoints(frame, (pixel) => {
      this.#drawRubble(frame, rehearsed, pixel);
      drawWays(frame, scene, rehearsed, pixel);
    });
  }

  #drawRubble({ context, theme, pixelRatio }: Frame, { rubble }: Rehearsed, pixel: number): void {
    if (rubble.length === 0) return;
    const path = new Path2D();
    for (const loop of outline(rubble)) {
      loop.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
      path.closePath();
    }
    context.fillStyle = theme.obstacles.fixed.fill;
    context.fill(path, "evenodd");
    context.fillStyle = this.#hatching.of(context, theme.ink, "falling", pixelRatio, pixel);
    context.fill(path, "evenodd");
    context.strokeStyle = theme.ink;
    context.lineWidth = 1.6 * pixel;
    context.stroke(path);
  }
}

// Ground below: where both run together, one sees both.
function inOrder(agents: readonly Agent[]): Agent[] {
  return (["ground", "air"] as const).flatMap((kind) => agents.filter((agent) => agent.kind === kind));
}

function drawWays(frame: Frame, scene: Scene, rehearsed: Rehearsed, pixel: number): void {
  const { plan, before, now, committed } = rehearsed;
  const time = scene.time ?? duration(plan);
  const seen = begin(frame, pixel);
  const stroke = ({ id, kind }: Agent, change: (style: LineStyle) => Partial<LineStyle>) => {
    const style = lineStyle("after", kind, scene.looks.get(id));
    return stroker(frame, { ...style, ...change(style) }, seen, pixel);
  };
  for (const agent of inOrder(before.agents)) {
    const old = splitAt(agent, committed.get(agent.id) ?? now).ahead;
    const isThin = agent.kind === "air" && scene.looks.size === 0;
    stroke(agent, ({ width, colour }) => ({
      colour: isThin ? (theme) => theme.airLine : colour,
      edge: null,
      width: Math.max(1.6, 0.35 * width),
      dash: [1, 5],
    }))(old, 0, 0.7);
  }
  for (const agent of inOrder(plan.agents)) {
    const { travelled, ahead } = splitAt(agent, time);
    stroke(agent, ({ width }) => ({ width: 0.5 * width }))(travelled, 0, 0.5);
    const decides = committed.get(agent.id) ?? now;
    const base = decides > time + moment ? partOf(agent, Math.max(time, now), decides) : [];
    stroke(agent, ({ width }) => ({ colour: (theme) => theme.ink, edge: (theme) => theme.halo, width: width + 5, dash: [] }))(base, 0, 1);
    stroke(agent, () => ({}))(ahead, 0, 1);
  }
}

// Where agents decide, and what went wrong; over everything.
export function drawRehearsalSigns(frame: Frame, scene: Scene, rehearsed: Rehearsed): void {
  const { plan, now, committed, failed, lost } = rehearsed;
  const time = scene.time ?? duration(plan);
  for (const agent of plan.agents) {
    const decides = committed.get(agent.id);
    const at = decides !== undefined && decides > Math.max(time, now) + moment ? positionAt(agent, decides) : null;
    if (at) drawDiamond(frame, place(frame, [at.x, at.y]));
  }
  for (const one of failed) drawFailure(frame, place(frame, one.at), "failed");
  for (const one of lost) if (time >= one.time) drawFailure(frame, place(frame, one.at), "lost");
}

function drawDiamond({ context, theme }: Frame, [x, y]: Point): void {
  context.beginPath();
  context.moveTo(x, y - 8);
  context.lineTo(x + 8, y);
  context.lineTo(x, y + 8);
  context.lineTo(x - 8, y);
  context.closePath();
  context.lineJoin = "round";
  context.strokeStyle = theme.halo;
  context.lineWidth = 6;
  context.stroke();
  context.fillStyle = theme.card;
  context.fill();
  context.strokeStyle = theme.ink;
  context.lineWidth = 2.5;
  context.stroke();
}

function drawFailure(frame: Frame, [x, y]: Point, word: string): void {
  const { context, theme } = frame;
  context.save();
  context.lineCap = "round";
  for (const [colour, width] of [[theme.halo, 8], [theme.removed, 4]] as const) {
    context.beginPath();
    for (const side of [-1, 1]) {
      context.moveTo(x - 8 * side, y - 8);
      context.lineTo(x + 8 * side, y + 8);
    }
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
  }
  context.restore();
  drawText(frame, word, [x, y + 20], { font: "650 12px", align: "center", colour: theme.ink });
}
