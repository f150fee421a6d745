// What stands out among the obstacles: removed ones, those with a mark, the one pointed at, the one selected.
import type { CellMap } from "../../domain/cell_map";
import type { Mark } from "../../domain/mission";
import type { Layer, Scene } from "../../domain/scene";
import { type Frame, inMapPoints, place } from "../viewport/frame";
import type { Theme } from "../viewport/theme";
import { glyphs } from "./glyphs";
import { Hatching } from "./hatching";
import { disc } from "./marker_layer";
import { Outlines } from "./outlines";

export class ObstacleLayer {
  readonly #hatching = new Hatching();
  #cells: CellMap | null = null;
  #outlines: Outlines | null = null;

  draw(frame: Frame, scene: Scene, fadeSpan: number): void {
    if (scene.cells !== this.#cells) {
      this.#cells = scene.cells;
      this.#outlines = new Outlines(scene.cells);
    }
    inMapPoints(frame, (pixel) => {
      frame.context.lineJoin = "round";
      for (const [obstacle, mark] of scene.marks) this.#drawMark(frame, obstacle, mark, pixel);
      scene.layers.forEach((layer, i) => {
        const time = i === scene.layers.length - 1 ? scene.time : null;
        this.#drawRemoved(frame, layer, scene.layers.slice(0, i), time, fadeSpan, pixel);
      });
      if (scene.selected !== null) this.#drawLine(frame, scene.selected, frame.theme.select, 3 * pixel, pixel);
      if (scene.highlighted !== null) {
        frame.context.globalAlpha = 0.25;
        frame.context.fillStyle = frame.theme.select;
        frame.context.fill(this.#outline(frame, scene.highlighted), "evenodd");
        frame.context.globalAlpha = 1;
        this.#drawLine(frame, scene.highlighted, frame.theme.select, 2 * pixel, pixel);
      }
    });
    for (const [obstacle, mark] of scene.marks) this.#drawSign(frame, obstacle, mark);
  }

  // Stripes, over a tint where no layer below has stripes of its own: then both are to be seen.
  #drawRemoved(frame: Frame, layer: Layer, below: Layer[], time: number | null, fadeSpan: number, pixel: number): void {
    const { context, theme, pixelRatio } = frame;
    const paper = layer.name === "paper";
    const ink = paper ? theme.paperGround : theme.removed;
    const stripes = this.#hatching.of(context, ink, paper ? "falling" : "rising", pixelRatio, pixel);
    for (const { obstacle, cleared_at } of layer.plan.removed) {
      const path = this.#outline(frame, obstacle);
      const gone = time === null ? 0 : Math.min(Math.max((time - cleared_at) / fadeSpan, 0), 1);
      const fill = (style: string | CanvasPattern, alpha: number): void => {
        context.globalAlpha = alpha;
        context.fillStyle = style;
        if (alpha > 0) context.fill(path, "evenodd");
      };
      fill(theme.paper, gone);
      if (!below.some(({ plan }) => plan.removed.some((other) => other.obstacle === obstacle))) {
        fill(paper ? theme.paperTint : theme.removedTint, 1 - gone);
      }
      fill(stripes, 1 - gone);
      context.globalAlpha = 1 - 0.5 * gone;
      context.strokeStyle = ink;
      context.lineWidth = 1.6 * pixel;
      if (gone > 0) context.setLineDash([3 * pixel, 3 * pixel]);
      context.stroke(path);
      context.setLineDash([]);
      context.globalAlpha = 1;
    }
  }

  #drawMark(frame: Frame, obstacle: number, mark: Mark, pixel: number): void {
    const { context, theme } = frame;
    const ink = inkOf(mark, theme);
    const path = this.#outline(frame, obstacle);
    // What is excluded is planned without: it is nearly gone.
    context.globalAlpha = mark === "exclude" ? 0.8 : 0.22;
    context.fillStyle = mark === "exclude" ? theme.paper : ink;
    context.fill(path, "evenodd");
    context.globalAlpha = 1;
    context.strokeStyle = ink;
    context.lineWidth = (mark === "exclude" ? 1.4 : 2.4) * pixel;
    if (mark !== "protect") context.setLineDash(mark === "force" ? [6 * pixel, 3 * pixel] : [3 * pixel, 3 * pixel]);
    context.stroke(path);
    context.setLineDash([]);
  }

  // So that marks differ by more than their colour.
  #drawSign(frame: Frame, obstacle: number, mark: Mark): void {
    const { context, theme } = frame;
    const middle = this.#outlines!.middleOf(obstacle);
    if (!middle) return;
    const [x, y] = place(frame, middle);
    context.save();
    context.translate(x, y);
    context.fillStyle = theme.card;
    disc(context, 10.5);
    context.strokeStyle = inkOf(mark, theme);
    context.lineWidth = 1.5;
    context.stroke();
    context.lineWidth = 1.7;
    context.lineJoin = "round";
    context.stroke(glyphs[mark]);
    context.restore();
  }

  #drawLine(frame: Frame, obstacle: number, colour: string, width: number, pixel: number): void {
    const { context, theme } = frame;
    const path = this.#outline(frame, obstacle);
    context.strokeStyle = theme.halo;
    context.lineWidth = width + 2 * pixel;
    context.stroke(path);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke(path);
  }

  #outline(frame: Frame, obstacle: number): Path2D {
    return this.#outlines!.of(obstacle, frame);
  }
}

function inkOf(mark: Mark, theme: Theme): string {
  return { protect: theme.protect, force: theme.removed, exclude: theme.exclude }[mark];
}
