// Zones: areas that aircraft, or vehicles, keep out of (docs/crews.md).
import type { Point } from "./geometry";
import { plainName } from "./plain_name";

export type ZoneKind = "no_fly" | "keep_out";

export interface Zone {
  kind: ZoneKind;
  name: string; // may be empty
  agents: readonly string[]; // whom it holds for; none: all of its kind
  rings: readonly (readonly Point[])[]; // the outline, then holes; the first corner is not repeated
  from?: number; // it holds between these, in units of time; left out: always
  until?: number;
}

export const zoneKinds: readonly ZoneKind[] = ["no_fly", "keep_out"];

// As mission files have them: GeoJSON, in cells.
export interface ZoneCollection {
  type: "FeatureCollection";
  crs: "cells";
  features: {
    type: "Feature";
    properties: { zone: ZoneKind; name?: string; agents?: string[]; from?: number; until?: number };
    geometry: { type: "Polygon"; coordinates: Point[][] };
  }[];
}

export function zoneCollection(zones: readonly Zone[]): ZoneCollection {
  return {
    type: "FeatureCollection",
    crs: "cells",
    features: zones.map(({ kind, name, agents, rings, from, until }) => ({
      type: "Feature",
      properties: { zone: kind, ...(name !== "" && { name }), ...(agents.length > 0 && { agents: [...agents] }), ...windowOf(from, until) },
      geometry: { type: "Polygon", coordinates: rings.map((ring) => [...ring, ring[0]!]) },
    })),
  };
}

// No time is none of its members.
export function windowOf(from?: number, until?: number): Pick<Zone, "from" | "until"> {
  return { ...(from !== undefined && { from }), ...(until !== undefined && { until }) };
}

// A zone of a plan's mission, counted from 1, as a sentence names it.
export function zoneName(mission: { rules?: Record<string, unknown> } | undefined, zone: number): string {
  const zones = mission?.rules?.["zones"] as Partial<ZoneCollection> | undefined;
  const name = zones?.features?.[zone - 1]?.properties.name;
  return name ? `the zone ${plainName(name)}` : `zone ${zone}`;
}

// With times in another unit, each so many times as long.
export function withTimes(zones: readonly Zone[], scale: (time: number) => number): Zone[] {
  const timed = (time?: number) => (time === undefined ? undefined : scale(time));
  return zones.map((zone) => ({ ...zone, ...windowOf(timed(zone.from), timed(zone.until)) }));
}

// Whether corners are cells; else they are longitude and latitude.
export function isInCells(value: unknown): boolean {
  return (value as Partial<ZoneCollection> | null)?.crs === "cells";
}

// Null where it is no such collection. `cellAt`: of a longitude and latitude, for collections that are not in cells.
export function zonesOf(value: unknown, cellAt: ((lonLat: Point) => Point) | null = null): Zone[] | null {
  const { features } = (value ?? {}) as Partial<ZoneCollection>;
  const placed = isInCells(value) ? (corner: Point) => corner : cellAt;
  if (!placed || !Array.isArray(features)) return null;
  const zones = features.map((feature: unknown) => zonesOfFeature(feature as Feature));
  if (zones.includes(null)) return null;
  return zones.flatMap((some) => some ?? []).map((zone) => ({ ...zone, rings: zone.rings.map((ring) => ring.map(placed)) }));
}

type Feature = { properties?: Record<string, unknown>; geometry?: { type?: string; coordinates?: unknown } } | null;

// One for each of its polygons.
function zonesOfFeature(feature: Feature): Zone[] | null {
  const { zone, name = "", agents = [], from, until } = feature?.properties ?? {};
  const { type, coordinates } = feature?.geometry ?? {};
  const polygons = type === "MultiPolygon" ? coordinates : type === "Polygon" ? [coordinates] : null;
  const isText = (value: unknown) => typeof value === "string";
  const isTime = (value: unknown) => value === undefined || (typeof value === "number" && value >= 0);
  if (!isTime(from) || !isTime(until)) return null;
  const isNamed = isText(name) && Array.isArray(agents) && agents.every(isText);
  if (!zoneKinds.includes(zone as ZoneKind) || !isNamed || !Array.isArray(polygons) || !polygons.every(isPolygon)) return null;
  const common = { kind: zone as ZoneKind, name: name as string, agents: agents as string[], ...windowOf(from as number, until as number) };
  return polygons.map((polygon: Point[][]) => ({ ...common, rings: polygon.map(opened) }));
}

function isPolygon(value: unknown): boolean {
  const isPoint = (point: unknown) => Array.isArray(point) && typeof point[0] === "number" && typeof point[1] === "number";
  return Array.isArray(value) && value.every((ring) => Array.isArray(ring) && ring.length > 0 && ring.every(isPoint));
}

function opened(ring: Point[]): Point[] {
  const [first, last] = [ring[0], ring.at(-1)];
  const isClosed = ring.length > 1 && first?.[0] === last?.[0] && first?.[1] === last?.[1];
  return (isClosed ? ring.slice(0, -1) : ring).map(([x, y]): Point => [x!, y!]);
}

