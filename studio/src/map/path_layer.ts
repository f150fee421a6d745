// Paths of a layer. They differ by width and dashes, not by colour alone.
import type { Agent, Point } from "../api/answers";
import { splitAt } from "../play/motion";
import { type Frame, inMapPoints } from "./frame";
import type { LayerName, Scene } from "./scene";
import type { Theme } from "./theme";

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

export class PathLayer {
  readonly #whole = new WeakMap<Agent, Path2D>();

  draw(frame: Frame, scene: Scene): void {
    inMapPoints(frame, (pixel) => {
      frame.context.lineJoin = "round";
      frame.context.lineCap = "round";
      scene.layers.forEach((layer, i) => {
        const played = i === scene.layers.length - 1 && scene.time !== null;
        // Ground below: where both run together, one sees both.
        for (const kind of ["ground", "air"] as const) {
          for (const agent of layer.plan.agents.filter((one) => one.kind === kind)) {
            const style = styles[layer.name][kind];
            if (!played) {
              stroke(frame, this.#pathOf(agent), style, pixel, 1);
              continue;
            }
            const { travelled, ahead } = splitAt(agent, scene.time!);
            stroke(frame, pathThrough(ahead), style, pixel, 0.3);
            stroke(frame, pathThrough(travelled), style, pixel, 1);
          }
        }
      });
    });
  }

  #pathOf(agent: Agent): Path2D {
    let path = this.#whole.get(agent);
    if (!path) {
      path = pathThrough(agent.path.map(([x, y]): Point => [x, y]));
      this.#whole.set(agent, path);
    }
    return path;
  }
}

function pathThrough(points: readonly Point[]): Path2D {
  const path = new Path2D();
  points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  return path;
}

function stroke(frame: Frame, path: Path2D, style: LineStyle, pixel: number, alpha: number): void {
  const { context, theme } = frame;
  context.globalAlpha = alpha;
  context.setLineDash(style.dash.map((length) => length * pixel));
  if (style.edge) {
    context.strokeStyle = style.edge(theme);
    context.lineWidth = (style.width + 2.4) * pixel;
    context.stroke(path);
  }
  context.strokeStyle = style.colour(theme);
  context.lineWidth = style.width * pixel;
  context.stroke(path);
  context.setLineDash([]);
  context.globalAlpha = 1;
}
