// Sets of cells as runs, sorted by row and column, none touching the next: what has been drawn and erased.
import type { Run } from "../domain/geometry";

type Spans = [from: number, end: number][];

export function union(a: readonly Run[], b: readonly Run[]): Run[] {
  return combine(a, b, (inA, inB) => inA || inB);
}

export function difference(a: readonly Run[], b: readonly Run[]): Run[] {
  return combine(a, b, (inA, inB) => inA && !inB);
}

export function isEmpty(runs: readonly Run[]): boolean {
  return runs.length === 0;
}

export function cellCount(runs: readonly Run[]): number {
  return runs.reduce((sum, [, , length]) => sum + length, 0);
}

export function includes(runs: readonly Run[], x: number, y: number): boolean {
  return runs.some(([from, row, length]) => row === y && from <= x && x < from + length);
}

// Only what lies on the map.
export function clipped(runs: readonly Run[], width: number, height: number): Run[] {
  return union(
    runs.flatMap(([x, y, length]): Run[] => {
      const from = Math.max(x, 0);
      const end = Math.min(x + length, width);
      return y >= 0 && y < height && end > from ? [[from, y, end - from]] : [];
    }),
    [],
  );
}

function combine(a: readonly Run[], b: readonly Run[], keep: (inA: boolean, inB: boolean) => boolean): Run[] {
  const rowsA = byRow(a);
  const rowsB = byRow(b);
  const rows = [...new Set([...rowsA.keys(), ...rowsB.keys()])].sort((p, q) => p - q);
  return rows.flatMap((y) =>
    sweep(rowsA.get(y) ?? [], rowsB.get(y) ?? [], keep).map(([x, end]): Run => [x, y, end - x]),
  );
}

function byRow(runs: readonly Run[]): Map<number, Spans> {
  const rows = new Map<number, Spans>();
  for (const [x, y, length] of runs) {
    const spans = rows.get(y);
    if (spans) spans.push([x, x + length]);
    else rows.set(y, [[x, x + length]]);
  }
  return rows;
}

// From left to right over all ends: the number of open spans of each set determines where the result begins and ends.
function sweep(a: Spans, b: Spans, keep: (inA: boolean, inB: boolean) => boolean): Spans {
  const ends: [x: number, ofA: number, ofB: number][] = [];
  for (const [from, end] of a) ends.push([from, 1, 0], [end, -1, 0]);
  for (const [from, end] of b) ends.push([from, 0, 1], [end, 0, -1]);
  ends.sort((p, q) => p[0] - q[0]);
  const result: Spans = [];
  let inA = 0;
  let inB = 0;
  let from: number | null = null;
  for (let i = 0; i < ends.length;) {
    const x = ends[i]![0];
    for (; i < ends.length && ends[i]![0] === x; ++i) {
      inA += ends[i]![1];
      inB += ends[i]![2];
    }
    const kept = keep(inA > 0, inB > 0);
    if (kept && from === null) from = x;
    if (!kept && from !== null) {
      result.push([from, x]);
      from = null;
    }
  }
  return result;
}
