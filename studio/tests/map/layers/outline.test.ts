import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { outline } from "../../../src/map/layers/outline";
import { coarser } from "../../../src/map/layers/outlines";
import { mapOf, randomMap } from "../../domain/picture";

// Whether a point is inside of closed lines, by counting those to its right.
function inside(loops: Point[][], x: number, y: number): boolean {
  let crossed = 0;
  for (const loop of loops) {
    loop.forEach(([ax, ay], i) => {
      const [, by] = loop[(i + 1) % loop.length]!;
      if (ay > y !== by > y && ax > x) ++crossed;
    });
  }
  return crossed % 2 === 1;
}

describe("outlines", () => {
  it("go around a cell", () => {
    expect(outline([[2, 3, 1]])).toHaveLength(1);
    expect(new Set(outline([[2, 3, 1]])[0]!.map(String))).toEqual(new Set(["1.5,2.5", "2.5,2.5", "2.5,3.5", "1.5,3.5"]));
  });

  it("hold exactly their cells, turn at every corner, and touch themselves nowhere along an edge", () => {
    for (let seed = 1; seed <= 40; ++seed) {
      const map = randomMap(12, 9, seed);
      for (const { id } of map.obstacles) {
        const loops = outline(map.runsOf(id));
        for (let y = -1; y <= map.height; ++y) {
          for (let x = -1; x <= map.width; ++x) expect(inside(loops, x, y)).toBe(map.at(x, y) === id);
        }
        for (const loop of loops) {
          expect(loop.length).toBeGreaterThanOrEqual(4);
          loop.forEach(([x, y], i) => {
            const [nx, ny] = loop[(i + 1) % loop.length]!;
            const [mx, my] = loop[(i + 2) % loop.length]!;
            expect(x === nx).toBe(ny === my && nx !== mx);
            expect(y === ny).toBe(nx === mx && ny !== my);
          });
        }
      }
    }
  });

  it("keep cells apart that touch in a corner alone", () => {
    const map = mapOf("a..", ".a.", "..a");
    expect(outline(map.runsOf(1))).toHaveLength(3);
  });

  it("of squares hold what the squares hold", () => {
    const map = randomMap(30, 22, 77);
    for (const side of [1, 2, 4]) {
      const squares = coarser(map.runsOf(2), side);
      const loops = outline(squares);
      for (let v = 0; v * side < 22; ++v) {
        for (let u = 0; u * side < 30; ++u) {
          let held = false;
          for (let k = 0; k < side * side; ++k) held ||= map.at(u * side + (k % side), v * side + Math.floor(k / side)) === 2;
          expect(inside(loops, u, v)).toBe(held);
        }
      }
    }
  });

  it("have a line for each hole", () => {
    const map = mapOf("aaaaa", "a.a.a", "aaaaa");
    expect(outline(map.runsOf(1))).toHaveLength(3);
  });
});
