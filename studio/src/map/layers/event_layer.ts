// What happens where: breaches with their numbers, places where the ground agent enters, waits; and in playback the
// agents themselves.
import type { Point } from "../../domain/geometry";
import { cellOf, handles } from "../../domain/mission";
import type { Agent, Plan } from "../../domain/plan";
import type { Layer, Scene } from "../../domain/scene";
import { agentOf, breachOrder, positionAt, waits } from "../../play/motion";
import { type Frame, place, typeface } from "../viewport/frame";
import { spread } from "./badges";
import { glyphs } from "./glyphs";
import { disc } from "./marker_layer";
import { drawText } from "./text";

export function drawEvents(frame: Frame, scene: Scene, fadeSpan: number): void {
  scene.layers.forEach((layer, i) => {
    const top = i === scene.layers.length - 1;
    const time = top ? scene.time : null;
    const ground = agentOf(layer.plan, "ground");
    if (ground) {
      drawEntered(frame, layer, ground);
      for (const wait of waits(ground)) {
        const text = scene.formatTime?.(wait.until - wait.from) ?? "";
        if (top) drawWait(frame, place(frame, wait.at), text);
      }
    }
    const markers = handles.map((handle) => place(frame, cellOf(scene.markers, handle)));
    drawBreaches(frame, layer, markers, time, fadeSpan);
    if (time !== null) drawAgents(frame, layer.plan, time);
    else if (scene.time !== null && ground) drawGhost(frame, layer, ground, scene.time);
  });
}

