// A mission as the query of an address, and back. Defaults are left out.
import { type Agents, changed, isLimited, isSpecialist, ofPair, usualAircraft, usualVehicle } from "../domain/agents";
import { alsoText, parseAlso } from "../domain/also";
import type { Cell, Run } from "../domain/geometry";
import {
  type AtGoal,
  type Choice,
  defaults,
  type Ends,
  freshMission,
  type LayerName,
  type Mission,
  mostRemovals,
  wallCell,
  wallKey,
} from "../domain/mission";
import { filtersText, parseTagFilters } from "../domain/tag_filter";
import { parseZones, zonesText } from "../domain/zone";
import { decodeAgents, encodeAgents } from "./agent_code";
import { decodeRuns, encodeRuns } from "./run_code";
import { clipped } from "./run_set";

const marks: Choice[] = ["protect", "force", "exclude", "allow"];
const layerNames: LayerName[] = ["before", "after", "paper"];

// Numbers that are written as they are, and the least and greatest that make sense.
const numbers = [
  ["breach_time", "breachTime", 0, 1e6],
  ["breach_time_per_cell", "breachTimePerCell", 0, 1e6],
  ["rubble", "rubble", 0, 1e6],
  ["separation", "separation", 0, 32],
  ["unreached", "unreached", 0, 1e9],
  ["price", "price", 0, 1e6],
] as const;

// The same of the robot and the aircraft that a link need not name, which are the first and the second agent.
const numbersOfTwo = [
  ["ground_speed", 0, "speed", 1e-3, 1e4],
  ["air_speed", 1, "speed", 1e-3, 1e4],
  ["radius", 0, "radius", 0, 100],
] as const;

// `usualRadius`: of a vehicle on that map of which nobody says it; null where that is not known.
export function encodeLink(mission: Mission, width: number, usualRadius: number | null = usualVehicle.radius): string {
  const query: [string, string][] = [["map", mission.map], ...agentsInQuery(mission.agents, usualRadius)];
  query.push(["removals", String(mission.removals)]);
  if (mission.method !== defaults.method) query.push(["method", mission.method]);
  if (mission.objective !== defaults.objective) query.push(["objective", mission.objective]);
  if (mission.atGoal !== defaults.atGoal) query.push(["at_goal", mission.atGoal]);
  if (!mission.collisions) query.push(["collisions", "false"]);
  for (const [name, member] of numbers) if (mission[member] !== defaults[member]) query.push([name, String(mission[member])]);
  for (const mark of marks) {
    const keys = [...mission.marks].filter(([, has]) => has === mark).map(([key]) => key);
    if (keys.length > 0) query.push([mark, keys.map((key) => markText(key, width)).join()]);
  }
  if (mission.protectAll.length > 0) query.push(["protect_all", filtersText(mission.protectAll)]);
  if (Object.keys(mission.also).length > 0) query.push(["also", alsoText(mission.also)]);
  if (mission.walls.length > 0) query.push(["walls", encodeRuns(mission.walls)]);
  if (mission.erased.length > 0) query.push(["erased", encodeRuns(mission.erased)]);
  if (mission.zones.length > 0) query.push(["zones", zonesText(mission.zones)]);
  if (mission.layers.join() !== defaults.layers.join()) query.push(["show", mission.layers.join()]);
  if (!mission.bands) query.push(["bands", "false"]);
  if (mission.time !== null) query.push(["time", String(Math.round(mission.time * 100) / 100)]);
  // Commas and colons need no escape in a query, and are easier to read without.
  const escaped = (value: string) => encodeURIComponent(value).replaceAll("%2C", ",").replaceAll("%3A", ":");
  return query.map(([name, value]) => `${name}=${escaped(value)}`).join("&");
}

// By name. A robot and an aircraft of which no more is said take the words that a person can read and change.
export function agentsInQuery(agents: Agents, usualRadius: number | null = usualVehicle.radius): ReadonlyMap<string, string> {
  const two = ofPair(agents);
  if (!two || !isPlain(two)) {
    const { vehicles, aircraft } = encodeAgents(agents);
    return new Map([["vehicles", vehicles], ...(aircraft ? [["aircraft", aircraft] as const] : [])]);
  }
  const { ground, air } = two;
  const said = [
    ["start", ground.start, null],
    ["goal", ground.goal, null],
    ["air_start", air.start, usualAircraft.start],
    ["air_goal", air.goal, usualAircraft.goal],
    ["ground_speed", ground.speed, usualVehicle.speed],
    ["air_speed", air.speed, usualAircraft.speed],
    ["radius", ground.radius, usualRadius],
  ] as const;
  return new Map(said.flatMap(([name, value, usual]) => (value === usual ? [] : [[name, String(value)] as const])));
}

function isPlain({ ground, air }: NonNullable<ReturnType<typeof ofPair>>): boolean {
  const areUnnamed = ground.id === ground.kind && air.id === air.kind;
  const flies = air.breaches === usualAircraft.breaches && !isLimited(air) && air.reserve === usualAircraft.reserve;
  const fliesOnce = air.recharge === usualAircraft.recharge && air.bases.length === 0;
  if (isSpecialist(ground) || isSpecialist(air)) return false;
  return areUnnamed && ground.readyAt === usualVehicle.readyAt && flies && fliesOnce;
}

export interface Decoded {
  mission: Mission;
  complaints: string[]; // what the link says that cannot be, in words
}

export function mapOfLink(query: string): string | null {
  return new URLSearchParams(query).get("map");
}

