// The markers of a team: starts are filled, goals are rings, and names stand in them, where there is room for them.
import { type Handle, isSameHandle } from "../../domain/agents";
import { type Box, grown, type Point } from "../../domain/geometry";
import { shortenedName } from "../../domain/plain_name";
import type { Scene } from "../../domain/scene";
import { type Frame, typeface } from "../viewport/frame";
import { colourOf } from "../viewport/theme";
import { drawLeader } from "./leader";
import { drawPlaceBadge } from "./place_badges";
import { dotRadius, halo, nameHeight, type Spot } from "./marker_spots";

const font = `700 12px ${typeface}`;
const longest = 8; // letters of a name

export const mostNamed = 30; // agents whose names there is room for where they move

// In playback they are faint: the agents themselves are to be seen.
export function drawTeamMarkers(frame: Frame, scene: Scene, all: readonly Spot[], active: Handle | null): void {
  const { context } = frame;
  const isFirst = ({ handle }: Spot) => isSameHandle(handle, active) || handle.agent === scene.chosen;
  const seen = all.filter(({ at }) => isSeen(frame, at));
  const plays = scene.time !== null;
  const isNamed = ({ named }: Spot) => named && !(plays && scene.agents.length > mostNamed);
  const colour = ({ agent }: Spot) => colourOf(scene.looks.get(agent.id)!, frame.theme);
  if (plays) context.globalAlpha = 0.45;
  for (const spot of seen) drawLeader(frame, spot.place, spot.at, colour(spot));
  for (const spot of seen) {
    const place = isNamed(spot) ? spot.place : spot.at;
    const isUnder = isNamed(spot) && Math.hypot(spot.at[0] - place[0], spot.at[1] - place[1]) < 1;
    if (!isUnder) drawDot(frame, place, colour(spot), spot.handle.end === "goal");
  }
  // Those that matter on top.
  for (const spot of [...seen].sort((a, b) => Number(isFirst(a)) - Number(isFirst(b)))) {
    if (isNamed(spot)) drawPill(frame, grown(spot.box, -halo), spot, colour(spot));
    if (isFirst(spot)) drawRing(frame, grown(spot.box, -halo));
    drawPlaceBadge(frame, scene, spot);
  }
  context.globalAlpha = 1;
}

const widths = new Map<string, number>();

// Of the marker with this name in it.
export function widthOfName(context: CanvasRenderingContext2D, id: string): number {
  const known = widths.get(id);
  if (known !== undefined) return known;
  context.font = font;
  const width = Math.max(nameHeight, context.measureText(shortened(id)).width + 10);
  widths.set(id, width);
  return width;
}

// Who is meant, in playback and in lists: the name as far as there is room for it.
export function shortened(id: string): string {
  return shortenedName(id, longest);
}

function isSeen({ view }: Frame, [x, y]: Point): boolean {
  return x > -60 && y > -30 && x < view.width + 60 && y < view.height + 30;
}

function drawPill({ context, theme }: Frame, box: Box, { agent, handle }: Spot, colour: string): void {
  const [isGoal, flies] = [handle.end === "goal", agent.kind === "air"];
  const [width, tall] = [box.right - box.left, box.bottom - box.top];
  const pill = (grow: number) => {
    context.beginPath();
    context.roundRect(box.left - grow, box.top - grow, width + 2 * grow, tall + 2 * grow, flies ? 5 : tall / 2 + grow);
  };
  context.fillStyle = theme.halo;
  pill(halo);
  context.fill();
  context.fillStyle = isGoal ? theme.card : colour;
  pill(0);
  context.fill();
  context.lineWidth = 2.5;
  context.strokeStyle = flies ? theme.airEdge : colour;
  if (isGoal || flies) {
    pill(-1);
    context.stroke();
  }
  if (isGoal && flies) {
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.stroke();
  }
  context.fillStyle = isGoal ? theme.ink : flies ? theme.onAir : theme.onVehicle;
  context.font = font;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(shortened(agent.id), (box.left + box.right) / 2, (box.top + box.bottom) / 2 + 0.5);
}

function drawDot({ context, theme }: Frame, [x, y]: Point, colour: string, isGoal: boolean): void {
  context.beginPath();
  context.arc(x, y, dotRadius, 0, 2 * Math.PI);
  context.lineWidth = 4.5;
  context.strokeStyle = theme.halo;
  context.stroke();
  context.fillStyle = isGoal ? theme.card : colour;
  context.fill();
  context.lineWidth = 2.5;
  context.strokeStyle = colour;
  context.stroke();
}

function drawRing({ context, theme }: Frame, { left, top, right, bottom }: Box): void {
  context.beginPath();
  context.roundRect(left - 4, top - 4, right - left + 8, bottom - top + 8, (bottom - top) / 2 + 4);
  context.strokeStyle = theme.select;
  context.lineWidth = 2.5;
  context.stroke();
}
