import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { nearestFree } from "../../../src/map/interaction/snap";
import { draws, mapOf } from "../../domain/picture";

describe("the nearest free cell", () => {
  it("is the nearest", () => {
    const draw = draws(7);
    for (let seed = 1; seed <= 60; ++seed) {
      const map = mapOf(...Array.from({ length: 9 }, () => Array.from({ length: 14 }, () => (draw() < 0.1 ? "." : "a")).join("")));
      const point: Point = [18 * draw() - 2, 13 * draw() - 2];
      const [x, y] = nearestFree(map, point);
      let nearest = Infinity;
      for (let cy = 0; cy < map.height; ++cy) {
        for (let cx = 0; cx < map.width; ++cx) {
          if (map.at(cx, cy) === 0) nearest = Math.min(nearest, Math.hypot(cx - point[0], cy - point[1]));
        }
      }
      if (nearest === Infinity) continue;
      expect(map.at(x, y)).toBe(0);
      expect(Math.hypot(x - point[0], y - point[1])).toBeCloseTo(nearest);
    }
  });

  it("is the point's own where none is free", () => {
    expect(nearestFree(mapOf("aa", "aa"), [5, 0.2])).toEqual([1, 0]);
  });
});