// The name of the map's file where it was when it was sent.
export function fileOfLink(query: string): string | null {
  return new URLSearchParams(query).get("file");
}

type Take = <T>(name: string, read: (text: string) => T | null, keep: (value: T) => void) => void;

// What the link does not say, or says wrongly, is as usual; `ends` hold where it names no place.
export function decodeLink(query: string, map: string, ends: Ends, width: number, height: number): Decoded {
  const given = new URLSearchParams(query);
  const complaints: string[] = [];
  const mission = freshMission(map, ends);
  const take: Take = (name, read, keep) => {
    const text = given.get(name);
    if (text === null) return;
    const value = attempt(() => read(text));
    if (value === null) complaints.push(`“${name}=${shortened(text)}” in the link cannot be read`);
    else keep(value);
  };

  if (given.has("vehicles")) {
    take(
      "vehicles",
      (vehicles) => decodeAgents({ vehicles, aircraft: given.get("aircraft") ?? "" }, { width, height }),
      (agents) => (mission.agents = agents),
    );
  } else {
    takeTwo(mission, take, width, height);
  }
  take(
    "at_goal",
    (text) => oneOf<AtGoal>(["stay", "leave"], text),
    (value) => (mission.atGoal = value),
  );
  take(
    "collisions",
    (text) => oneOf(["true", "false"] as const, text),
    (value) => (mission.collisions = value === "true"),
  );
  take("removals", removalsOf, (value) => (mission.removals = value));
  take(
    "method",
    (text) => oneOf(["exact", "paper"] as const, text),
    (value) => (mission.method = value),
  );
  take(
    "objective",
    (text) => oneOf(["makespan", "ground-makespan", "flowtime"] as const, text),
    (value) => (mission.objective = value),
  );
  for (const [name, member, least, most] of numbers) {
    take(
      name,
      (text) => numberOf(text, least, most),
      (value) => (mission[member] = value),
    );
  }
  const has = new Map<number, Choice>();
  for (const mark of marks) {
    take(
      mark,
      (text) => keysOf(text, width, height),
      (keys) => keys.forEach((key) => has.set(key, mark)),
    );
  }
  mission.marks = has;
  take("also", parseAlso, (also) => (mission.also = also));
  take("protect_all", parseTagFilters, (filters) => (mission.protectAll = filters));
  for (const name of ["walls", "erased"] as const) {
    take(
      name,
      (text): Run[] => clipped(decodeRuns(text), width, height),
      (runs) => (mission[name] = runs),
    );
  }
  take("zones", parseZones, (zones) => (mission.zones = zones));
  take("show", layersOf, (layers) => (mission.layers = layers));
  take(
    "bands",
    (text) => oneOf(["true", "false"] as const, text),
    (text) => (mission.bands = text === "true"),
  );
  take(
    "time",
    (text) => numberOf(text, 0, 1e9),
    (time) => (mission.time = time),
  );
  return { mission, complaints };
}

function takeTwo(mission: Mission, take: Take, width: number, height: number): void {
  const places = [["start", 0, "start"], ["goal", 0, "goal"], ["air_start", 1, "start"], ["air_goal", 1, "goal"]] as const;
  for (const [name, agent, end] of places) {
    take(
      name,
      (text) => cellOf(text, width, height),
      (cell) => (mission.agents = changed(mission.agents, agent, { [end]: cell })),
    );
  }
  for (const [name, agent, member, least, most] of numbersOfTwo) {
    take(
      name,
      (text) => numberOf(text, least, most),
      (value) => (mission.agents = changed(mission.agents, agent, { [member]: value })),
    );
  }
}

function attempt<T>(read: () => T | null): T | null {
  try {
    return read();
  } catch {
    return null;
  }
}

function shortened(text: string): string {
  return text.length > 30 ? `${text.slice(0, 30)}…` : text;
}

function markText(key: number, width: number): string {
  return key < 0 ? `wall.${wallCell(key, width).join(".")}` : String(key);
}

function keysOf(text: string, width: number, height: number): number[] | null {
  const keys = text.split(",").map((part) => {
    const wall = /^wall\.(\d{1,6})\.(\d{1,6})$/.exec(part);
    const cell = wall && cellOf(`${wall[1]},${wall[2]}`, width, height);
    if (cell) return wallKey(cell, width);
    return /^[1-9]\d{0,8}$/.test(part) ? Number(part) : null;
  });
  return keys.includes(null) ? null : (keys as number[]);
}

function cellOf(text: string, width: number, height: number): Cell | null {
  const parts = /^(\d{1,6}),(\d{1,6})$/.exec(text);
  if (!parts) return null;
  const cell: Cell = [Number(parts[1]), Number(parts[2])];
  return cell[0] < width && cell[1] < height ? cell : null;
}

function removalsOf(text: string): number | "auto" | null {
  if (text === "auto") return "auto";
  return /^\d$/.test(text) && Number(text) <= mostRemovals ? Number(text) : null;
}

function numberOf(text: string, least: number, most: number): number | null {
  const value = Number(text);
  return text.trim() !== "" && value >= least && value <= most ? value : null;
}

function oneOf<T extends string>(words: readonly T[], text: string): T | null {
  return words.find((word) => word === text) ?? null;
}

function layersOf(text: string): LayerName[] | null {
  if (text === "") return [];
  const named = text.split(",").map((word) => oneOf(layerNames, word));
  return named.includes(null) ? null : layerNames.filter((layer) => named.includes(layer));
}
