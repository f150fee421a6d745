import { expect, it } from "vitest";
import { cellsOf, rubbleAt, rubbleRadius } from "../../src/domain/rubble";
import { mapOf, pictureOf } from "./picture";

const map = mapOf(".......", "....aa.", ".......", ".......", ".......");

it("covers the free cells around a place, on the map", () => {
  expect(pictureOf(rubbleAt([3, 1], map, []), 7, 5)).toEqual(["..###..", "..##...", "..###..", ".......", "......."]);
  expect(pictureOf(rubbleAt([0, 4], map, []), 7, 5)).toEqual([".......", ".......", ".......", "##.....", "##....."]);
  expect(rubbleAt([4, 1], mapOf("...aaa...", "...aaa...", "...aaa..."), [])).toEqual([]);
});

it("falls on no vehicle", () => {
  const runs = rubbleAt([3, 3], map, [{ at: [2.2, 3], radius: 0.5 }]);
  expect(pictureOf(runs, 7, 5)).toEqual([".......", ".......", "..###..", "....#..", "..###.."]);
});

it("is as wide as a street", () => {
  expect([20, 150, 501, 4096].map((side) => rubbleRadius({ width: side, height: side }))).toEqual([1, 2, 4, 4]);
});

it("counts its cells", () => {
  expect(cellsOf([[3, 1, 2], [0, 2, 1]])).toEqual([[3, 1], [4, 1], [0, 2]]);
});
