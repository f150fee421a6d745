// Paths of a layer. They differ by width and dashes, not by colour alone.
import type { AgentLook } from "../../domain/agents";
import { type Box, grown, type Point } from "../../domain/geometry";
import type { LayerName } from "../../domain/mission";
import type { Agent, Plan } from "../../domain/plan";
import type { Scene } from "../../domain/scene";
import { arrival, duration, splitAt } from "../../play/motion";
import { visibleBox } from "../viewport/camera";
import { type Frame, inMapPoints } from "../viewport/frame";
import { colourOf, type Theme } from "../viewport/theme";
import { clipped, lengthOf } from "./clip_line";
import { StillPicture } from "./still_picture";

export interface LineStyle {
  colour: (theme: Theme) => string;
  edge: ((theme: Theme) => string) | null; // a line below, wider
  width: number; // pixels
  dash: number[];
}

const styles: Record<LayerName, Record<Agent["kind"], LineStyle>> = {
  before: {
    ground: { colour: (theme) => theme.ground, edge: (theme) => theme.halo, width: 2.4, dash: [8, 5] },
    air: { colour: (theme) => theme.airLine, edge: null, width: 1.8, dash: [0.1, 5] },
  },
  after: {
    ground: { colour: (theme) => theme.ground, edge: (theme) => theme.halo, width: 7, dash: [] },
    air: { colour: (theme) => theme.air, edge: (theme) => theme.airEdge, width: 3, dash: [12, 8] },
  },
  paper: {
    ground: { colour: (theme) => theme.paperGround, edge: (theme) => theme.halo, width: 4, dash: [14, 5, 2, 5] },
    air: { colour: (theme) => theme.paperAir, edge: null, width: 1.8, dash: [2, 5] },
  },
};

// Of a team: colours tell its agents apart, and once they have all been used, dashes. Aircraft are dashed anyhow.
function teamStyle(layer: LayerName, look: AgentLook): LineStyle {
  const colour = (theme: Theme) => colourOf(look, theme);
  const halo = (theme: Theme) => theme.halo;
  const edge = (theme: Theme) => theme.airEdge;
  if (layer === "before") {
    return look.kind === "air"
      ? { colour, edge, width: 1.4, dash: [0.1, 5] }
      : { colour, edge: null, width: 1.6, dash: [6, 5] };
  }
  if (look.kind === "air") return { colour, edge, width: 2.6, dash: [10, 7] };
  return { colour, edge: halo, width: 4.5, dash: [[], [14, 6], [2, 7]][look.round % 3]! };
}

export function lineStyle(layer: LayerName, kind: Agent["kind"], look: AgentLook | undefined): LineStyle {
  return look ? teamStyle(layer, look) : styles[layer][kind];
}

export const faint = 0.35; // of what is out of date

const crowd = 30; // agents from which on playback shows only the last part of the ways travelled
const tail = 0.04; // of the mission

export class PathLayer {
  readonly #picture = new StillPicture();

  draw(frame: Frame, scene: Scene): void {
    const top = scene.layers.at(-1);
    if (!top || scene.time === null || top.plan.agents.length <= crowd) return drawLayers(frame, scene);
    // Hundreds of ways would take longer than a frame: they are painted once, and copied.
    const plans = scene.layers.map((layer) => layer.plan);
    this.#picture.draw(frame, plans, (still) => drawLayers(still, { ...scene, time: null, old: false }));
    drawTails(frame, scene, top.plan, scene.time);
  }
}

function drawLayers(frame: Frame, scene: Scene): void {
  inMapPoints(frame, (pixel) => {
    const seen = begin(frame, pixel);
    scene.layers.forEach((layer, i) => {
      const time = i === scene.layers.length - 1 ? scene.time : null;
      // Ground below: where both run together, one sees both.
      for (const kind of ["ground", "air"] as const) {
        for (const agent of layer.plan.agents.filter((one) => one.kind === kind)) {
          const look = scene.looks.get(agent.id);
          const stroke = stroker(frame, lineStyle(layer.name, kind, look), seen, pixel);
          const { travelled, ahead } = splitAt(agent, time ?? Infinity);
          const strength = scene.old ? faint : 1;
          if (time !== null) stroke(ahead, lengthOf(travelled), 0.3 * strength);
          stroke(travelled, 0, strength);
        }
      }
    });
  });
}

function drawTails(frame: Frame, { looks, old }: Scene, plan: Plan, time: number): void {
  const since = time - tail * duration(plan);
  inMapPoints(frame, (pixel) => {
    const seen = begin(frame, pixel);
    for (const agent of plan.agents) {
      const look = looks.get(agent.id);
      if (!look || since >= arrival(agent)) continue;
      const before = splitAt(agent, since);
      const line = [before.ahead[0]!, ...splitAt(agent, time).travelled.slice(before.travelled.length - 1)];
      stroker(frame, { ...teamStyle("after", look), dash: [] }, seen, pixel)(line, 0, old ? faint : 1);
    }
  });
}

// What of the map is to be seen, and a little more.
export function begin({ context, camera, view }: Frame, pixel: number): Box {
  context.lineJoin = "round";
  context.lineCap = "round";
  return grown(visibleBox(camera, view), 20 * pixel);
}

export type Stroke = (line: Point[], offset: number, alpha: number) => void;

export function stroker({ context, theme }: Frame, style: LineStyle, seen: Box, pixel: number): Stroke {
  return (line, offset, alpha) => {
    context.globalAlpha = alpha;
    context.setLineDash(style.dash.map((length) => length * pixel));
    for (const piece of clipped(line, seen)) {
      context.lineDashOffset = offset + piece.offset;
      context.beginPath();
      for (const [x, y] of piece.points) context.lineTo(x, y);
      if (style.edge) {
        context.strokeStyle = style.edge(theme);
        context.lineWidth = (style.width + 2.4) * pixel;
        context.stroke();
      }
      context.strokeStyle = style.colour(theme);
      context.lineWidth = style.width * pixel;
      context.stroke();
    }
    context.setLineDash([]);
    context.lineDashOffset = 0;
    context.globalAlpha = 1;
  };
}
