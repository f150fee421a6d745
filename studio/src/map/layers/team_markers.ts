// The markers of a team: starts are filled, goals are rings, and names stand in them, where there is room for them.
import { type Handle, isSameHandle } from "../../domain/agents";
import { type Box, overlap, type Point } from "../../domain/geometry";
import type { Scene } from "../../domain/scene";
import { type Frame, typeface } from "../viewport/frame";
import { colourOf } from "../viewport/theme";
import type { Spot } from "./marker_spots";

const height = 20;
const dot = 5; // radius of a marker without a name
const longest = 8; // letters of a name

export const mostNamed = 30; // agents whose names there is room for where they move

// In playback they are faint: the agents themselves are to be seen.
export function drawTeamMarkers(frame: Frame, scene: Scene, all: readonly Spot[], active: Handle | null): void {
  const { context } = frame;
  context.font = `700 12px ${typeface}`;
  const isFirst = ({ handle }: Spot) => isSameHandle(handle, active) || handle.agent === scene.chosen;
  const seen = all.filter(({ at }) => isSeen(frame, at)).sort((a, b) => Number(isFirst(b)) - Number(isFirst(a)));
  const plays = scene.time !== null;
  const boxes = plays && scene.agents.length > mostNamed ? [] : boxesOf(frame, seen);
  if (plays) context.globalAlpha = 0.45;
  // The first on top.
  for (let i = seen.length - 1; i >= 0; --i) {
    const { agent, at } = seen[i]!;
    const box = boxes[i] ?? null;
    const colour = colourOf(scene.looks.get(agent.id)!, frame.theme);
    const isMoved = box === null || Math.abs((box.top + box.bottom) / 2 - at[1]) > 1;
    if (isMoved) drawDot(frame, at, colour, seen[i]!.handle.end === "goal");
    if (box) drawPill(frame, box, seen[i]!, colour);
    if (isFirst(seen[i]!)) drawRing(frame, box ?? around(at, 2 * dot, 2 * dot));
  }
  context.globalAlpha = 1;
}

function boxesOf({ context }: Frame, seen: readonly Spot[]): (Box | null)[] {
  const width = (id: string) => Math.max(height, context.measureText(shortened(id)).width + 10);
  return placed(seen.map(({ at, agent, named }) => ({ at, width: named ? width(agent.id) : 0 })));
}

// Who is meant, in playback and in lists: the name as far as there is room for it.
export function shortened(id: string): string {
  return id.length > longest ? `${id.slice(0, longest - 1)}…` : id;
}


interface Wanted {
  at: Point;
  width: number; // 0: none
}

// Boxes that do not cover each other, each at its place or just above or below; null where there is no room.
export function placed(wanted: readonly Wanted[]): (Box | null)[] {
  const cells = new Map<string, Box[]>(); // boxes by the squares they are in: cost must not grow with all pairs
  const near = (box: Box): Box[] => squares(box).flatMap((key) => cells.get(key) ?? []);
  return wanted.map(({ at: [x, y], width }) => {
    if (width === 0) return null;
    const tried = [0, -height - 1, height + 1].map((dy) => around([x, y + dy], width, height));
    const box = tried.find((one) => !near(one).some((other) => overlap(one, other))) ?? null;
    if (box) for (const key of squares(box)) cells.set(key, [...(cells.get(key) ?? []), box]);
    return box;
  });
}

const side = 64;

function squares({ left, top, right, bottom }: Box): string[] {
  const keys: string[] = [];
  for (let y = Math.floor(top / side); y <= Math.floor(bottom / side); ++y) {
    for (let x = Math.floor(left / side); x <= Math.floor(right / side); ++x) keys.push(`${x},${y}`);
  }
  return keys;
}

function around([x, y]: Point, width: number, tall: number): Box {
  return { left: x - width / 2, top: y - tall / 2, right: x + width / 2, bottom: y + tall / 2 };
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
  pill(2);
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
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(shortened(agent.id), (box.left + box.right) / 2, (box.top + box.bottom) / 2 + 0.5);
}

function drawDot({ context, theme }: Frame, [x, y]: Point, colour: string, isGoal: boolean): void {
  context.beginPath();
  context.arc(x, y, dot, 0, 2 * Math.PI);
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
