// Obstacles have other ids on a map that was drawn on. An obstacle is found again by its cells.
import type { CellMap } from "../domain/cell_map";
import type { Cell, Run } from "../domain/geometry";
import { wallCell, wallKey } from "../domain/mission";

export class Translation {
  readonly #found = new Map<number, number>(); // asked again with each picture

  constructor(
    private readonly base: CellMap,
    private readonly shown: CellMap,
    private readonly walls: readonly Run[],
  ) {}

  // The obstacle of the map shown; 0 where nothing of it is left.
  toShown(key: number): number {
    const id = this.#found.get(key) ?? this.#find(key);
    this.#found.set(key, id);
    return id;
  }

  #find(key: number): number {
    if (key < 0) {
      const [x, y] = wallCell(key, this.base.width);
      return this.isWall(x, y) ? this.shown.at(x, y) : 0;
    }
    if (this.base === this.shown) return key <= this.base.obstacles.length ? key : 0;
    for (const [x, y, length] of this.base.runsOf(key)) {
      for (let i = x; i < x + length; ++i) {
        const id = this.shown.at(i, y);
        if (id !== 0 && !this.isWall(i, y)) return id;
      }
    }
    return 0;
  }

  // The obstacle's id on the base map, or the key of a drawn wall.
  toBase(id: number): number {
    if (this.base === this.shown) return id;
    let wall: Cell | null = null;
    for (const [x, y, length] of this.shown.runsOf(id)) {
      for (let i = x; i < x + length; ++i) {
        if (this.isWall(i, y)) wall ??= [i, y];
        else if (this.base.at(i, y) !== 0) return this.base.at(i, y);
      }
    }
    return wall ? wallKey(wall, this.base.width) : 0;
  }

  private isWall(x: number, y: number): boolean {
    return this.walls.some(([from, row, length]) => row === y && from <= x && x < from + length);
  }
}
