// Maps as pictures: a dot is free, letters are obstacles in the order of the alphabet.
import { CellMap } from "../../src/domain/cell_map";
import type { Run } from "../../src/domain/geometry";
import type { Obstacle } from "../../src/domain/map";

export function mapOf(...rows: string[]): CellMap {
  const width = rows[0]!.length;
  const labels = rows.join("").replaceAll(" ", "");
  const letters = [...new Set(labels.replaceAll(".", ""))].sort();
  const obstacles = letters.map((letter, i): Obstacle => {
    const cells = [...labels].flatMap((one, k) => (one === letter ? [[k % width, Math.floor(k / width)] as const] : []));
    const xs = cells.map(([x]) => x);
    const ys = cells.map(([, y]) => y);
    return {
      id: i + 1,
      source_id: 0,
      name: "",
      cells: cells.length,
      bounds: [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)],
      destructible: letter === letter.toLowerCase(),
      weight: 1,
      breach_time: 0,
    };
  });
  const runs = [...labels].flatMap((letter) => [letters.indexOf(letter) + 1, 1]);
  return new CellMap({ width, height: rows.length, obstacles, runs });
}

export function pictureOf(runs: readonly Run[], width: number, height: number): string[] {
  const rows = Array.from({ length: height }, () => Array<string>(width).fill("."));
  for (const [x, y, length] of runs) rows[y]!.fill("#", x, x + length);
  return rows.map((row) => row.join(""));
}

// Numbers that look random and are the same in each run.
export function draws(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

export function randomMap(width: number, height: number, seed: number): CellMap {
  const draw = draws(seed);
  const row = (): string => Array.from({ length: width }, () => "....abcD"[Math.floor(draw() * 8)]).join("");
  return mapOf(...Array.from({ length: height }, row));
}
