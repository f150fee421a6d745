// Agents where they are at a time of the plan.
import type { AgentLook } from "../../domain/agents";
import type { Point } from "../../domain/geometry";
import type { Agent, Plan } from "../../domain/plan";
import type { Layer, Scene } from "../../domain/scene";
import { type Position, positionAt } from "../../play/motion";
import { type Frame, place, typeface } from "../viewport/frame";
import { colourOf } from "../viewport/theme";
import { beside, boxAround, Boxes, middleOf } from "./free_places";
import { glyphs } from "./glyphs";
import { disc } from "./marker_layer";
import { mostNamed, shortened, widthOfName } from "./team_markers";
import { drawText } from "./text";

interface Ring {
  radius: number;
  width: number;
  colour: string;
  faded: number; // 0 to 1: gone
}

export function drawFadingRing({ context }: Frame, [x, y]: Point, ring: Ring): void {
  context.globalAlpha = 1 - ring.faded;
  context.strokeStyle = ring.colour;
  context.lineWidth = ring.width;
  context.beginPath();
  context.arc(x, y, ring.radius, 0, 2 * Math.PI);
  context.stroke();
  context.globalAlpha = 1;
}

const leastRadius = 6; // pixels, at which a vehicle can be seen

// Vehicles are discs of their own size, unless they would be too small to see. Aircraft fly above them, and no name
// stands on another or on an agent.
export function drawTeam(frame: Frame, scene: Scene, plan: Plan, time: number): void {
  const isNamed = plan.agents.length <= mostNamed;
  const inOrder = (["ground", "air"] as const).flatMap((kind) => plan.agents.filter((agent) => agent.kind === kind));
  const drawn = inOrder.flatMap(({ id, kind, path }): Drawn[] => {
    const now = positionAt({ path }, time);
    const look = scene.looks.get(id);
    if (!now || !look) return [];
    const least = isNamed ? leastRadius + 3 : leastRadius;
    const radius = kind === "air" ? planeRadius : Math.max(radiusOf(scene, id) * frame.camera.scale, least);
    return [{ at: place(frame, [now.x, now.y]), now, look, radius, name: isNamed ? shortened(id) : "" }];
  });
  for (const one of drawn) {
    if (one.look.kind === "ground") drawVehicle(frame, one);
    else drawAircraft(frame, one);
  }
  drawNames(frame, drawn);
}

const reach = 20; // pixels

// Who is at a place on the map.
export function agentsAt(frame: Pick<Frame, "camera" | "view">, plan: Plan, time: number, [x, y]: Point): string[] {
  const found = plan.agents.filter(({ kind, path }) => {
    const now = positionAt({ path }, time);
    if (!now) return false;
    const at = place(frame, [now.x, now.y]);
    return [at, kind === "air" ? lifted(at) : at].some(([ax, ay]) => Math.hypot(ax - x, ay - y) <= reach);
  });
  return found.map(({ id }) => id);
}

interface Drawn {
  at: Point;
  now: Position;
  look: AgentLook;
  radius: number; // pixels
  name: string; // empty: there is no room for names
}

const nameSize = 15; // pixels, how tall

function drawNames(frame: Frame, drawn: readonly Drawn[]): void {
  const taken = new Boxes();
  for (const { at, radius, look } of drawn) taken.add(boxAround(look.kind === "air" ? lifted(at) : at, 2 * radius, 2 * radius));
  for (const { at, name, radius, look } of drawn) {
    if (name === "" || isWithin(name, radius, look)) continue;
    const width = widthOfName(frame.context, name);
    const usual: Point = look.kind === "air" ? [at[0], at[1] + nameSize] : [at[0], at[1] - radius - nameSize / 2 - 2];
    const box = taken.take([usual, ...beside(at, width, nameSize)], width, nameSize);
    const middle = box ? middleOf(box) : usual;
    drawText(frame, name, middle, { font: "600 11px", align: "center", colour: frame.theme.ink });
  }
}

// Whether a vehicle is large enough for its name, or the name a number.
function isWithin(name: string, radius: number, { kind }: AgentLook): boolean {
  return kind === "ground" && (name.length <= 2 || name.length * 7 < 2 * radius);
}

function radiusOf({ agents }: Scene, id: string): number {
  const agent = agents.find((one) => one.id === id);
  return agent?.kind === "ground" ? agent.radius : 0;
}

function drawVehicle(frame: Frame, { at, now, look, radius, name }: Drawn): void {
  const { context, theme } = frame;
  const [x, y] = at;
  const colour = colourOf(look, theme);
  if (now.state === "waiting") drawFadingRing(frame, at, { ...pulse(frame, radius), colour });
  context.fillStyle = theme.halo;
  context.beginPath();
  context.arc(x, y, radius + 2, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = colour;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
  if (name === "" || !isWithin(name, radius, look)) return;
  context.fillStyle = theme.onVehicle;
  context.font = `700 11px ${typeface}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(name, x, y + 0.5);
}

function drawAircraft(frame: Frame, { at, now, look }: Drawn): void {
  const colour = colourOf(look, frame.theme);
  if (now.state === "waiting") drawFadingRing(frame, at, { ...pulse(frame, 16), colour: frame.theme.removed });
  drawPlane(frame, at, now.heading, colour);
}

// A ring that grows and fades, again and again.
function pulse(frame: Frame, radius: number): Omit<Ring, "colour"> {
  const phase = frame.still ? 0.4 : (frame.now % 1100) / 1100;
  return { radius: radius + 14 * phase, width: 3, faded: phase };
}

export function drawPair(frame: Frame, plan: Plan, time: number): void {
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
export function drawGhost(frame: Frame, layer: Layer, ground: Agent, time: number): void {
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
  drawFadingRing(frame, at, { ...pulse(frame, 16), colour: kind === "ground" ? frame.theme.ground : frame.theme.removed });
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

const planeRadius = 19; // pixels

// It flies: drawn a little above the place where its shadow is.
function lifted([x, y]: Point): Point {
  return [x, y - 12];
}

function drawPlane(frame: Frame, at: Point, heading: number, colour = frame.theme.air): void {
  const { context, theme } = frame;
  const silhouette = ([x, y]: Point, grow: number): void => {
    context.save();
    context.translate(x, y);
    context.rotate(heading);
    context.scale(grow, grow);
  };
  silhouette(at, 1.25);
  context.fillStyle = "#0005";
  context.fill(glyphs.plane);
  context.restore();
  silhouette(lifted(at), 1.7);
  context.lineJoin = "round";
  context.lineWidth = 3.4;
  context.strokeStyle = theme.halo;
  context.stroke(glyphs.plane);
  context.lineWidth = 1.6;
  context.strokeStyle = theme.airEdge;
  context.stroke(glyphs.plane);
  context.fillStyle = colour;
  context.fill(glyphs.plane);
  context.restore();
}
