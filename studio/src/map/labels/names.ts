// What could be written on the map, and where: names of streets and waters along them, of places and buildings on them.
import type { CellMap } from "../../domain/cell_map";
import type { Box, Point } from "../../domain/geometry";
import type { Background, Feature, Obstacle } from "../../domain/map";
import { shortenedName } from "../../domain/plain_name";
import { boundsOf, streetStyle } from "../tiles/ground_features";

export type NameKind = "place" | "street" | "water" | "green" | "building";

export interface Name {
  kind: NameKind;
  lines: string[]; // of text
  rank: number; // higher ones are written first
  nearest: number; // from so many pixels per metre on
  along: Point[] | null; // a line to write along,
  at: Point; // or a point to write at,
  box: Box; // around all of the line or the point
  room: number; // where so many cells are free to the sides; 0: no matter
}

const longest = 16; // letters in a line of text
const longestName = 60; // letters

export function namesOf(background: Background, cells: CellMap): Name[] {
  const names: Name[] = [];
  const streets = new Map<string, Feature[]>();
  for (const feature of background.features) {
    if (feature.name === "" || !feature.points[0]?.[0]) continue;
    if (feature.shape === "line" && (feature.kind === "street" || feature.kind === "water")) {
      const key = `${feature.kind} ${feature.name}`;
      const known = streets.get(key);
      if (known) known.push(feature);
      else streets.set(key, [feature]);
    } else if (feature.shape === "point") names.push(placeName(feature));
    else if (feature.shape === "area" && feature.kind !== "rail") names.push(areaName(feature));
  }
  for (const features of streets.values()) names.push(...lineNames(features));
  for (const obstacle of cells.obstacles) if (obstacle.name) names.push(buildingName(obstacle, cells));
  return names.sort((a, b) => b.rank - a.rank);
}

// Streets come in many pieces of one name; written along the whole, a name finds room.
function lineNames(features: Feature[]): Name[] {
  const { kind, name } = features[0]!;
  const rank = Math.max(...features.map((feature) => streetStyle(feature.class).rank));
  const nearest = kind === "water" ? 0.2 : ([9, 3, 2, 0.9, 0.7, 0.45, 0.3, 0.2, 0.2][rank] ?? 1);
  return joined(features.flatMap((feature) => feature.points)).map((along) => ({
    kind: kind === "water" ? "water" : "street",
    lines: [shortenedName(name, longestName)],
    rank: kind === "water" ? 9 : rank,
    nearest,
    along,
    at: along[0]!,
    box: boundsOf([along]),
    room: 0,
  }));
}

const places = new Map<string, [rank: number, nearest: number]>([
  ["city", [30, 0]],
  ["town", [29, 0]],
  ["borough", [28, 0]],
  ["suburb", [27, 0]],
  ["quarter", [26, 0.1]],
  ["village", [26, 0.1]],
  ["neighbourhood", [25, 0.2]],
]);

function placeName(feature: Feature): Name {
  const [rank, nearest] = places.get(feature.class) ?? [10, 0.6];
  const lines = wrapped(feature.name);
  return { kind: "place", lines, rank, nearest, room: 0, ...standing(feature.points[0]![0]!) };
}

function areaName(feature: Feature): Name {
  const { at, room } = widest(feature.points);
  const kind = feature.kind === "street" ? "street" : feature.kind === "water" ? "water" : "green";
  return { kind, lines: wrapped(feature.name), rank: kind === "street" ? 5 : 3, nearest: 0.3, room, ...standing(at) };
}

function buildingName(obstacle: Obstacle, cells: CellMap): Name {
  const { at, room } = middleOf(obstacle, cells);
  return { kind: "building", lines: wrapped(obstacle.name), rank: 1, nearest: 0.8, room, ...standing(at) };
}

// Where to write on an obstacle: on the longest run of its middle half, which is on it even where it is bent.
export function middleOf({ id, bounds }: Obstacle, cells: CellMap): { at: Point; room: number } {
  const quarter = (bounds[3] - bounds[1]) / 4;
  const runs = cells.runsOf(id);
  const middle = runs.filter(([, y]) => y >= bounds[1] + quarter && y <= bounds[3] - quarter);
  const [x, y, room] = (middle.length > 0 ? middle : runs).reduce((best, run) => (run[2] > best[2] ? run : best));
  return { at: [x + (room - 1) / 2, y], room };
}

function standing(at: Point): Pick<Name, "along" | "at" | "box"> {
  return { along: null, at, box: boundsOf([[at]]) };
}

// Lines of text, broken at spaces where they get long.
export function wrapped(text: string): string[] {
  const lines: string[] = [];
  for (const word of shortenedName(text, longestName).split(" ")) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= longest) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

// Lines joined where one ends and another begins.
export function joined(parts: readonly Point[][]): Point[][] {
  const key = ([x, y]: Point): string => `${x} ${y}`;
  const left = new Set(parts.filter((part) => part.length > 1));
  const ends = new Map<string, Set<Point[]>>();
  for (const part of left) {
    for (const end of [part[0]!, part.at(-1)!]) {
      const known = ends.get(key(end));
      if (known) known.add(part);
      else ends.set(key(end), new Set([part]));
    }
  }
  const next = (end: Point): Point[] | null => {
    const part = [...(ends.get(key(end)) ?? [])].find((one) => left.has(one));
    if (!part) return null;
    left.delete(part);
    return key(part[0]!) === key(end) ? part : [...part].reverse();
  };
  const lines: Point[][] = [];
  for (const first of left) {
    left.delete(first);
    const line = [...first];
    for (let part = next(line.at(-1)!); part; part = next(line.at(-1)!)) line.push(...part.slice(1));
    for (let part = next(line[0]!); part; part = next(line[0]!)) line.unshift(...part.slice(1).reverse());
    lines.push(line);
  }
  return lines;
}

// The middle of the widest stretch across an area at half its height: inside, whatever its shape.
export function widest(rings: readonly Point[][]): { at: Point; room: number } {
  const { top, bottom } = boundsOf(rings);
  const y = (top + bottom) / 2 + 1e-6;
  const crossings: number[] = [];
  for (const ring of rings) {
    ring.forEach(([ax, ay], i) => {
      const [bx, by] = ring[(i + 1) % ring.length]!;
      if (ay > y !== by > y) crossings.push(ax + ((y - ay) / (by - ay)) * (bx - ax));
    });
  }
  crossings.sort((a, b) => a - b);
  let best = { at: rings[0]![0]!, room: 0 };
  for (let i = 0; i + 1 < crossings.length; i += 2) {
    const room = crossings[i + 1]! - crossings[i]!;
    if (room > best.room) best = { at: [(crossings[i]! + crossings[i + 1]!) / 2, y], room };
  }
  return best;
}
