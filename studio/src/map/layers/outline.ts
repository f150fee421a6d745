// The outline of a set of cells: closed lines along their edges, in map points. Holes come as lines of their own, so
// that an even-odd fill fills the cells alone.
import type { Point, Run } from "../../domain/geometry";

// Corners are numbered y * stride + x; every edge of the outline leads from one to another with the cells on its right.
export function outline(runs: readonly Run[]): Point[][] {
  if (runs.length === 0) return [];
  const stride = runs.reduce((most, [x, , length]) => Math.max(most, x + length), 0) + 2;
  const next = new Map<number, number[]>();
  const edge = (from: number, to: number): void => {
    const known = next.get(from);
    if (known) known.push(to);
    else next.set(from, [to]);
  };
  const rows = byRow(runs);
  for (const [y, row] of rows) {
    for (const [from, end] of row) {
      edge((y + 1) * stride + from, y * stride + from);
      edge(y * stride + end, (y + 1) * stride + end);
    }
    for (const [from, end] of without(row, rows.get(y - 1) ?? [])) edge(y * stride + from, y * stride + end);
    for (const [from, end] of without(row, rows.get(y + 1) ?? [])) edge((y + 1) * stride + end, (y + 1) * stride + from);
  }
  return chained(next, stride);
}

type Interval = [from: number, end: number];

// Intervals of each row, from left to right, joined where they touch.
function byRow(runs: readonly Run[]): Map<number, Interval[]> {
  const rows = new Map<number, Interval[]>();
  for (const [x, y, length] of [...runs].sort((a, b) => a[1] - b[1] || a[0] - b[0])) {
    const row = rows.get(y);
    const last = row?.at(-1);
    if (last && x <= last[1]) last[1] = Math.max(last[1], x + length);
    else if (row) row.push([x, x + length]);
    else rows.set(y, [[x, x + length]]);
  }
  return rows;
}

// What of `row` is not in `other`; both from left to right.
function* without(row: Interval[], other: Interval[]): Generator<Interval> {
  let k = 0;
  for (const [from, end] of row) {
    let at = from;
    while (k < other.length && other[k]![1] <= at) ++k;
    for (let j = k; j < other.length && other[j]![0] < end; ++j) {
      if (other[j]![0] > at) yield [at, other[j]![0]];
      at = Math.max(at, other[j]![1]);
    }
    if (at < end) yield [at, end];
  }
}

// Follows edges into closed lines. Where two lines cross in a corner, it turns right: cells that touch there only stay
// apart.
function chained(next: Map<number, number[]>, stride: number): Point[][] {
  const direction = (from: number, to: number): number => {
    if (Math.floor(from / stride) === Math.floor(to / stride)) return to > from ? 0 : 2;
    return to > from ? 1 : 3;
  };
  const loops: Point[][] = [];
  for (const start of next.keys()) {
    while ((next.get(start)?.length ?? 0) > 0) {
      const corners: number[] = [];
      let at = start;
      let heading = -1;
      do {
        const ways = next.get(at)!;
        const right = ways.findIndex((to) => direction(at, to) === (heading + 1) % 4);
        const [to] = ways.splice(heading >= 0 && right >= 0 ? right : 0, 1) as [number];
        const turn = direction(at, to);
        if (turn !== heading) corners.push(at);
        heading = turn;
        at = to;
      } while (at !== start);
      if (corners.length > 1 && direction(corners[0]!, corners[1]!) === heading) corners.shift();
      loops.push(corners.map((corner): Point => [(corner % stride) - 0.5, Math.floor(corner / stride) - 0.5]));
    }
  }
  return loops;
}
