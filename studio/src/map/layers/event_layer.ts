// What happens where: breaches with their numbers, places where the ground agent enters, waits; and in playback the
// agents themselves.
import { aircraftOf } from "../../domain/agents";
import type { Box, Point } from "../../domain/geometry";
import type { Agent, Plan, Removed } from "../../domain/plan";
import type { Layer, Scene } from "../../domain/scene";
import { agentOf, breachOrder, positionAt, waits } from "../../play/motion";
import { type Frame, place, typeface } from "../viewport/frame";
import { colourOf } from "../viewport/theme";
import { spread } from "./badges";
import { beside, boxAround, Boxes, middleOf, sideways } from "./free_places";
import { drawLeader } from "./leader";
import { disc, tagBoxes } from "./marker_layer";
import { keptClear, type Spot } from "./marker_spots";
import { drawFadingRing, drawGhost, drawPair, drawTeam } from "./playing_agents";
import { drawText } from "./text";

export function drawEvents(frame: Frame, scene: Scene, markers: readonly Spot[], fadeSpan: number): void {
  const isFew = scene.agents.length <= mostKeptClear;
  const clear = isFew ? keptClear(markers) : [];
  const taken = new Boxes();
  if (isFew) for (const { box } of markers) taken.add(box);
  scene.layers.forEach((layer, i) => {
    const top = i === scene.layers.length - 1;
    const time = top ? scene.time : null;
    const badges = breachBadges(frame, scene, layer, clear);
    for (const { at } of badges) taken.add(boxAround(at, 26, 26));
    if (scene.looks.size > 0) {
      if (top && time === null) drawTeamWaits(frame, scene, layer.plan, taken);
      drawBreaches(frame, scene, layer, badges, time, fadeSpan);
      if (time !== null) drawTeam(frame, scene, layer.plan, time);
    } else {
      drawPairEvents(frame, scene, layer, top ? taken : null);
      drawBreaches(frame, scene, layer, badges, time, fadeSpan);
      const ground = agentOf(layer.plan, "ground");
      if (time !== null) drawPair(frame, layer.plan, time);
      else if (scene.time !== null && ground) drawGhost(frame, layer, ground, scene.time);
    }
  });
}

// Where names can be written so that no marker and no number of a breach covers them.
export function roomBesideEvents(frame: Frame, scene: Scene, markers: readonly Spot[]): (box: Box) => boolean {
  const taken = new Boxes();
  if (scene.agents.length > mostBesideNames) return () => true;
  const clear = scene.agents.length <= mostKeptClear ? keptClear(markers) : [];
  for (const box of [...markers.map((marker) => marker.box), ...tagBoxes(scene.agents, markers)]) taken.add(box);
  for (const layer of scene.layers) {
    for (const { at } of breachBadges(frame, scene, layer, clear)) taken.add(boxAround(at, 26, 26));
  }
  return (box) => taken.isFree(box);
}

const mostBesideNames = 100; // agents: with more there would be no names left
const mostKeptClear = 20; // agents whose markers badges are kept off

function drawPairEvents(frame: Frame, scene: Scene, layer: Layer, taken: Boxes | null): void {
  const ground = agentOf(layer.plan, "ground");
  if (!ground) return;
  drawEntered(frame, layer, ground);
  for (const wait of waits(ground)) {
    const text = scene.formatTime?.(wait.until - wait.from) ?? "";
    if (taken) drawWait(frame, place(frame, wait.at), text, taken);
  }
}

const mostTimed = 8; // waits whose length there is room to say

function drawTeamWaits(frame: Frame, scene: Scene, plan: Plan, taken: Boxes): void {
  const all = plan.agents.flatMap((agent) => {
    const look = scene.looks.get(agent.id); // none of those who left the team since
    return look?.kind === "ground" ? waits(agent).map((wait) => ({ look, ...wait })) : [];
  });
  for (const { at } of all) taken.add(boxAround(place(frame, at), 14, 14));
  for (const { look, at, from, until } of all) {
    const colour = colourOf(look, frame.theme);
    if (all.length <= mostTimed) drawWait(frame, place(frame, at), scene.formatTime?.(until - from) ?? "", taken, colour);
    else drawStop(frame, place(frame, at), colour);
  }
}