function drawEntered(frame: Frame, layer: Layer, ground: Agent): void {
  const { context, theme } = frame;
  for (const removed of layer.plan.removed) {
    const at = removed.entered_at === null ? null : positionAt(ground, removed.entered_at);
    if (!at) continue;
    const [x, y] = place(frame, [at.x, at.y]);
    context.fillStyle = theme.halo;
    context.strokeStyle = layer.name === "paper" ? theme.paperGround : theme.ground;
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}

// Numbers are those of the table: the order of the breaches.
function drawBreaches(
  frame: Frame,
  layer: Layer,
  markers: readonly Point[],
  time: number | null,
  fadeSpan: number,
): void {
  const { context, theme } = frame;
  const order = breachOrder(layer.plan);
  const points = order.map(({ at }) => place(frame, at));
  const places = spread(points, markers, 28);
  order.forEach((removed, i) => {
    const [px, py] = points[i]!;
    const [x, y] = places[i]!;
    const since = time === null ? -1 : time - removed.cleared_at;
    if (since >= 0 && since < fadeSpan) drawFlash(frame, [px, py], since / fadeSpan);
    context.save();
    if (x !== px || y !== py) {
      context.strokeStyle = theme.breach;
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(px, py);
      context.lineTo(x, y);
      context.stroke();
    }
    context.translate(x, y);
    const colour = layer.name === "paper" ? theme.paperGround : theme.breach;
    context.fillStyle = theme.halo;
    disc(context, 12.5);
    context.fillStyle = since >= 0 ? theme.card : colour; // hollow once it is done
    disc(context, 11);
    context.strokeStyle = colour;
    context.lineWidth = 2;
    if (since >= 0) context.stroke();
    context.fillStyle = since >= 0 ? colour : theme.onBreach;
    context.font = `700 13px ${typeface}`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(String(i + 1), 0, 0.5);
    context.restore();
  });
}

function drawFlash(frame: Frame, at: Point, share: number): void {
  const grown = frame.still ? 0.5 : share;
  drawFadingRing(frame, at, { radius: 12 + 34 * grown, width: 5 - 4 * grown, colour: frame.theme.removed, faded: share });
}

interface Ring {
  radius: number;
  width: number;
  colour: string;
  faded: number; // 0 to 1: gone
}

function drawFadingRing({ context }: Frame, [x, y]: Point, ring: Ring): void {
  context.globalAlpha = 1 - ring.faded;
  context.strokeStyle = ring.colour;
  context.lineWidth = ring.width;
  context.beginPath();
  context.arc(x, y, ring.radius, 0, 2 * Math.PI);
  context.stroke();
  context.globalAlpha = 1;
}

// A clock beside the place, with how long.
function drawWait(frame: Frame, [x, y]: Point, text: string): void {
  const { context, theme } = frame;
  context.save();
  context.translate(x, y);
  context.strokeStyle = theme.ground;
  context.fillStyle = theme.halo;
  context.lineWidth = 2.5;
  context.beginPath();
  context.arc(0, 0, 6, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.font = `600 12px ${typeface}`;
  const width = 28 + (text ? context.measureText(text).width + 5 : 0);
  context.translate(-14 - width, -11);
  context.fillStyle = theme.card;
  context.strokeStyle = theme.ground;
  context.lineWidth = 1.5;
  context.beginPath();
  context.roundRect(0, 0, width, 22, 11);
  context.fill();
  context.stroke();
  context.beginPath();
  context.arc(13, 11, 6.5, 0, 2 * Math.PI);
  context.moveTo(13, 7.2);
  context.lineTo(13, 11);
  context.lineTo(15.8, 12.8);
  context.stroke();
  context.fillStyle = theme.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, 24, 11.5);
  context.restore();
}

function drawAgents(frame: Frame, plan: Plan, time: number): void {
  for (const kind of ["ground", "air"] as const) {
    for (const agent of plan.agents.filter((one) => one.kind === kind)) {
      const now = positionAt(agent, time);
      if (!now) continue;
      const at = place(frame, [now.x, now.y]);
      if (now.state === "waiting") drawPulse(frame, at, kind);
      if (kind === "ground") drawRover(frame, at, now.heading);
      else drawPlane(frame, at, now.heading);
    }
  }
}

// Where the ground agent would be by now in another layer's plan.
function drawGhost(frame: Frame, layer: Layer, ground: Agent, time: number): void {
  const { context, theme } = frame;
  const now = positionAt(ground, time);
  if (!now) return;
  const [x, y] = place(frame, [now.x, now.y]);
  context.save();
  context.translate(x, y);
  context.fillStyle = theme.card;
  context.strokeStyle = layer.name === "paper" ? theme.paperGround : theme.ground;
  context.lineWidth = 2;
  context.setLineDash([3, 2.5]);
  disc(context, 9);
  context.stroke();
  context.setLineDash([]);
  drawText(frame, layer.name, [-14, 0], { font: "600 11.5px", align: "right", colour: context.strokeStyle });
  context.restore();
}

function drawPulse(frame: Frame, at: Point, kind: Agent["kind"]): void {
  const phase = frame.still ? 0.4 : (frame.now % 1100) / 1100;
  const colour = kind === "ground" ? frame.theme.ground : frame.theme.removed;
  drawFadingRing(frame, at, { radius: 16 + 14 * phase, width: 3, colour, faded: phase });
}

function drawRover(frame: Frame, [x, y]: Point, heading: number): void {
  const { context, theme } = frame;
  context.save();
  context.translate(x, y);
  context.fillStyle = theme.halo;
  disc(context, 15.5);
  context.fillStyle = theme.ground;
  disc(context, 13.5);
  context.rotate(heading);
  context.fillStyle = theme.onGround;
  context.fill(glyphs.rover);
  context.restore();
}

// It flies: drawn a little above the place where its shadow is.
function drawPlane(frame: Frame, [x, y]: Point, heading: number): void {
  const { context, theme } = frame;
  const silhouette = (lift: number, grow: number): void => {
    context.save();
    context.translate(x, y - lift);
    context.rotate(heading);
    context.scale(grow, grow);
  };
  silhouette(0, 1.25);
  context.fillStyle = "#0005";
  context.fill(glyphs.plane);
  context.restore();
  silhouette(12, 1.7);
  context.lineJoin = "round";
  context.lineWidth = 3.4;
  context.strokeStyle = theme.halo;
  context.stroke(glyphs.plane);
  context.lineWidth = 1.6;
  context.strokeStyle = theme.airEdge;
  context.stroke(glyphs.plane);
  context.fillStyle = theme.air;
  context.fill(glyphs.plane);
  context.restore();
}
