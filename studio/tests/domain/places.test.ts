import { expect, it } from "vitest";
import type { Background, Feature, Obstacle } from "../../src/domain/map";
import { PlaceIndex } from "../../src/domain/places";
import { mapOf } from "./picture";

const street = (name: string, ...points: [number, number][]): Feature => ({
  kind: "street", class: "residential", name, shape: "line", points: [points],
});
const background: Background = {
  features: [
    street("Hauptstraße", [0, 0], [1, 0], [2, 0]),
    street("Hauptstraße", [5, 5], [6, 5]),
    street("Am Dom", [0, 2], [3, 2]),
    { kind: "place", class: "square", name: "Domplatz", shape: "point", points: [[[4, 4]]] },
    { kind: "water", class: "lake", name: "Domsee", shape: "area", points: [[[0, 0], [2, 0], [2, 4], [0, 4]]] },
  ],
};

function cells() {
  const map = mapOf("aab", "aa.");
  const [dom, house] = map.obstacles as [Obstacle, Obstacle];
  Object.assign(dom, { name: "Dom", tags: ["building=cathedral"] });
  Object.assign(house, { name: "Café Élan, Hof", structures: [{ kind: "building", name: "Café Élan" }, { kind: "building" }] });
  return map;
}

const find = (query: string) => new PlaceIndex(background, cells()).find(query);

it("finds what begins so first, then what has a word that does", () => {
  expect(find("dom").map((place) => place.name)).toEqual(["Domsee", "Dom", "Domplatz", "Am Dom"]);
  expect(find("sse").map((place) => place.name)).toEqual(["Hauptstraße"]);
  expect(find("nowhere")).toEqual([]);
  expect(find("  ")).toEqual([]);
});

it("minds neither accents nor capital letters", () => {
  expect(find("HAUPTSTRASSE")).toMatchObject([{ name: "Hauptstraße", at: [1, 0], obstacle: null }]);
  expect(find("cafe elan")).toMatchObject([{ name: "Café Élan", obstacle: 2, what: "section of 2 buildings" }]);
});

it("finds obstacles by what they are used for", () => {
  expect(find("cathedral")).toMatchObject([{ name: "Dom", obstacle: 1, what: "cathedral" }]);
});

it("finds what has a use and no name, each", () => {
  const map = mapOf("a.b", "...");
  for (const one of map.obstacles) Object.assign(one, { kind: "building", tags: ["amenity=school"] });
  const found = new PlaceIndex({ features: [] }, map).find("school");
  expect(found).toMatchObject([
    { name: "School", what: "building", obstacle: 1 },
    { name: "School", what: "building", obstacle: 2 },
  ]);
});

it("shows an area in its middle", () => {
  expect(find("domsee")[0]?.at).toEqual([1, 2]);
});

it("knows where there is nothing to find", () => {
  expect(new PlaceIndex({ features: [] }, mapOf("a")).isEmpty).toBe(true);
  expect(new PlaceIndex(background, cells()).isEmpty).toBe(false);
});
