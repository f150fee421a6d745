import { expect, it } from "vitest";
import { CellMap } from "../../src/domain/cell_map";
import { mapOf, pictureOf, randomMap } from "./picture";

it("knows what stands on a cell, and the cells of an obstacle", () => {
  const map = mapOf("aab.", ".ab.", "bbb.");
  expect([map.at(0, 0), map.at(2, 0), map.at(3, 0), map.at(0, 1)]).toEqual([1, 2, 0, 0]);
  expect([map.at(-1, 0), map.at(4, 0), map.at(0, 3), map.at(0, -1)]).toEqual([0, 0, 0, 0]);
  expect(pictureOf(map.runsOf(1), 4, 3)).toEqual(["##..", ".#..", "...."]);
  expect(pictureOf(map.runsOf(2), 4, 3)).toEqual(["..#.", "..#.", "###."]);
  expect(map.runsOf(9)).toEqual([]);
  expect(pictureOf(map.runsOf(2, { left: -9, top: 1, right: 1, bottom: 9 }), 4, 3)).toEqual(["....", "....", "###."]);
});

it("has the same cells for runs within rows and across them", () => {
  const map = randomMap(13, 11, 3);
  const runs: number[] = [];
  for (let k = 0; k < 13 * 11; ++k) {
    const label = map.at(k % 13, Math.floor(k / 13));
    if (runs.at(-2) === label) runs[runs.length - 1]! += 1;
    else runs.push(label, 1);
  }
  const other = new CellMap({ width: 13, height: 11, obstacles: [...map.obstacles], runs });
  for (let y = 0; y < 11; ++y) for (let x = 0; x < 13; ++x) expect(other.at(x, y)).toBe(map.at(x, y));
});

it("bears runs that are too few or too many", () => {
  const obstacles = mapOf("a").obstacles;
  expect(new CellMap({ width: 3, height: 2, obstacles: [...obstacles], runs: [1, 2] }).at(1, 1)).toBe(0);
  expect(new CellMap({ width: 3, height: 2, obstacles: [...obstacles], runs: [0, 5, 1, 99] }).at(2, 1)).toBe(1);
});
