import { describe, expect, it } from "vitest";
import {
  boxOf,
  coarsestLevel,
  finestLevel,
  levelFor,
  parentOf,
  partOf,
  span,
  tileSize,
  tilesOver,
} from "../../../src/map/tiles/tiles";

const city = { width: 4096, height: 4000 };

describe("tiles", () => {
  it("have one for the whole map at the coarsest level", () => {
    for (const side of [1, 3, 256, 257, 501, 1024, 4096, 5000]) {
      const map = { width: side, height: 2 };
      const all = tilesOver({ left: 0, top: 0, right: side, bottom: 2 }, coarsestLevel(map), map);
      expect(all).toEqual([{ level: coarsestLevel(map), column: 0, row: 0 }]);
    }
    expect(coarsestLevel({ width: 100, height: 100 })).toBe(0);
    expect(coarsestLevel(city)).toBe(-4);
  });

  it("are hardly ever shown larger than they are, and at most four times as many pixels as needed", () => {
    for (let scale = 0.07; scale < 64; scale *= 1.01) {
      const shown = scale / 2 ** levelFor(scale, -4);
      expect(shown).toBeLessThanOrEqual(2 ** 0.2 + 1e-9);
      expect(shown).toBeGreaterThan(2 ** -0.8 - 1e-9);
    }
    expect(levelFor(1e9, -4)).toBe(finestLevel);
    expect(levelFor(1e-9, -4)).toBe(-4);
  });

  it("cover what is seen, once, and no more than touches it", () => {
    const seen = { left: 700.2, top: -100, right: 1500.7, bottom: 900 };
    for (let level = -4; level <= finestLevel; ++level) {
      const tiles = tilesOver(seen, level, city);
      const cells = span(level);
      const columns = Math.floor((seen.right + 0.5) / cells) - Math.floor((seen.left + 0.5) / cells) + 1;
      const rows = Math.floor((seen.bottom + 0.5) / cells) + 1; // none above the map
      expect(new Set(tiles.map(({ column, row }) => `${column} ${row}`)).size).toBe(columns * rows);
      expect(tiles).toHaveLength(columns * rows);
      const beside = tiles.map(boxOf).filter((box) => {
        return box.left > seen.right || box.right < seen.left || box.top > seen.bottom || box.bottom < seen.top;
      });
      expect(beside).toEqual([]);
    }
  });

  it("come from the middle outwards", () => {
    const [first] = tilesOver({ left: 0, top: 0, right: 1279, bottom: 1279 }, 0, city);
    expect(first).toEqual({ level: 0, column: 2, row: 2 });
  });

  it("lie in their ancestors where these show the same cells", () => {
    let ancestor = { level: 3, column: 77, row: 42 };
    const tile = ancestor;
    for (; ancestor.level >= -4; ancestor = parentOf(ancestor)) {
      const part = partOf(tile, ancestor);
      const cellsPerPixel = span(ancestor.level) / tileSize;
      expect(boxOf(ancestor).left + part.x * cellsPerPixel).toBeCloseTo(boxOf(tile).left);
      expect(boxOf(ancestor).top + part.y * cellsPerPixel).toBeCloseTo(boxOf(tile).top);
      expect(part.size * cellsPerPixel).toBeCloseTo(span(tile.level));
    }
  });
});
