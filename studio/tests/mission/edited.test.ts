// Walls that are drawn and erased, and what is sent of them.
import { expect, it } from "vitest";
import { freshMission, type Mission } from "../../src/domain/mission";
import { drawn, editsOf } from "../../src/mission/edited";
import type { HeldMap } from "../../src/mission/maps";
import { mapOf } from "../domain/picture";

const cells = mapOf("..aa..", "..aa..", "......");
const city = { cells } as HeldMap;
const shown = { base: city, map: city };
const mission = freshMission("city.map", { start: [0, 2], goal: [5, 2] });
const after = (before: Mission, tool: "wall" | "erase", ...runs: [number, number, number][]) => drawn(before, tool, runs, shown);

it("draws one wall through all that stands in its way", () => {
  const walled = after(mission, "wall", [0, 1, 6]);
  expect(walled.walls).toEqual([[0, 1, 6]]);
  expect(editsOf(walled, cells)).toEqual({ block: [[0, 1, 6]], free: [[2, 1, 2]] });
  expect(after(mission, "wall", [4, 0, 9]).walls).toEqual([[4, 0, 2]]); // none off the map
});

it("erases walls first, so that what was beneath stands again, and then that", () => {
  const once = after(after(mission, "wall", [0, 1, 6]), "erase", [0, 1, 6]);
  expect(editsOf(once, cells)).toEqual({ block: [], free: [] });
  const twice = after(once, "erase", [0, 1, 6]);
  expect(editsOf(twice, cells)).toEqual({ block: [], free: [[2, 1, 2]] });
  expect(editsOf(after(twice, "wall", [3, 1, 1]), cells)).toEqual({ block: [[3, 1, 1]], free: [[2, 1, 2]] });
});
