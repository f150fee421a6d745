import { describe, expect, it } from "vitest";
import { overlap, type Point } from "../../../src/domain/geometry";
import type { Background, Feature } from "../../../src/domain/map";
import { FeatureIndex, nested, streetShows, streetStyle } from "../../../src/map/tiles/ground_features";
import { draws } from "../../domain/picture";

function square(x: number, y: number, side: number): Point[] {
  return [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
}

describe("the ground", () => {
  it("is found wherever it is in view, each part for itself", () => {
    const draw = draws(31);
    const lines = Array.from({ length: 200 }, (): Point[] => {
      const [x, y] = [900 * draw(), 900 * draw()];
      return [[x, y], [x + 200 * (draw() - 0.5), y + 200 * (draw() - 0.5)]];
    });
    const background: Background = {
      features: [{ kind: "street", class: "primary", name: "", shape: "line", points: lines }],
    };
    const index = new FeatureIndex(background, { width: 1000, height: 1000 });
    for (let k = 0; k < 50; ++k) {
      const [left, top] = [800 * draw(), 800 * draw()];
      const view = { left, top, right: left + 150 * draw(), bottom: top + 150 * draw() };
      const found = index.over(view).map((i) => index.features[i]!.points[0]);
      const there = index.features.filter((_, i) => overlap(index.bounds[i]!, view)).map(({ points }) => points[0]);
      expect(found).toEqual(there);
    }
    expect(index.features).toHaveLength(200);
  });

  it("ends with the map, however far its features go", () => {
    const shape = { kind: "green", class: "constructor", name: "", shape: "area", points: [square(-1e12, -1e12, 2e12)] } as const;
    const index = new FeatureIndex({ features: [shape as unknown as Feature] }, { width: 50, height: 50 });
    expect(index.over({ left: -1e9, top: 3, right: 1e9, bottom: 9 })).toEqual([0]);
    expect(streetStyle("constructor")).toBe(streetStyle("residential"));
  });

  it("keeps holes with what they are in", () => {
    const [park, pond, island, meadow] = [square(0, 0, 50), square(10, 10, 20), square(15, 15, 2), square(100, 0, 10)];
    expect(nested([island, meadow, pond, park])).toEqual([[park, pond, island], [meadow]]);
    expect(nested([])).toEqual([]);
  });

  it("is drawn with green below water below streets, great streets last", () => {
    const feature = (kind: "street" | "water" | "green" | "rail", name: string) =>
      ({ kind, class: name, name: "", shape: "line", points: [[[0, 0], [1, 1]]] }) as const;
    const features = [feature("rail", "rail"), feature("street", "primary"), feature("street", "footway"), feature("green", "park"), feature("water", "river")];
    const index = new FeatureIndex({ features: features as unknown as Background["features"] }, { width: 9, height: 9 });
    expect(index.features.map((one) => one.class)).toEqual(["park", "river", "footway", "primary", "rail"]);
  });

  it("shows great streets from farther away", () => {
    expect(streetShows(streetStyle("primary"), 0.01)).toBe(true);
    expect(streetShows(streetStyle("footway"), 0.2)).toBe(false);
    expect(streetShows(streetStyle("footway"), 0.5)).toBe(true);
    expect(streetStyle("primary_link")).toBe(streetStyle("primary"));
    expect(streetStyle("of the future")).toBe(streetStyle("residential"));
  });
});
