// Draws the markers.
import { type Agents, cellOf, type Handle, isPair, isSameHandle } from "../../domain/agents";
import type { Box, Point } from "../../domain/geometry";
import type { Scene } from "../../domain/scene";
import { positionAt } from "../../play/motion";
import { type Frame, place } from "../viewport/frame";
import { boxAround } from "./free_places";
import { glyphs } from "./glyphs";
import { drawLeader } from "./leader";
import { markerRadius as radius, smallRadius, type Spot } from "./marker_spots";
import { drawTeamMarkers } from "./team_markers";
import { drawText } from "./text";

const tags = { ground: { start: "Start", goal: "Goal" }, air: { start: "Air start", goal: "Air goal" } };

export function drawMarkers(frame: Frame, scene: Scene, all: readonly Spot[], active: Handle | null): void {
  const agents = playing(frame, scene);
  const isCovered = ({ agent, place: [x, y] }: Spot) => {
    const at = agents.get(agent.id);
    return at !== undefined && Math.hypot(at[0] - x, at[1] - y) < covers;
  };
  const drawn = all.filter((spot) => isSameHandle(spot.handle, active) || !isCovered(spot));
  if (isPair(scene.agents)) drawPair(frame, scene, drawn, active);
  else drawTeamMarkers(frame, scene, drawn, active);
}

const covers = 44; // pixels around an agent, its name included: in playback it stands for its marker there

// Where agents are drawn in playback, by id.
function playing(frame: Frame, { layers, time }: Scene): ReadonlyMap<string, Point> {
  const agents = (time !== null && layers.at(-1)?.plan.agents) || [];
  return new Map(
    agents.flatMap((agent) => {
      const now = positionAt(agent, time!);
      return now ? [[agent.id, place(frame, [now.x, now.y])] as const] : [];
    }),
  );
}

function drawPair(frame: Frame, { agents, editable }: Scene, all: readonly Spot[], active: Handle | null): void {
  // Goals below starts, attached handles below what they are attached to.
  const isStart = ({ handle }: Spot) => Number(handle.end === "start");
  const order = [...all].sort((a, b) => Number(b.attached) - Number(a.attached) || isStart(a) - isStart(b));
  for (const spot of order) {
    if (spot.attached && !editable) continue;
    if (!spot.attached) drawLeader(frame, spot.place, spot.at, frame.theme[spot.agent.kind]);
    drawMarker(frame, spot, isSameHandle(spot.handle, active));
  }
  for (const spot of all) {
    const tag = tags[spot.agent.kind][spot.handle.end];
    if (!spot.attached) drawTag(frame, tag, spot.at, isAbove(agents, spot.handle));
  }
}

// Names stand on the side that the way does not leave or come from.
function isAbove(agents: Agents, { agent, end }: Handle): boolean {
  const other = end === "start" ? "goal" : "start";
  return cellOf(agents, { agent, end })[1] < cellOf(agents, { agent, end: other })[1];
}

function drawMarker(frame: Frame, { handle, agent, at, attached }: Spot, active: boolean): void {
  const { context, theme } = frame;
  const air = agent.kind === "air";
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
  const goal = handle.end === "goal";
  const grow = (attached ? 0.62 : 0.92) * (goal && !(air && attached) ? 1 : 0.88);
  context.scale(grow, grow);
  if (air && attached) context.rotate(-Math.PI / 4);
  context.fill(air && attached ? glyphs.plane : goal ? glyphs.star : air ? glyphs.plane : glyphs.rover);
  context.restore();
}

function drawTag(frame: Frame, text: string, at: Point, above: boolean): void {
  drawText(frame, text, tagPlace(at, above), { font: "600 12px", align: "center", colour: frame.theme.ink });
}

function tagPlace([x, y]: Point, above: boolean): Point {
  return above ? [x - 12, y - radius - 11] : [x, y + radius + 12]; // past an attached handle
}

// What the names of a pair's markers cover.
export function tagBoxes(agents: Agents, all: readonly Spot[]): Box[] {
  if (!isPair(agents)) return [];
  const named = all.filter(({ attached }) => !attached);
  return named.map(({ at, agent, handle }) => boxAround(tagPlace(at, isAbove(agents, handle)), agent.kind === "air" ? 60 : 40, 16));
}

export function disc(context: CanvasRenderingContext2D, size: number): void {
  context.beginPath();
  context.arc(0, 0, size, 0, 2 * Math.PI);
  context.fill();
}
