// Where the figures of the curve stand: over their points, or beside where the line is steep; those without room are left
// out. Pixels.
import { type Box, overlap, type Point, type Size } from "../domain/geometry";

export interface FigureAt {
  at: Point; // the point of the curve
  text: string;
  bold: boolean;
}

const height = 13;
const away = 15; // from a point to the middle of its figure
const digit = { plain: 7, bold: 7.7 }; // wide, of the widest usual typeface; punctuation is narrower
const clear = 1.5; // between figures

// Middles, in the order of the figures; null: left out. Bold ones come first, then the ends, then from the left.
export function placeFigures(figures: readonly FigureAt[], line: readonly Point[], chart: Size): (Point | null)[] {
  const last = figures.length - 1;
  const rank = (i: number) => (figures[i]!.bold ? 0 : i === 0 || i === last ? 1 : 2);
  const order = figures.map((_, i) => i).sort((a, b) => rank(a) - rank(b) || a - b);
  const taken: Box[] = [];
  const places: (Point | null)[] = figures.map(() => null);
  for (const i of order) {
    const figure = figures[i]!;
    const boxes = tried(figure, chart);
    const isFree = (box: Box) => !taken.some((other) => overlap(box, other));
    const isClear = (box: Box) => isFree(box) && !line.some((to, k) => k > 0 && crosses(line[k - 1]!, to, box));
    const box = boxes.find(isClear) ?? (figure.bold ? boxes.find(isFree) : undefined);
    if (!box) continue;
    taken.push(box);
    places[i] = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
  }
  return places;
}

// Above, above to the right and to the left, below.
function tried({ at: [x, y], text, bold }: FigureAt, chart: Size): Box[] {
  const half = widthOf(text, bold) / 2 + clear;
  const most = Math.max(0, chart.width - half);
  const boxes = [[x, y - away], [x + 0.6 * half, y - away], [x - 0.6 * half, y - away], [x, y - away - 7], [x, y + away]];
  const all = boxes.map(([wanted, middle]) => {
    const inside = Math.min(Math.max(wanted!, half - outside), most + outside);
    return { left: inside - half, right: inside + half, top: middle! - height / 2, bottom: middle! + height / 2 };
  });
  return all.filter(({ bottom }) => bottom <= chart.height);
}

export function widthOf(text: string, bold: boolean): number {
  const narrow = text.replace(/[^:.\s]/g, "").length;
  return (text.length - 0.4 * narrow) * (bold ? digit.bold : digit.plain);
}

const outside = 8; // beside the curve there is a margin

// Whether a line from one point to another meets a box: cut at its sides, something is left (Liang and Barsky 1984).
function crosses([x, y]: Point, [u, v]: Point, { left, top, right, bottom }: Box): boolean {
  let [from, to] = [0, 1];
  for (const [step, room] of [[x - u, x - left], [u - x, right - x], [y - v, y - top], [v - y, bottom - y]] as const) {
    if (step === 0 && room < 0) return false;
    if (step < 0) from = Math.max(from, room / step);
    if (step > 0) to = Math.min(to, room / step);
  }
  return from <= to;
}
