// The stroke being drawn: of a wall, or of the eraser.
import type { CellMap } from "../../domain/cell_map";
import type { Point, Run } from "../../domain/geometry";
import { rubbleRadius } from "../../domain/rubble";
import { isBrush, type Scene } from "../../domain/scene";
import { type Frame, inMapPoints } from "../viewport/frame";
import { blocked, strokeRuns } from "./stroke";

export class Sketch {
  #points: Point[] = [];
  #radius = 0; // cells
  #pointer: Point | null = null; // pixels

  hover(at: Point | null): void {
    this.#pointer = at;
  }

  add(point: Point, scale: number): void {
    if (this.#points.length === 0) this.#radius = brush(scale);
    this.#points.push(point);
  }

  finish(tool: "wall" | "erase", cells: CellMap): Run[] {
    const runs = strokeRuns(this.#points, this.#radius, cells);
    this.drop();
    return tool === "wall" ? runs : blocked(runs, cells);
  }

  drop(): void {
    this.#points = [];
  }

  // What would fall where the pointer is.
  #drawRubble({ context, camera, theme }: Frame, { cells }: Scene): void {
    if (!this.#pointer) return;
    context.beginPath();
    context.arc(...this.#pointer, (rubbleRadius(cells) + 0.5) * camera.scale, 0, 2 * Math.PI);
    context.setLineDash([4, 3]);
    context.strokeStyle = theme.halo;
    context.lineWidth = 4;
    context.stroke();
    context.strokeStyle = theme.ink;
    context.lineWidth = 2;
    context.stroke();
    context.setLineDash([]);
  }

  draw(frame: Frame, scene: Scene): void {
    if (!isBrush(scene.tool)) return;
    if (scene.tool === "rubble") return this.#drawRubble(frame, scene);
    const { context, theme } = frame;
    const colour = scene.tool === "wall" ? theme.obstacles.fixed.edge : theme.removed;
    if (this.#points.length > 0) {
      inMapPoints(frame, () => {
        context.beginPath();
        this.#points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
        if (this.#points.length === 1) context.lineTo(...this.#points[0]!);
        context.lineJoin = "round";
        context.lineCap = "round";
        context.lineWidth = 2 * this.#radius;
        context.globalAlpha = 0.7;
        context.strokeStyle = colour;
        context.stroke();
        context.globalAlpha = 1;
      });
    } else if (this.#pointer) {
      context.beginPath();
      context.arc(...this.#pointer, brush(frame.camera.scale) * frame.camera.scale, 0, 2 * Math.PI);
      context.strokeStyle = theme.ink;
      context.lineWidth = 1.5;
      context.stroke();
    }
  }
}

// So many cells that strokes hold together, and so many that one sees what one draws.
function brush(scale: number): number {
  return Math.max(1.2, 4 / scale);
}
