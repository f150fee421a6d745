// Where start and goal stand on a map that does not say: at opposite corners of the largest region that the vehicle can
// drive in, so that there is a way between them.
import type { CellMap } from "../domain/cell_map";
import type { Cell } from "../domain/geometry";
import type { MapDescription } from "../domain/map";
import { freshMission, type Ends, type Mission } from "../domain/mission";

// The maps of data/ are shown with missions that two removals shorten, through what people know there.
const ready: Record<string, Ends> = {
  "andorra.tif": { start: [251, 185], goal: [395, 395] },
  "berlin-adlershof.tif": { start: [130, 104], goal: [466, 105] },
  "berlin-mitte.tif": { start: [111, 111], goal: [332, 120] },
  "honolulu.tif": { start: [430, 405], goal: [360, 177] },
  "krems.tif": { start: [173, 127], goal: [239, 334] },
  "krems-flooded.tif": { start: [182, 167], goal: [233, 423] },
  "kyoto.tif": { start: [370, 167], goal: [359, 344] },
  "manhattan.tif": { start: [75, 249], goal: [315, 344] },
  "monaco.tif": { start: [377, 373], goal: [262, 229] },
  "turin.tif": { start: [166, 426], goal: [132, 168] },
};

export function defaultMission(map: MapDescription, cells: CellMap): Mission {
  const said = map.start && map.goal ? { start: map.start, goal: map.goal } : null;
  const known = ready[map.id];
  const fits = known && free(cells, known.start) && free(cells, known.goal) ? known : null;
  const ends = said ?? fits ?? farApart(cells, map.usual_radius);
  return freshMission(map.id, { ...ends, radius: map.usual_radius });
}

function free(cells: CellMap, [x, y]: Cell): boolean {
  return x < cells.width && y < cells.height && cells.at(x, y) === 0;
}

interface FreeRun {
  y: number;
  from: number;
  end: number;
}

export function farApart(cells: CellMap, radius = 0.5): Ends {
  const region = largestRegion(cells, radius);
  const inset = 0.08;
  const [right, bottom] = [cells.width - 1, cells.height - 1];
  const near = (x: number, y: number) => nearestIn(region, Math.round(x * right), Math.round(y * bottom));
  return { start: near(inset, 1 - inset), goal: near(1 - inset, inset) };
}

// Columns to either side, by rows away, whose cells a disc reaches into from the centre of a cell.
function discRows(radius: number): number[] {
  const rows: number[] = [];
  for (let away = 0; away === 0 || away - 0.5 < radius; ++away) {
    const half = Math.sqrt(Math.max(radius ** 2 - Math.max(away - 0.5, 0) ** 2, 0));
    rows.push(Math.max(Math.ceil(half + 0.5) - 1, 0));
  }
  return rows;
}

// Cells of a row on which the disc meets no obstacle.
function freeRuns(cells: CellMap, y: number, disc: number[]): FreeRun[] {
  const barred: [number, number][] = [];
  for (let row = Math.max(y - disc.length + 1, 0); row < Math.min(y + disc.length, cells.height); ++row) {
    const wide = disc[Math.abs(row - y)]!;
    for (let i = cells.rowStart[row]!; i < cells.rowStart[row + 1]!; ++i) {
      barred.push([cells.from[i]! - wide, cells.from[i]! + cells.length[i]! + wide]);
    }
  }
  barred.sort((a, b) => a[0] - b[0]);
  const runs: FreeRun[] = [];
  let x = 0;
  for (const [from, end] of barred) {
    if (from > x) runs.push({ y, from: x, end: from });
    x = Math.max(x, end);
  }
  if (x < cells.width) runs.push({ y, from: x, end: cells.width });
  return runs;
}

// Free cells that hang together by sides, as runs: joined row by row (union-find).
function largestRegion(cells: CellMap, radius: number): FreeRun[] {
  const disc = discRows(radius);
  const runs: FreeRun[] = [];
  const parent: number[] = [];
  const root = (i: number): number => {
    while (parent[i] !== i) i = parent[i] = parent[parent[i]!]!;
    return i;
  };
  let above = 0; // first run of the row before
  for (let y = 0; y < cells.height; ++y) {
    const first = runs.length;
    let other = above;
    for (const run of freeRuns(cells, y, disc)) {
      const index = runs.push(run) - 1;
      parent.push(index);
      while (other < first && runs[other]!.end <= run.from) ++other;
      for (let i = other; i < first && runs[i]!.from < run.end; ++i) parent[root(i)] = root(index);
    }
    above = first;
  }
  const sizes = new Map<number, number>();
  runs.forEach((run, i) => sizes.set(root(i), (sizes.get(root(i)) ?? 0) + run.end - run.from));
  const largest = [...sizes].reduce((a, b) => (b[1] > a[1] ? b : a), [-1, 0])[0];
  return runs.filter((_, i) => root(i) === largest);
}

function nearestIn(region: FreeRun[], x: number, y: number): Cell {
  let best: Cell = [x, y];
  let distance = Infinity;
  for (const run of region) {
    const x2 = Math.min(Math.max(x, run.from), run.end - 1);
    const far = (x2 - x) ** 2 + (run.y - y) ** 2;
    if (far < distance) [best, distance] = [[x2, run.y], far];
  }
  return best;
}
