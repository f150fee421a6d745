import { describe, expect, it } from "vitest";
import type { Point } from "../../src/domain/geometry";
import { cellsAt } from "../../src/domain/map";
import { faultOfRing, isInCells, parseZones, renamedIn, type Zone, zoneCollection, zonesOf, windowWords, zonesText, zoneWords } from "../../src/domain/zone";

const square: Point[] = [[0, 0], [4, 0], [4, 4], [0, 4]];
const hole: Point[] = [[1, 1], [2, 1], [2, 2]];
const zones: Zone[] = [
  { kind: "no_fly", name: "helipad; 2", agents: ["heli"], rings: [square, hole] },
  { kind: "keep_out", name: "", agents: [], rings: [square] },
];

it("stands in files as GeoJSON in cells, and comes back", () => {
  const collection = zoneCollection(zones);
  expect(collection.crs).toBe("cells");
  expect(collection.features[0]!.geometry.coordinates[0]).toEqual([...square, [0, 0]]);
  expect(collection.features[0]!.properties).toEqual({ zone: "no_fly", name: "helipad; 2", agents: ["heli"] });
  expect(collection.features[1]!.properties).toEqual({ zone: "keep_out" });
  expect(zonesOf(JSON.parse(JSON.stringify(collection)))).toEqual(zones);
});

it("has times where it holds for a time only", () => {
  const timed: Zone[] = [{ ...zones[1]!, from: 10, until: 20.5 }, { ...zones[1]!, until: 5 }, { ...zones[1]!, from: 0 }];
  const collection = zoneCollection(timed);
  expect(collection.features.map(({ properties }) => properties)).toEqual([
    { zone: "keep_out", from: 10, until: 20.5 },
    { zone: "keep_out", until: 5 },
    { zone: "keep_out", from: 0 },
  ]);
  expect(zonesOf(JSON.parse(JSON.stringify(collection)))).toEqual(timed);
  expect(zonesText(timed.slice(0, 2))).toBe("keep_out:::0,0,4,0,4,4,0,4:10,20.5;keep_out:::0,0,4,0,4,4,0,4:,5");
  expect(parseZones(zonesText(timed))).toEqual(timed);
  expect(parseZones("keep_out:::0,0,4,0,4,4,0,4:-1,")).toBeNull();
  expect(timed.map(windowWords)).toEqual(["from 10 until 20.5", "until 5", "from 0"]);
});

it("is several where a feature has several polygons", () => {
  const [first] = zoneCollection(zones).features;
  const coordinates = [first!.geometry.coordinates, [[...hole, [1, 1]]]];
  const feature = { ...first, geometry: { type: "MultiPolygon", coordinates } };
  expect(zonesOf({ crs: "cells", features: [feature] })!.map(({ rings }) => rings.length)).toEqual([2, 1]);
});

it("is read in longitude and latitude where the map says where it lies", () => {
  const cellAt = cellsAt([0.5, 0.25, 13, 0.1, -0.5, 52]);
  expect(cellAt([13 + 0.5 * 4 + 0.25 * 2, 52 + 0.1 * 4 - 0.5 * 2])).toEqual([4, 2]);
  const { features } = zoneCollection(zones);
  const degrees = (corner: Point): Point => [13 + 0.5 * corner[0] + 0.25 * corner[1], 52 + 0.1 * corner[0] - 0.5 * corner[1]];
  for (const { geometry } of features) geometry.coordinates = geometry.coordinates.map((ring) => ring.map(degrees));
  const collection = { type: "FeatureCollection", features };
  expect(isInCells(collection)).toBe(false);
  expect(zonesOf(collection, cellAt)).toEqual(zones);
  expect(zonesOf(collection)).toBeNull();
});

it.each([
  null,
  {},
  { features: [] },
  { crs: "cells", features: [null] },
  { crs: "cells", features: [{ properties: { zone: "park" }, geometry: { type: "Polygon", coordinates: [square] } }] },
  { crs: "cells", features: [{ properties: { zone: "no_fly" }, geometry: { type: "Point", coordinates: [1, 2] } }] },
  { crs: "cells", features: [{ properties: { zone: "no_fly" }, geometry: { type: "Polygon", coordinates: [[["a", 1]]] } }] },
  { crs: "cells", features: [{ properties: { zone: "no_fly", name: 7 }, geometry: { type: "Polygon", coordinates: [square] } }] },
  { crs: "cells", features: [{ properties: { zone: "no_fly", until: "soon" }, geometry: { type: "Polygon", coordinates: [square] } }] },
  { crs: "cells", features: [{ properties: { zone: "no_fly", agents: [7] }, geometry: { type: "Polygon", coordinates: [square] } }] },
])("is none in %j", (value) => {
  expect(zonesOf(value)).toBeNull();
});

it("is short in a link", () => {
  expect(zonesText(zones)).toBe("no_fly:helipad%3B%202:heli:0,0,4,0,4,4,0,4/1,1,2,1,2,2;keep_out:::0,0,4,0,4,4,0,4");
  expect(parseZones(zonesText(zones))).toEqual(zones);
});

describe("an outline", () => {
  it.each([
    [[[0, 0], [4, 0]], "three corners"],
    [[[0, 0], [4, 4], [4, 0], [0, 4]], "cross"],
    [[[0, 0], [4, 0], [2, 0], [2, 4]], "cross or touch"], // back along its own side
    [[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]], "cross or touch"], // a corner on a side
  ] as [Point[], string][])("%j is none", (ring, fault) => {
    expect(faultOfRing(ring)).toContain(fault);
  });

  it("may have any other shape", () => {
    expect(faultOfRing(square)).toBeNull();
    expect(faultOfRing([...square].reverse())).toBeNull();
    expect(faultOfRing([[0, 0], [2, 0], [4, 0], [4, 4], [3, 1]])).toBeNull(); // straight on at a corner
  });
});

it("goes with the names of its agents, and with the last of them", () => {
  expect(renamedIn(zones, "heli", "hawk")[0]!.agents).toEqual(["hawk"]);
  expect(renamedIn(zones, "other", null)).toEqual(zones);
  expect(renamedIn(zones, "heli", null)).toEqual([zones[1]]);
});

it("has words", () => {
  expect(zones.map(zoneWords)).toEqual(["No-fly zone helipad; 2", "Keep-out zone"]);
});
