import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { spread } from "../../../src/map/layers/badges";
import { draws } from "../../domain/picture";

const away = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

describe("badges", () => {
  it("stay where they are if they have room", () => {
    const points: Point[] = [[0, 0], [30, 0], [0, 30]];
    expect(spread(points, [[60, 60]], 25)).toEqual(points);
  });

  it("are moved apart, and away from what is fixed", () => {
    const places = spread([[0, 0], [3, 0], [100, 100], [100, 100]], [[0, 2]], 25);
    places.forEach((one, i) => {
      expect(away(one, [0, 2])).toBeGreaterThan(24);
      for (const other of places.slice(0, i)) expect(away(one, other)).toBeGreaterThan(24);
    });
  });

  it("are apart in most crowds, and never far from home", () => {
    const draw = draws(4);
    for (let k = 0; k < 20; ++k) {
      const points = Array.from({ length: 8 }, (): Point => [150 * draw(), 150 * draw()]);
      const places = spread(points, [], 25);
      places.forEach((one, i) => {
        expect(away(one, points[i]!)).toBeLessThan(50);
        for (const other of places.slice(0, i)) expect(away(one, other)).toBeGreaterThan(20);
      });
    }
  });
});