function drawStop({ context, theme }: Frame, [x, y]: Point, colour: string): void {
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fillStyle = theme.halo;
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
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

interface Badge {
  removed: Removed;
  from: Point; // where it is opened
  at: Point;
}

// The breach whose badge, or whose place, is at a place on the map.
export function breachAt(frame: Pick<Frame, "camera" | "view">, scene: Scene, markers: readonly Spot[], [x, y]: Point): number | null {
  const top = scene.layers.at(-1);
  if (!top) return null;
  const clear = scene.agents.length <= mostKeptClear ? keptClear(markers) : [];
  const isNear = ([px, py]: Point) => Math.hypot(px - x, py - y) <= 14;
  const badge = breachBadges(frame, scene, top, clear).find(({ at, from }) => isNear(at) || isNear(from));
  return badge?.removed.obstacle ?? null;
}

function breachBadges(
  frame: Pick<Frame, "camera" | "view">,
  scene: Scene,
  layer: Layer,
  clear: readonly Point[],
): Badge[] {
  const order = breachOrder(layer.plan);
  const points = order.map(({ at }) => place(frame, at));
  const places = spread(points, clear, hasOpeners(scene) ? 38 : 28);
  return order.map((removed, i) => ({ removed, from: points[i]!, at: places[i]! }));
}

// Whether it has to be said who opens what.
function hasOpeners(scene: Scene): boolean {
  return scene.looks.size > 0 && aircraftOf(scene.agents).length > 1;
}

// Numbers are those of the table: the order of the breaches.
function drawBreaches(
  frame: Frame,
  scene: Scene,
  layer: Layer,
  badges: readonly Badge[],
  time: number | null,
  fadeSpan: number,
): void {
  const { context, theme } = frame;
  badges.forEach(({ removed, from, at }, i) => {
    const since = time === null ? -1 : time - removed.cleared_at;
    if (since >= 0 && since < fadeSpan) drawFlash(frame, from, since / fadeSpan);
    context.save();
    drawLeader(frame, from, at, theme.breach);
    context.translate(...at);
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
    if (hasOpeners(scene) && removed.by !== undefined) drawOpener(frame, scene, removed.by);
    context.restore();
  });
}

// Of several aircraft the one that opens it: a ring in its colour around the badge, and its name below.
function drawOpener(frame: Frame, scene: Scene, id: string): void {
  const look = scene.looks.get(id);
  if (!look) return;
  const { context, theme } = frame;
  for (const [width, colour] of [[5, theme.airEdge], [3, colourOf(look, theme)]] as const) {
    context.beginPath();
    context.arc(0, 0, 14.5, 0, 2 * Math.PI);
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke();
  }
  drawText(frame, id, [0, 24], { font: "600 11px", align: "center", colour: theme.ink });
}

function drawFlash(frame: Frame, at: Point, share: number): void {
  const grown = frame.still ? 0.5 : share;
  drawFadingRing(frame, at, { radius: 12 + 34 * grown, width: 5 - 4 * grown, colour: frame.theme.removed, faded: share });
}

// A clock beside the place, with how long.
function drawWait(frame: Frame, at: Point, text: string, taken: Boxes, colour = frame.theme.ground): void {
  const { context, theme } = frame;
  context.save();
  context.font = `600 12px ${typeface}`;
  const [width, height] = [28 + (text ? context.measureText(text).width + 5 : 0), 22];
  const box = taken.take(beside(at, width, height), width, height) ?? boxAround(sideways(at, width, -1, 0), width, height);
  drawLeader(frame, at, middleOf(box), colour);
  context.translate(...at);
  context.strokeStyle = colour;
  context.fillStyle = theme.halo;
  context.lineWidth = 2.5;
  context.beginPath();
  context.arc(0, 0, 6, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.translate(box.left - at[0], box.top - at[1]);
  context.fillStyle = theme.card;
  context.strokeStyle = colour;
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
