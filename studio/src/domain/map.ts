// Maps as docs/server.md has them.
import type { Cell, Point } from "./geometry";

export interface MapDescription {
  id: string;
  source: string;
  format: string;
  width: number;
  height: number;
  cell_size: number; // metres
  blocked: number;
  density: number;
  // sections: how many obstacles are parts of a building; only of a map that is cut into such
  obstacles: { count: number; sections?: number; largest: { id: number; source_id: number; cells: number } | null };
  // to_lon_lat: [a, b, c, d, e, f] with lon = a x + b y + c, lat = d x + e y + f
  georeference: { crs: string; center: [lon: number, lat: number]; to_lon_lat: number[] } | null;
  start: Cell | null;
  goal: Cell | null;
  usual_radius?: number; // of a vehicle of which nobody says how large it is, in cells
  unknown: number; // cells of which nobody knows what is there
  title: string;
  attribution: string;
  notes: string[]; // what was noticed when the map was made, and when it was read
  digest: string;
}

// Where a longitude and latitude lies, in cells, to a hundredth; `toLonLat` as in descriptions of maps.
export function cellsAt(toLonLat: readonly number[]): (lonLat: Point) => Point {
  const [a, b, c, d, e, f] = toLonLat as [number, number, number, number, number, number];
  const area = a * e - b * d;
  const rounded = (value: number) => Math.round(100 * value) / 100 + 0; // no -0
  return ([lon, lat]) => [
    rounded(((lon - c) * e - (lat - f) * b) / area),
    rounded(((lat - f) * a - (lon - c) * d) / area),
  ];
}

export type Kind = "unknown" | "building" | "barrier" | "water" | "cliff" | "forbidden" | "off_road";

// What a section is a part of.
export interface Structure {
  kind: Kind;
  source_id?: number;
  name?: string;
}

export interface Obstacle {
  id: number; // from 1, in the order of the array
  source_id: number; // OpenStreetMap's: ways positive, relations negative; 0 where unknown
  name: string;
  cells: number;
  bounds: [xMin: number, yMin: number, xMax: number, yMax: number];
  destructible: boolean;
  weight: number;
  breach_time: number;
  kind?: Kind; // of maps that say what their obstacles are
  tags?: string[]; // amenity=school, ...
  structures?: Structure[]; // of a section
}

export interface Obstacles {
  width: number;
  height: number;
  obstacles: Obstacle[];
  runs: number[]; // label, length, label, length, ...: row after row, a run may span rows; 0 is free
  next?: number | null; // what to ask the next part for; null in the last one
}

export interface Feature {
  kind: "street" | "rail" | "water" | "green" | "place";
  class: string;
  name: string;
  shape: "line" | "area" | "point";
  points: Point[][]; // parts of a line, rings of an area (even-odd), one part of one point
}

export interface Background {
  features: Feature[];
}
