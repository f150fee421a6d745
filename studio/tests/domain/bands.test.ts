import { expect, it } from "vitest";
import { Bands } from "../../src/domain/bands";
import { reach } from "./reach_document";

it("are known by cell", () => {
  const bands = Bands.of(reach)!;
  expect([...bands.after]).toEqual([1, 1, 2, 2, 2, 1, 1, 0, 2, 3]);
  expect([...bands.before]).toEqual([1, 1, 0, 3, 3, 1, 2, 0, 3, 3]);
  expect(bands.at([1, 1])).toEqual({ before: 2, after: 1 });
  expect(bands.at([2, 0])).toEqual({ before: 0, after: 2 }); // what is opened
  for (const cell of [[2, 1], [-1, 0], [5, 0], [0, 2]] as const) expect(bands.at([...cell])).toBeNull();
  expect(bands.unreached).toBe(3);
});

it("have shares of the free ground", () => {
  const { after, gains } = Bands.of(reach)!.shares();
  expect(after.slice(1)).toEqual([4 / 9, 4 / 9, 1 / 9]);
  expect(gains).toEqual([5 / 9, 1 / 9, 3 / 9]);
});

it("are none of a plan that is not of many places", () => {
  expect(Bands.of({ format: "waybreaker-reach/1", width: 5, height: 2, bands: [] })).toBeNull();
});
