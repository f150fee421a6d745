// Which figures of the curve have room, and where.
import { describe, expect, it } from "vitest";
import { overlap, type Point } from "../../src/domain/geometry";
import { type FigureAt, placeFigures, widthOf } from "../../src/panel/front_labels";
import { draws } from "../domain/picture";

const width = 340;
const step = 40;

function curve(heights: readonly number[], texts: readonly string[], chosen = 2): FigureAt[] {
  return heights.map((y, i) => ({ at: [11 + i * step, y], text: texts[i]!, bold: i === chosen }));
}

function boxOf([x, y]: Point, { text, bold }: FigureAt) {
  const half = widthOf(text, bold) / 2;
  return { left: x - half, right: x + half, top: y - 6.5, bottom: y + 6.5 };
}

// Points along the line, a pixel or less apart.
function along(line: readonly Point[]): Point[] {
  return line.slice(1).flatMap(([u, v], i) => {
    const [x, y] = line[i]!;
    return Array.from({ length: 101 }, (_, k): Point => [x + ((u - x) * k) / 100, y + ((v - y) * k) / 100]);
  });
}

function expectClear(figures: readonly FigureAt[]): (Point | null)[] {
  const line = figures.map(({ at }) => at);
  const places = placeFigures(figures, line, { width, height: 92 });
  const boxes = figures.flatMap((figure, i) => (places[i] ? [boxOf(places[i]!, figure)] : []));
  boxes.forEach((one, i) => {
    for (const other of boxes.slice(0, i)) expect(overlap(one, other)).toBe(false);
    expect(one.left).toBeGreaterThan(-9);
    expect(one.right).toBeLessThan(width + 9);
    expect(one.bottom, "the numbers of removals").toBeLessThanOrEqual(92);
  });
  figures.forEach((figure, i) => {
    if (!places[i] || figure.bold) return;
    const box = boxOf(places[i]!, figure);
    expect(along(line).filter(([x, y]) => x > box.left && x < box.right && y > box.top && y < box.bottom)).toEqual([]);
  });
  return places;
}

describe("figures of the curve", () => {
  it("do not run into each other where times have hours", () => {
    const texts = ["1:17:39", "1:13:11", "1:10:56", "1:09:46", "1:09:25", "1:08:57", "1:08:35", "1:08:28", "1:08:22"];
    const places = expectClear(curve([26, 51, 63, 70, 72, 75, 77, 78, 79], texts));
    expect(places[0]).not.toBeNull();
    expect(places[2]).not.toBeNull();
    expect(places[8]).not.toBeNull();
    expect(places.filter((place) => place !== null).length).toBeGreaterThan(4);
  });

  it("are not crossed by a steep line", () => {
    const texts = ["15:31", "14:22", "14:20", "14:17", "14:14", "14:12", "14:09", "14:06", "14:05"];
    const places = expectClear(curve([26, 68, 69, 71, 73, 74, 76, 78, 79], texts));
    expect(places[1]).not.toBeNull();
  });

  it("stand over their points where there is room", () => {
    const figures = curve([26, 40, 50, 55, 60], ["9:10", "9:00", "8:50", "8:45", "8:40"], 4);
    expect(expectClear(figures)[4]).toEqual([171, 45]);
  });

  it("are clear of each other and of the line on any curve", () => {
    const draw = draws(3);
    for (let trial = 0; trial < 300; ++trial) {
      const count = 2 + Math.floor(7 * draw());
      const heights = Array.from({ length: count }, () => 26 + 56 * draw()).sort((a, b) => a - b);
      const texts = heights.map(() => "1:23:45.67".slice(0, 3 + Math.floor(7 * draw())));
      expectClear(curve(heights, texts, Math.floor(count * draw())));
    }
  });
});
