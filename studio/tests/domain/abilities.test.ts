import { expect, it } from "vitest";
import { type Abilities, abilitiesDocument, abilitiesOf, hasOwnAbilities, isChoice, opens, usualAbilities } from "../../src/domain/abilities";
import type { Obstacle } from "../../src/domain/map";
import { mapOf } from "../domain/picture";

const paced = { cell: 2, seconds: 3 };
const own: Abilities = { breachTime: 30, breachTimePerCell: 1.5, mostArea: 80, only: [17, "barrier", "building=garage,shed"] };

it("says in files what is not as usual, in cells", () => {
  expect(abilitiesDocument(usualAbilities, 2)).toEqual({});
  expect(hasOwnAbilities(usualAbilities)).toBe(false);
  const can_breach = { most_cells: 20, only: [17, "barrier", "building=garage,shed"] };
  expect(abilitiesDocument(own, 2)).toEqual({ breach_time: 30, breach_time_per_cell: 1.5, can_breach });
  expect(abilitiesDocument({ ...usualAbilities, breachTime: 0, only: [] }, 2)).toEqual({ breach_time: 0, can_breach: { only: [] } });
});

it("reads them in seconds and square metres", () => {
  const can_breach = { most_cells: 20, only: ["barrier", 17, "building=garage,shed"] };
  expect(abilitiesOf({ breach_time: 10, breach_time_per_cell: 0.5, can_breach }, paced)).toEqual(own);
  expect(abilitiesOf({}, paced)).toEqual(usualAbilities);
  expect(abilitiesOf({ breach_time: 0, can_breach: { only: [] } }, paced)).toEqual({ ...usualAbilities, breachTime: 0, only: [] });
  expect(abilitiesOf({ can_breach: { only: ["building=garage,heritage=2,shed"] } }, paced).only).toEqual(["building=garage", "heritage=2,shed"]);
});

it("opens no more than was said: cells are whole, and those of a file come back", () => {
  const cellsOf = (mostArea: number, cell: number) => abilitiesDocument({ ...usualAbilities, mostArea }, cell).can_breach!.most_cells;
  expect(cellsOf(300, 2.4)).toBe(52); // of 5.76 m² each
  expect([cellsOf(1, 2.4), cellsOf(1e12, 0.05)]).toEqual([1, 2 ** 32 - 1]);
  for (const cell of [1, 2.4, 0.05, 1 / 3]) {
    for (const most_cells of [1, 7, 60, 123_457]) {
      expect(cellsOf(abilitiesOf({ can_breach: { most_cells } }, { cell, seconds: 1 }).mostArea!, cell)).toBe(most_cells);
    }
  }
});

it("knows what it can read", () => {
  for (const can of [{}, { most_cells: 3 }, { only: [] }, { most_cells: 1, only: [1, "barrier"] }]) expect(isChoice(can)).toBe(true);
  for (const can of [null, 5, [], "barrier", { least_cells: 1 }, { only: "barrier" }, { only: [""] }, { only: [null] }]) {
    expect(isChoice(can)).toBe(false);
    expect(abilitiesOf({ can_breach: can as never }, paced)).toEqual(usualAbilities);
  }
  const most = (most_cells: unknown) => abilitiesOf({ can_breach: { most_cells: most_cells as number } }, paced).mostArea;
  expect([most(1.5), most(0), most("9")]).toEqual([NaN, NaN, NaN]);
});

it("opens what is small enough and named", () => {
  const [shed, wall] = mapOf("aaa.b", "aaa..").obstacles.map((one, i): Obstacle => ({ ...one, tags: [["building=shed"], ["barrier=wall"]][i]! }));
  const opened = (able: Partial<Abilities>) => [shed!, wall!].filter((one) => opens({ ...usualAbilities, ...able }, one, 2)).map(({ id }) => id);
  expect(opened({})).toEqual([1, 2]);
  expect(opened({ mostArea: 24 })).toEqual([1, 2]);
  expect(opened({ mostArea: 23.9 })).toEqual([2]);
  expect(opened({ only: [1] })).toEqual([1]);
  expect(opened({ only: [1, "barrier"] })).toEqual([1, 2]);
  expect(opened({ only: ["building=garage"] })).toEqual([]);
  expect(opened({ only: [1, 2], mostArea: 4 })).toEqual([2]);
  expect(opened({ only: [] })).toEqual([]);
});
