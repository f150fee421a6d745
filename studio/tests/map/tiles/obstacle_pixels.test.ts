import { describe, expect, it } from "vitest";
import { ObstacleLooks, obstaclePixels } from "../../../src/map/tiles/obstacle_pixels";
import { tileSize } from "../../../src/map/tiles/tiles";
import type { Obstacle } from "../../../src/domain/map";
import { mapOf, randomMap } from "../../domain/picture";

const colours = {
  removable: { fill: "#0000ff", edge: "#00ff00" },
  barrier: { fill: "#00ffff", edge: "#ffff00" },
  fixed: { fill: "#ff0000", edge: "#ffffff" },
  water: { fill: "#101010", edge: "#606060" },
  cliff: { fill: "#202020", edge: "#303030" },
  forbidden: { fill: "#505050", edge: "#a0a0a0" },
  off_road: { fill: "#d0d0d0", edge: "#909090" },
  unknown: { fill: "#c0c0c0", edge: "#707070" },
};
const names: Record<number, string> = {
  0: ".", 0xffff0000: "o", 0xff00ff00: "e", 0xff0000ff: "f", 0xffffffff: "F", 0xffffff00: "b", 0xff00ffff: "B",
  0xff101010: "w", 0xff606060: "W", 0xff404040: "~", 0xff505050: "c", 0xffa0a0a0: "C", 0xff808080: "s",
  0xffc0c0c0: "u", 0xff707070: "U", 0xff909090: "#",
  0xffd0d0d0: "r", 0xffaaaaaa: "'",
};

function picture(map: ReturnType<typeof mapOf>, level: number, width: number, height: number): string[] {
  const pixels = obstaclePixels(map, new ObstacleLooks(map), { level, column: 0, row: 0 }, colours);
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
    const looks = new ObstacleLooks(map);
    for (const level of [0, 1, 2, 3]) {
      const pixels = obstaclePixels(map, looks, { level, column: 0, row: 0 }, colours);
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
      const pixels = obstaclePixels(map, new ObstacleLooks(map), { level, column: 0, row: 0 }, colours);
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

  it("tell water, barriers and forbidden ground apart by colour and by pattern", () => {
    const map = mapOf("abbcdd");
    const kinds = ["barrier", "water", "water", "forbidden"] as const;
    map.obstacles.forEach((one, i) => Object.assign(one, { kind: kinds[i], destructible: i === 0 }));
    // Both waters are one, and have waves; what is forbidden has stripes.
    expect(picture(map, 3, 48, 8)).toEqual([
      "BBBBBBBBWWWWWWWWWWWWWWWWWWWWWWWWCCCCCCCCCCCCCCCC",
      "BbbbbbbBwwwwwwwwwwwwwwwwwwwwwwwWcssccccccssccccC",
      "BbbbbbbBwwwwwwwwwwwwwwwwwwwwwwwWccssccccccsscccC",
      "BbbbbbbBwwwwwwwwwwwwwwwwwwwwwwwWcccssccccccssccC",
      "BbbbbbbBwwwwwwww~~~~~~~~wwwwwwwWccccssccccccsscC",
      "BbbbbbbBwwwwwwwwwwwwwwwwwwwwwwwWcccccssccccccssC",
      "BbbbbbbBwwwwwwwwwwwwwwwwwwwwwwwWccccccssccccccsC",
      "BBBBBBBBWWWWWWWWWWWWWWWWWWWWWWWWCCCCCCCCCCCCCCCC",
    ]);
  });

  it("have dots beside the roads that a truck keeps to", () => {
    const map = mapOf("A");
    Object.assign(map.obstacle(1)!, { kind: "off_road", destructible: false });
    const rows = picture(map, 4, 16, 16).map((row) => row.slice(1, 15));
    expect(rows[4]).toBe("r'rrrrrrr'rrrr");
    expect(rows[12]).toBe("rrrrr'rrrrrrr'");
    for (const y of [2, 6, 8, 10, 14]) expect(rows[y]).toBe("rrrrrrrrrrrrrr");
  });

  it("have a lattice where nobody knows what is there", () => {
    const map = mapOf("A");
    Object.assign(map.obstacle(1)!, { tags: ["occupancy=unknown"] });
    // Lines and edges of the map, as of any obstacle; inside, both diagonals.
    expect(picture(map, 4, 16, 16).slice(1, 9)).toEqual([
      "U#uuuuu#u#uuuuuU",
      "Uu#uuu#uuu#uuu#U",
      "Uuu#u#uuuuu#u#uU",
      "Uuuu#uuuuuuu#uuU",
      "Uuu#u#uuuuu#u#uU",
      "Uu#uuu#uuu#uuu#U",
      "U#uuuuu#u#uuuuuU",
      "Uuuuuuuu#uuuuuuU",
    ]);
  });

  it("part sections of one building faintly, and waters that touch not at all", () => {
    const line = (a: Partial<Obstacle>, b: Partial<Obstacle>) => {
      const map = mapOf("ab");
      Object.assign(map.obstacle(1)!, a);
      Object.assign(map.obstacle(2)!, b);
      return new ObstacleLooks(map).line(1, 2);
    };
    const of = (...ids: number[]) => ({ structures: ids.map((source_id) => ({ kind: "building" as const, source_id })) });
    const water = { kind: "water" as const, destructible: false };
    expect(line(of(1), of(2))).toBe(1);
    expect(line(of(1, 2), of(2, 3))).toBeGreaterThan(0);
    expect(line(of(1, 2), of(2, 3))).toBeLessThan(1);
    expect(line(water, water)).toBe(0);
    expect(line({}, water)).toBe(1);
  });
});
