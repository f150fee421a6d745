import { describe, expect, it } from "vitest";
import type { Point } from "../../src/domain/geometry";
import { outline } from "../../src/map/outline";
import { coarser } from "../../src/map/outlines";
import { nearestFree } from "../../src/map/snap";
import { changed, strokeRuns } from "../../src/map/stroke";
import { draws, mapOf, pictureOf, randomMap } from "../domain/picture";

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

describe("strokes", () => {
  const empty = mapOf(...Array.from({ length: 7 }, () => "..........a"));

  it("cover the cells along them", () => {
    const runs = strokeRuns([[1, 1], [6, 1], [6, 5]], 1.2, empty);
    expect(pictureOf(runs, 11, 7)).toEqual([
      ".######....",
      "########...",
      ".#######...",
      ".....###...",
      ".....###...",
      ".....###...",
      "......#....",
    ]);
  });

  it("end with the map", () => {
    const runs = strokeRuns([[-4, 3], [20, 3]], 1.2, empty);
    expect(pictureOf(runs, 11, 7).filter((row) => row.includes("#"))).toEqual(Array(3).fill("###########"));
  });

  it("hold together, whatever their way", () => {
    const draw = draws(8);
    const map = mapOf(...Array.from({ length: 40 }, () => ".".repeat(40)));
    for (let k = 0; k < 20; ++k) {
      const points = Array.from({ length: 5 }, (): Point => [40 * draw(), 40 * draw()]);
      const rows = pictureOf(strokeRuns(points, 1.2, map), 40, 40);
      expect(pieces(rows)).toBe(1);
    }
  });

  it("change only what can be changed", () => {
    const map = mapOf("..aa..", "..aa..");
    const runs = strokeRuns([[0, 0], [5, 0]], 0.5, map);
    expect(changed(runs, "wall", map)).toEqual([
      [0, 0, 2],
      [4, 0, 2],
    ]);
    expect(changed(runs, "erase", map)).toEqual([[2, 0, 2]]);
  });
});

// Sets of cells connected by their sides.
function pieces(rows: string[]): number {
  const left = new Set(rows.flatMap((row, y) => [...row].flatMap((one, x) => (one === "#" ? [`${x} ${y}`] : []))));
  let count = 0;
  for (const first of left) {
    ++count;
    const open = [first];
    for (let cell = open.pop(); cell !== undefined; cell = open.pop()) {
      left.delete(cell);
      const [x, y] = cell.split(" ").map(Number) as [number, number];
      for (const next of [`${x + 1} ${y}`, `${x - 1} ${y}`, `${x} ${y + 1}`, `${x} ${y - 1}`]) {
        if (left.has(next)) open.push(next);
      }
    }
  }
  return count;
}
