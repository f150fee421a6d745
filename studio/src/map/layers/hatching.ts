// Stripes to fill areas with, clear between them, of the same width at every zoom; they stay where they are on the map.
export type Slope = "rising" | "falling";

export class Hatching {
  readonly #patterns = new Map<string, CanvasPattern>();

  // For drawing in map points: `pixel` is as much as one CSS pixel.
  of(
    context: CanvasRenderingContext2D,
    ink: string,
    slope: Slope,
    pixelRatio: number,
    pixel: number,
  ): CanvasPattern {
    const key = `${ink} ${slope} ${pixelRatio}`;
    let pattern = this.#patterns.get(key);
    if (!pattern) {
      pattern = context.createPattern(stripes(ink, slope, pixelRatio), "repeat")!;
      this.#patterns.set(key, pattern);
    }
    pattern.setTransform(new DOMMatrix().scale(pixel / pixelRatio));
    return pattern;
  }
}

function stripes(ink: string, slope: Slope, pixelRatio: number): HTMLCanvasElement {
  const side = Math.round(7 * pixelRatio);
  const canvas = document.createElement("canvas");
  canvas.width = side;
  canvas.height = side;
  const context = canvas.getContext("2d")!;
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
