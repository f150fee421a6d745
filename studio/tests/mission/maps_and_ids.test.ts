import { describe, expect, it } from "vitest";
import { pair } from "../../src/domain/agents";
import type { CellMap } from "../../src/domain/cell_map";
import type { MapDescription } from "../../src/domain/map";
import { freshMission, type Mission, wallCell, wallKey, withMark } from "../../src/domain/mission";
import { defaultMission, farApart } from "../../src/mission/default_mission";
import { drawn, editsOf } from "../../src/mission/edited";
import type { ShownMap } from "../../src/mission/maps";
import { Translation } from "../../src/mission/translate";
import { mapOf } from "../domain/picture";

const markers = { start: [0, 0] as [number, number], goal: [1, 0] as [number, number] };
const described = (map: Partial<MapDescription>) => ({ id: "m", start: null, goal: null, ...map }) as MapDescription;
const shownOf = (base: CellMap, map: CellMap): ShownMap => {
  const held = (cells: CellMap) => ({ description: described({}), cells, background: { features: [] } });
  return { base: held(base), map: held(map), ids: new Translation(base, map, []) };
};

describe("ids", () => {
  // b is gone, c has lost its left half, a wall w was drawn against it.
  const base = mapOf("aa.bb..", "aa.bb..", "..ccccc");
  const edited = mapOf("aa.....", "aa.....", "..w.ccc");
  const ids = new Translation(base, edited, [[2, 2, 1]]);
  const wall = wallKey([2, 2], 7);

  it("are found by cells of the obstacle", () => {
    expect([1, 2, 3].map((id) => ids.toShown(id))).toEqual([1, 0, 2]);
    expect([1, 2].map((id) => ids.toBase(id))).toEqual([1, 3]);
    expect(ids.toShown(77)).toBe(0);
  });

  it("call drawn walls by a cell", () => {
    expect(wallCell(wall, 7)).toEqual([2, 2]);
    expect(ids.toBase(3)).toBe(wall);
    expect(ids.toShown(wall)).toBe(3);
    expect(ids.toShown(wallKey([6, 0], 7))).toBe(0);
  });

  it("are the same where nothing was drawn", () => {
    const same = new Translation(base, base, []);
    expect([1, 2, 3].map((id) => same.toShown(id))).toEqual([1, 2, 3]);
    expect(same.toShown(4)).toBe(0);
  });
});

describe("edits", () => {
  const base = mapOf("aa.bb..", "aa.bb..", "..ccccc");
  const mission: Mission = freshMission("m", markers);

  it("free what is erased and what is excluded", () => {
    const edits = editsOf({ ...withMark(mission, 2, "exclude"), erased: [[2, 2, 2]], walls: [[6, 0, 1]] }, base);
    expect(edits).toEqual({
      free: [
        [3, 0, 2],
        [3, 1, 2],
        [2, 2, 2],
      ],
      block: [[6, 0, 1]],
    });
  });

  it("take obstacles and drawn walls away with one stroke", () => {
    const edited = mapOf("aa.bbww", "aa.bb..", "..ccccc");
    const after = drawn({ ...mission, walls: [[5, 0, 2]] }, "erase", [[4, 0, 2]], shownOf(base, edited));
    expect(after.walls).toEqual([[6, 0, 1]]);
    expect(after.erased).toEqual([[4, 0, 1]]);
  });
});

describe("default mission", () => {
  it("is the map's own where it has one", () => {
    const map = mapOf("...", "...");
    expect(defaultMission(described({ start: [0, 1], goal: [2, 0] }), map).agents).toEqual(pair([0, 1], [2, 0]));
  });

  it("stands at opposite corners of the largest open region", () => {
    const map = mapOf(
      "....a.....", //
      "....a.aa..",
      "aaaaa.aa..",
      "..a.......",
      "..a.......",
    );
    const { start, goal } = farApart(map);
    expect(goal).toEqual([8, 0]);
    expect(start).toEqual([3, 4]);
  });

  it("hangs together by sides, not by corners", () => {
    const map = mapOf("..aaa", "..aaa", "aa...", "aa...", "aa...");
    const { start, goal } = farApart(map);
    expect([start, goal].every(([x, y]) => x >= 2 && y >= 2)).toBe(true);
  });

  it("stands where a wide vehicle fits, and can get away", () => {
    const map = mapOf(
      "a.........", //
      "a.aaaaa...",
      "a.a.......",
      "..a.......",
      "..aaaaa...",
    );
    expect(farApart(map, 0.5).start).toEqual([1, 4]);
    expect(farApart(map, 1.2)).toEqual({ start: [8, 4], goal: [8, 0] });
  });

  it("can stand on any map with a free cell", () => {
    expect(farApart(mapOf("aaa", "a.a"))).toEqual({ start: [1, 1], goal: [1, 1] });
    expect(farApart(mapOf("aa")).start).toHaveLength(2);
  });
});
