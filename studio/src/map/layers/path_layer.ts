// Paths of a layer. They differ by width and dashes, not by colour alone.
import { type Box, grown, type Point } from "../../domain/geometry";
import type { LayerName } from "../../domain/mission";
import type { Agent } from "../../domain/plan";
import type { Scene } from "../../domain/scene";
import { splitAt } from "../../play/motion";
import { visibleBox } from "../viewport/camera";
import { type Frame, inMapPoints } from "../viewport/frame";
import type { Theme } from "../viewport/theme";
import { clipped, lengthOf } from "./clip_line";

interface LineStyle {
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

export const faint = 0.35; // of what is out of date

export function drawPaths(frame: Frame, scene: Scene): void {
  inMapPoints(frame, (pixel) => {
    frame.context.lineJoin = "round";
    frame.context.lineCap = "round";
    const seen = grown(visibleBox(frame.camera, frame.view), 20 * pixel);
    scene.layers.forEach((layer, i) => {
      const time = i === scene.layers.length - 1 ? scene.time : null;
      // Ground below: where both run together, one sees both.
      for (const kind of ["ground", "air"] as const) {
        const stroke = stroker(frame, styles[layer.name][kind], seen, pixel);
        for (const agent of layer.plan.agents.filter((one) => one.kind === kind)) {
          const { travelled, ahead } = splitAt(agent, time ?? Infinity);
          const strength = scene.old ? faint : 1;
          if (time !== null) stroke(ahead, lengthOf(travelled), 0.3 * strength);
          stroke(travelled, 0, strength);
        }
      }
    });
  });
}

type Stroke = (line: Point[], offset: number, alpha: number) => void;

function stroker({ context, theme }: Frame, style: LineStyle, seen: Box, pixel: number): Stroke {
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
