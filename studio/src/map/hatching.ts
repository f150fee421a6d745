// Stripes to fill areas with, of the same width at every zoom; they stay where they are on the map.
export type Slope = "rising" | "falling";

export class Hatching {
  readonly #patterns = new Map<string, CanvasPattern>();

  // For drawing in map points: `pixel` is as much as one CSS pixel.
  of(
    context: CanvasRenderingContext2D,
    ink: string,
    paper: string | null,
    slope: Slope,
    pixelRatio: number,
    pixel: number,
  ): CanvasPattern {
    const key = `${ink} ${paper} ${slope} ${pixelRatio}`;
    let pattern = this.#patterns.get(key);
    if (!pattern) {
      pattern = context.createPattern(stripes(ink, paper, slope, pixelRatio), "repeat")!;
      this.#patterns.set(key, pattern);
    }
    pattern.setTransform(new DOMMatrix().scale(pixel / pixelRatio));
    return pattern;
  }
}

function stripes(ink: string, paper: string | null, slope: Slope, pixelRatio: number): HTMLCanvasElement {
  const side = Math.round(7 * pixelRatio);
  const canvas = document.createElement("canvas");
  canvas.width = side;
  canvas.height = side;
  const context = canvas.getContext("2d")!;
  if (paper !== null) {
    context.fillStyle = paper;
    context.fillRect(0, 0, side, side);
  }
  context.strokeStyle = ink;
  context.lineWidth = 1.7 * pixelRatio;
  if (slope === "falling") context.setTransform(-1, 0, 0, 1, side, 0);
  for (const shift of [-side, 0, side]) {
    context.moveTo(shift - 2, side + 2);
    context.lineTo(shift + side + 2, -2);
  }
  context.stroke();
  return canvas;
}
