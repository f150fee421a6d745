import { expect, it } from "vitest";
import type { Run } from "../../src/domain/geometry";
import { cellCount, difference, union } from "../../src/mission/run_set";
import { Random } from "./random";

const size = 12;

function randomRuns(random: Random): Run[] {
  return Array.from({ length: random.below(12) }, (): Run => [
    random.below(size),
    random.below(4),
    1 + random.below(5),
  ]);
}

function cellsOf(runs: readonly Run[]): Set<string> {
  return new Set(runs.flatMap(([x, y, length]) => Array.from({ length }, (_, i) => `${x + i},${y}`)));
}

it("does with runs what sets do with cells", () => {
  const random = new Random(3);
  for (let i = 0; i < 500; ++i) {
    const [a, b] = [randomRuns(random), randomRuns(random)];
    const [inA, inB] = [cellsOf(a), cellsOf(b)];
    expect(cellsOf(union(a, b))).toEqual(new Set([...inA, ...inB]));
    expect(cellsOf(difference(a, b))).toEqual(new Set([...inA].filter((cell) => !inB.has(cell))));
    expect(cellCount(union(a, b))).toBe(cellsOf([...a, ...b]).size);
  }
});

it("joins runs that touch and sorts them", () => {
  expect(
    union(
      [
        [5, 1, 2],
        [0, 1, 5],
      ],
      [[3, 0, 1]],
    ),
  ).toEqual([
    [3, 0, 1],
    [0, 1, 7],
  ]);
});
