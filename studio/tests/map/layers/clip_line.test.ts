import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { clipped, lengthOf } from "../../../src/map/layers/clip_line";
import { draws } from "../../domain/picture";

const box = { left: 0, top: 0, right: 10, bottom: 10 };

describe("a line cut to the view", () => {
  it("is what it was where all of it is seen", () => {
    const line: Point[] = [[1, 1], [5, 5], [5, 5], [9, 2]];
    expect(clipped(line, box)).toEqual([{ points: line, offset: 0 }]);
  });

  it("has a piece for each time it comes in, and knows how far it has come", () => {
    expect(clipped([[-5, 5], [15, 5], [15, 8], [-5, 8]], box)).toEqual([
      { points: [[0, 5], [10, 5]], offset: 5 },
      { points: [[10, 8], [0, 8]], offset: 28 },
    ]);
    expect(clipped([[-5, -1], [20, -1], [20, 20]], box)).toEqual([]);
    expect(clipped([[3, 3]], box)).toEqual([]);
  });

  it("is seen at every point that lies in the view, and nowhere else", () => {
    const draw = draws(21);
    for (let k = 0; k < 100; ++k) {
      const line = Array.from({ length: 6 }, (): Point => [40 * draw() - 15, 40 * draw() - 15]);
      const pieces = clipped(line, box);
      let within = 0;
      const steps = 4000;
      for (let i = 1; i < line.length; ++i) {
        const [[ax, ay], [bx, by]] = [line[i - 1]!, line[i]!];
        for (let j = 0; j < steps; ++j) {
          const [x, y] = [ax + ((bx - ax) * (j + 0.5)) / steps, ay + ((by - ay) * (j + 0.5)) / steps];
          if (x >= 0 && x <= 10 && y >= 0 && y <= 10) within += Math.hypot(bx - ax, by - ay) / steps;
        }
      }
      expect(pieces.reduce((sum, { points }) => sum + lengthOf(points), 0)).toBeCloseTo(within, 0);
      for (const [x, y] of pieces.flatMap(({ points }) => points)) {
        expect(Math.min(x, y, 10 - x, 10 - y)).toBeGreaterThan(-1e-9);
      }
    }
  });
});
