import { describe, expect, it } from "vitest";
import { fixedObstacles, obstaclePixels } from "../../../src/map/tiles/obstacle_pixels";
import { tileSize } from "../../../src/map/tiles/tiles";
import { mapOf, randomMap } from "../../domain/picture";

const colours = { obstacle: "#0000ff", obstacleEdge: "#00ff00", fixed: "#ff0000", fixedEdge: "#ffffff" };
const names: Record<number, string> = { 0: ".", 0xffff0000: "o", 0xff00ff00: "e", 0xff0000ff: "f", 0xffffffff: "F" };

function picture(map: ReturnType<typeof mapOf>, level: number, width: number, height: number): string[] {
  const pixels = obstaclePixels(map, fixedObstacles(map), { level, column: 0, row: 0 }, colours);
  return Array.from({ length: height }, (_, y) =>
    Array.from({ length: width }, (_, x) => names[pixels[y * tileSize + x]!] ?? "?").join(""),
  );
}

describe("pixels of obstacles", () => {
  it("have a line around each obstacle, and one between two that touch", () => {
    // Capital letters cannot be removed.
    expect(picture(mapOf("abA.", "a.A."), 2, 16, 8)).toEqual([
      "eeeeeeeeFFFF....",
      "eooeooooFffF....",
      "eooeooooFffF....",
      "eooeeeeeFffF....",
      "eooe....FffF....",
      "eooe....FffF....",
      "eooe....FffF....",
      "eeee....FFFF....",
    ]);
  });

  it("are at every level those of the cells", () => {
    const map = randomMap(40, 30, 5);
    const fixed = fixedObstacles(map);
    for (const level of [0, 1, 2, 3]) {
      const pixels = obstaclePixels(map, fixed, { level, column: 0, row: 0 }, colours);
      const scale = 2 ** level;
      let wrong = 0;
      for (let y = 0; y < tileSize; ++y) {
        for (let x = 0; x < tileSize; ++x) {
          const blocked = map.at(Math.floor(x / scale), Math.floor(y / scale)) !== 0;
          if ((pixels[y * tileSize + x] !== 0) !== blocked) ++wrong;
        }
      }
      expect(wrong).toBe(0);
    }
  });

  it("are in overview as opaque as there are obstacles", () => {
    const map = randomMap(50, 37, 6);
    for (const level of [-1, -2, -3]) {
      const side = 2 ** -level;
      const pixels = obstaclePixels(map, fixedObstacles(map), { level, column: 0, row: 0 }, colours);
      for (let y = 0; y * side < map.height; ++y) {
        for (let x = 0; x * side < map.width; ++x) {
          let blocked = 0;
          for (let k = 0; k < side * side; ++k) {
            if (map.at(x * side + (k % side), y * side + Math.floor(k / side)) !== 0) ++blocked;
          }
          expect(pixels[y * tileSize + x]! >>> 24).toBe(Math.round((255 * blocked) / (side * side)));
        }
      }
    }
  });
});
