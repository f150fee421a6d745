import { expect, it } from "vitest";
import { cellsOf, Extract, isOpenStreetMap, type Source, usualImport } from "../../src/domain/extract";

const source: Source = {
  id: "source-1", name: "town.osm.pbf", bytes: 9, buildings: 3,
  bounds: [9, 50, 9.1, 50.05], columns: 2, rows: 1, built: [0.5, 0],
  densest: { center: [9.03, 50.02], size: 1202.4 },
  places: [{ name: "Stadt", at: [9.05, 50.025] }, { name: "Vorstadt", at: [9.051, 50.026] }, { name: "Au", at: [9.02, 50.04] }],
};
const extract = new Extract(source);

it("is flat, in metres from its north-western corner", () => {
  expect(extract.toPlane([9, 50.05])).toEqual([0, 0]);
  expect(extract.size.width).toBeCloseTo(7150, -2);
  expect(extract.size.height).toBeCloseTo(5566, 0);
  for (const at of [[9.04, 50.01], [9.1, 50]] as const) {
    const [lon, lat] = extract.toLonLat(extract.toPlane([...at]));
    expect(lon).toBeCloseTo(at[0], 5);
    expect(lat).toBeCloseTo(at[1], 5);
  }
});

it("keeps windows on the data", () => {
  expect(extract.placed([0, 0], 1000)).toEqual([500, 500]);
  expect(extract.placed([1e6, 1e6], 1000)).toEqual([extract.size.width - 500, extract.size.height - 500]);
  expect(extract.placed([3000, 2000], 1000)).toEqual([3000, 2000]);
  expect(extract.placed([0, 2000], 6000)).toEqual([3000, extract.size.height / 2]);
});

it("ends, and windows can reach beyond", () => {
  expect(extract.reachesBeyond({ center: [9.05, 50.025], size: 5600 })).toBe(false);
  expect(extract.reachesBeyond({ center: [9.05, 50.025], size: 5700 })).toBe(true);
  expect(extract.reachesBeyond({ center: [9.005, 50.025], size: 1202.4 })).toBe(true);
  expect(isOpenStreetMap(source)).toBe(true);
  expect(isOpenStreetMap({ ...source, name: "houses.GeoJSON" })).toBe(false);
});

it("is drawn where it is built up", () => {
  const shades = extract.shades(5);
  expect(shades.slice(0, 4)).toEqual(["", "", "", ""]);
  expect(shades[4]).toMatch(/^M0\.0 0\.0h35\d\d\.\dv5566\.0h-35\d\d\.\dz$/);
});

it("is imported where it is densest, unless something else is said", () => {
  const request = usualImport(source);
  expect(request).toMatchObject({ source: "source-1", center: [9.03, 50.02], profile: "rover", section: 20 });
  expect(cellsOf(request)).toBe(501);
});

it("names places where there is room", () => {
  const named = (left: number, right: number) =>
    extract.placesIn({ left, top: 0, right, bottom: 6000 }).map(({ name }) => name);
  expect(named(0, 7000)).toEqual(["Stadt", "Au"]);
  expect(named(3000, 4000)).toEqual(["Stadt", "Vorstadt"]);
});
