import { expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { ZoneSketch } from "../../../src/map/interaction/zone_sketch";

const scale = 10; // pixels of a cell

function drawn(...points: Point[]) {
  const sketch = new ZoneSketch();
  return { sketch, last: points.map((point) => sketch.add(point, scale)).at(-1) };
}

it("closes at its first corner, and begins anew", () => {
  const { sketch, last } = drawn([0.1, 0.1], [9.4, 0], [9, 6.1], [0.6, 0.2]);
  expect(last).toEqual([[0, 0], [9.5, 0], [9, 6]]);
  expect(sketch.corners).toEqual([]);
});

it("closes where the last corner is set again, as by a double click", () => {
  expect(drawn([0, 0], [9, 0], [9, 6], [9.2, 6]).last).toEqual([[0, 0], [9, 0], [9, 6]]);
});

it("does not close before it has three corners", () => {
  const { sketch, last } = drawn([0, 0], [9, 0], [9.1, 0]);
  expect(last).toBeNull();
  expect(sketch.corners).toEqual([[0, 0], [9, 0]]);
});

it("takes back the last corner", () => {
  const { sketch } = drawn([0, 0], [9, 0], [9, 6]);
  sketch.takeBack();
  expect(sketch.corners).toEqual([[0, 0], [9, 0]]);
  sketch.drop();
  sketch.takeBack();
  expect(sketch.corners).toEqual([]);
});
