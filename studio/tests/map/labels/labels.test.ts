import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import type { Feature } from "../../../src/domain/map";
import { boxesAlong, type Label, placed } from "../../../src/map/labels/labels";
import { joined, type Name, namesOf, widest, wrapped } from "../../../src/map/labels/names";
import { draws, mapOf } from "../../domain/picture";

const map = mapOf("....");
const everywhere = { left: -1e6, top: -1e6, right: 1e6, bottom: 1e6 };
const sizeOf = (name: Name): { width: number; height: number } => ({
  width: 6 * Math.max(...name.lines.map((line) => line.length)),
  height: 12 * name.lines.length,
});

function street(name: string, ...points: Point[]): Feature {
  return { kind: "street", class: "residential", name, shape: "line", points: [points] };
}

function corners({ at, angle, name }: Label, scale: number): Point[] {
  const { width, height } = sizeOf(name);
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [-1, 1].flatMap((u) =>
    [-1, 1].map((v): Point => {
      const [dx, dy] = [(u * width) / 2, (v * height) / 2];
      return [at[0] * scale + dx * cos - dy * sin, at[1] * scale + dx * sin + dy * cos];
    }),
  );
}

// Two rectangles are apart if all of one is beyond a side of the other.
function meet(a: Label, b: Label, scale: number): boolean {
  const [p, q] = [corners(a, scale), corners(b, scale)];
  const apart = [a.angle, a.angle + Math.PI / 2, b.angle, b.angle + Math.PI / 2].some((angle) => {
    const along = ([x, y]: Point): number => x * Math.cos(angle) + y * Math.sin(angle);
    const [us, vs] = [p.map(along), q.map(along)];
    return Math.max(...us) < Math.min(...vs) || Math.max(...vs) < Math.min(...us);
  });
  return !apart;
}

describe("labels", () => {
  it("never cover one another", () => {
    const draw = draws(11);
    const features = Array.from({ length: 150 }, (_, i) => {
      const from: Point = [300 * draw(), 300 * draw()];
      return street(`Street ${i}`, from, [from[0] + 200 * (draw() - 0.5), from[1] + 200 * (draw() - 0.5)]);
    });
    const names = namesOf({ features }, map);
    for (const scale of [1, 2, 5]) {
      const labels = placed(names, scale, 1, everywhere, sizeOf);
      expect(labels.length).toBeGreaterThan(15);
      labels.forEach((one, i) => labels.slice(0, i).forEach((other) => expect(meet(one, other, scale)).toBe(false)));
    }
  });

  it("lie on their street and can be read from below", () => {
    const names = namesOf({ features: [street("Long Lane", [100, 100], [20, 40])] }, map);
    const [label] = placed(names, 3, 1, everywhere, sizeOf);
    expect(label!.at[0]).toBeCloseTo(60);
    expect(label!.at[1]).toBeCloseTo(70);
    expect(label!.angle).toBeCloseTo(Math.atan2(60, 80));
  });

  it("are left out where the street is too short or too bent, or seen from too far", () => {
    const features = [
      street("Much too long for this", [0, 0], [10, 0]),
      street("Winding", ...Array.from({ length: 40 }, (_, i): Point => [4 * i, 200 + 12 * (i % 2)])),
    ];
    expect(placed(namesOf({ features }, map), 3, 1, everywhere, sizeOf)).toEqual([]);
    const far = namesOf({ features: [street("Lane", [0, 0], [4000, 0])] }, map);
    expect(placed(far, 0.1, 1, everywhere, sizeOf)).toEqual([]);
  });

  it("go to names of higher rank first", () => {
    const features: Feature[] = [
      street("Lane", [0, 10], [100, 10]),
      { ...street("Avenue", [0, 12], [100, 12]), class: "primary" },
    ];
    const labels = placed(namesOf({ features }, map), 1, 1, everywhere, sizeOf);
    expect(labels.map(({ name }) => name.lines[0])).toEqual(["Avenue"]);
  });

  it("lie within their part of the map", () => {
    const features = Array.from({ length: 20 }, (_, i) => street(`Street ${i}`, [-500, 20 * i], [500, 20 * i]));
    const part = { left: 0, top: 100, right: 150, bottom: 200 };
    const labels = placed(namesOf({ features }, map), 2, 1, part, sizeOf);
    expect(labels.length).toBeGreaterThan(2);
    for (const [x, y] of labels.flatMap((label) => corners(label, 2))) {
      expect(x >= 0 && x <= 300 && y >= 200 && y <= 400).toBe(true);
    }
  });
});

describe("names", () => {
  it("are written along pieces that belong together", () => {
    expect(joined([[[0, 0], [1, 0]], [[2, 0], [1, 0]], [[2, 0], [3, 1]], [[9, 9], [8, 8]]])).toEqual([
      [[0, 0], [1, 0], [2, 0], [3, 1]],
      [[9, 9], [8, 8]],
    ]);
    expect(joined([[[1, 0], [2, 0]], [[0, 0], [1, 0]]])).toEqual([[[0, 0], [1, 0], [2, 0]]]);
    expect(joined([[[0, 0], [1, 0], [1, 1]], [[1, 1], [0, 0]]])).toHaveLength(1); // around a block
    expect(joined([[[0, 0]], []])).toEqual([]);
  });

  it("of areas stand within them", () => {
    // An L, whose centre of gravity is outside of its short arm.
    expect(widest([[[0, 0], [2, 0], [2, 8], [10, 8], [10, 10], [0, 10]]])).toMatchObject({ at: [1, expect.closeTo(5)], room: 2 });
    // A ring: beside its hole.
    const ring: Point[][] = [[[0, 0], [10, 0], [10, 10], [0, 10]], [[2, 2], [7, 2], [7, 8], [2, 8]]];
    expect(widest(ring)).toMatchObject({ at: [8.5, expect.closeTo(5)], room: 3 });
  });

  it("break at spaces", () => {
    expect(wrapped("Museum")).toEqual(["Museum"]);
    expect(wrapped("Deutsches Historisches Museum")).toEqual(["Deutsches", "Historisches", "Museum"]);
    expect(wrapped("Haus am See")).toEqual(["Haus am See"]);
  });

  it("of buildings stand on them", () => {
    const cells = mapOf("aaa.....", "aaaaaa..", "aaa.....", "aaa.....");
    const [building] = namesOf({ features: [] }, Object.assign(cells, { obstacles: [{ ...cells.obstacle(1)!, name: "Hall" }] }));
    expect(building).toMatchObject({ at: [2.5, 1], room: 6 });
  });
});

it("boxes along a name cover it, and little else", () => {
  const size = { width: 90, height: 12 };
  for (const angle of [0, 0.4, Math.PI / 4, 1.2, Math.PI / 2]) {
    const boxes = boxesAlong([50, 40], angle, size);
    const holds = (x: number, y: number) =>
      boxes.some(({ left, right, top, bottom }) => x >= left - 1e-9 && x <= right + 1e-9 && y >= top - 1e-9 && y <= bottom + 1e-9);
    for (let along = -45; along <= 45; along += 5) {
      for (const across of [-6, 0, 6]) {
        const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
        expect(holds(50 + along * cos - across * sin, 40 + along * sin + across * cos)).toBe(true);
      }
    }
    for (const { left, right, top, bottom } of boxes) {
      expect(Math.max(right - left, bottom - top)).toBeLessThanOrEqual(12 * Math.SQRT2 + 1e-9);
    }
  }
});