// In links: no_fly:helipad::250,60,330,60,345,170 and so on, one behind the other with semicolons, holes behind a slash;
// at its end, where it has times, :10,20.
export function zonesText(zones: readonly Zone[]): string {
  const escaped = (text: string) => encodeURIComponent(text);
  return zones
    .map(({ kind, name, agents, rings, from, until }) => {
      const times = from === undefined && until === undefined ? [] : [`${from ?? ""},${until ?? ""}`];
      return [kind, escaped(name), agents.map(escaped).join(), rings.map(ringText).join("/"), ...times].join(":");
    })
    .join(";");
}

function ringText(ring: readonly Point[]): string {
  return ring.map(([x, y]) => `${rounded(x)},${rounded(y)}`).join();
}

// Null where the text is none.
export function parseZones(text: string): Zone[] | null {
  const zones = text.split(";").map((part): Zone | null => {
    const [kind, name, agents, rings, times = ""] = part.split(":");
    const [from, until] = times.split(",").map((time) => (time === "" ? undefined : Number(time)));
    const points = (rings ?? "").split("/").map(parseRing);
    if (!zoneKinds.includes(kind as ZoneKind) || name === undefined || agents === undefined || points.includes(null)) return null;
    if ([from, until].some((time) => time !== undefined && !(time >= 0))) return null;
    return {
      kind: kind as ZoneKind,
      name: decodeURIComponent(name),
      agents: agents === "" ? [] : agents.split(",").map(decodeURIComponent),
      rings: points as Point[][],
      ...windowOf(from, until),
    };
  });
  return zones.includes(null) ? null : (zones as Zone[]);
}

const farthest = 65536; // cells; of the command

function parseRing(text: string): Point[] | null {
  const numbers = text.split(",").map((one) => (one.trim() === "" ? NaN : Number(one)));
  const areRight = numbers.length >= 6 && numbers.length % 2 === 0 && numbers.every((one) => Math.abs(one) <= farthest);
  return areRight ? Array.from({ length: numbers.length / 2 }, (_, i): Point => [numbers[2 * i]!, numbers[2 * i + 1]!]) : null;
}

function rounded(value: number): number {
  return Math.round(value * 1e4) / 1e4;
}

// What is wrong with the corners of a zone that somebody draws, in words; null: nothing.
export function faultOfRing(ring: readonly Point[]): string | null {
  if (ring.length < 3) return "A zone has three corners at least.";
  const side = (i: number) => [ring[i % ring.length]!, ring[(i + 1) % ring.length]!] as const;
  for (let i = 0; i < ring.length; ++i) {
    for (let k = i + 1; k < ring.length; ++k) {
      const areNeighbours = k === i + 1 || (i === 0 && k === ring.length - 1);
      if (areNeighbours ? isSpike(ring, k === i + 1 ? k : 0) : meet(side(i), side(k))) {
        return "The sides of a zone may not cross or touch. Draw it again, corner by corner.";
      }
    }
  }
  return null;
}

function turn([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point): number {
  return Math.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
}

function isBetween(a: Point, b: Point, p: Point): boolean {
  const within = (i: 0 | 1) => Math.min(a[i], b[i]) <= p[i] && p[i] <= Math.max(a[i], b[i]);
  return within(0) && within(1);
}

type Side = readonly [Point, Point];

function meet([a, b]: Side, [c, d]: Side): boolean {
  const turns = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)] as const;
  if (turns[0] * turns[1] < 0 && turns[2] * turns[3] < 0) return true;
  const touches = [[turns[0], a, b, c], [turns[1], a, b, d], [turns[2], c, d, a], [turns[3], c, d, b]] as const;
  return touches.some(([turned, from, to, p]) => turned === 0 && isBetween(from, to, p));
}

// Whether the way turns back at a corner on itself.
function isSpike(ring: readonly Point[], at: number): boolean {
  const [before, here, after] = [ring.at(at - 1)!, ring[at]!, ring[(at + 1) % ring.length]!];
  if (turn(before, here, after) !== 0) return false;
  return (before[0] - here[0]) * (after[0] - here[0]) + (before[1] - here[1]) * (after[1] - here[1]) > 0;
}

// Where an agent has another name, or none any more: a zone for nobody is none.
export function renamedIn(zones: readonly Zone[], id: string, now: string | null): Zone[] {
  return zones.flatMap((zone) => {
    if (!zone.agents.includes(id)) return [zone];
    const agents = zone.agents.flatMap((one) => (one !== id ? [one] : now === null ? [] : [now]));
    return agents.length === 0 ? [] : [{ ...zone, agents }];
  });
}

// "from 10 until 20"; empty where it holds always.
export function windowWords({ from, until }: Pick<Zone, "from" | "until">): string {
  return [from === undefined ? "" : `from ${from}`, until === undefined ? "" : `until ${until}`].filter((word) => word !== "").join(" ");
}

// "No-fly zone helipad", "Keep-out zone".
export function zoneWords({ kind, name }: Pick<Zone, "kind" | "name">): string {
  const what = kind === "no_fly" ? "No-fly zone" : "Keep-out zone";
  return name === "" ? what : `${what} ${name}`;
}
