import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { blocked, strokeRuns } from "../../../src/map/interaction/stroke";
import { draws, mapOf, pictureOf } from "../../domain/picture";

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

  it("erase only what stands there", () => {
    const map = mapOf("..aa..", "..aa..");
    const runs = strokeRuns([[0, 0], [5, 0]], 0.5, map);
    expect(blocked(runs, map)).toEqual([[2, 0, 2]]);
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
