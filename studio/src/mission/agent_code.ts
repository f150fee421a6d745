// The agents of a team as text for an address: x,y,x,y,speed,... each, with what is as usual left out at the end.
import { mostReach } from "../domain/abilities";
import {
  type Aircraft,
  type Agents,
  aircraftOf,
  type MissionAgent,
  mostBases,
  usualAircraft,
  usualId,
  usualVehicle,
  type Vehicle,
  vehiclesOf,
} from "../domain/agents";
import type { Cell, Size } from "../domain/geometry";
import { abilitiesIn, abilityTexts } from "./ability_code";

export interface AgentCodes {
  vehicles: string;
  aircraft: string; // empty: there are none
}

const between = "~"; // agents; commas stand between what is said of one
const inBases = "."; // between columns and rows
const mostAgents = 10_000;
const mostReserve = 0.9999; // a share
const mostWeight = 1e9;

const usualTexts = abilityTexts(usualVehicle);

export function encodeAgents(agents: Agents): AgentCodes {
  const vehicles = vehiclesOf(agents).map(({ start, goal, speed, radius, readyAt, id, breaches, weight, reach, ...agent }, i) => {
    const { speed: usualSpeed, radius: usualRadius, readyAt: usualReady, breaches: usualBreaches } = usualVehicle;
    const first = ["", "", "", "", usualSpeed, usualRadius, usualReady, usualId("ground", i), usualBreaches, 1];
    const usual = [...first, ...usualTexts, usualVehicle.reach];
    return fields([...start, ...goal, speed, radius, readyAt, id, breaches, weight, ...abilityTexts(agent), reach], usual);
  });
  const aircraft = aircraftOf(agents).map(({ start, goal, speed, breaches, id, ...agent }, i) => {
    const { range, endurance, reserve, weight, recharge, bases } = agent;
    const first = ["", "", "", "", usualAircraft.speed, "", usualId("air", i), "", "", usualAircraft.reserve, 1, "", ""];
    const usual = [...first, ...usualTexts];
    const places = [...(start ?? ["", ""]), ...(goal ?? ["", ""])];
    const battery = [range ?? "", endurance ?? "", reserve];
    const recharged = [recharge ?? "", bases.flat().join(inBases)];
    return fields([...places, speed, breaches ?? "", id, ...battery, weight, ...recharged, ...abilityTexts(agent)], usual);
  });
  return { vehicles: vehicles.join(between), aircraft: aircraft.join(between) };
}

// Null where the text is none. Vehicles come first.
export function decodeAgents({ vehicles, aircraft }: AgentCodes, map: Size): Agents | null {
  const split = (text: string) => (text === "" ? [] : text.split(between));
  const codes = [split(vehicles), split(aircraft)] as const;
  if (codes[0].length === 0 || codes[0].length + codes[1].length > mostAgents) return null;
  const agents: (MissionAgent | null)[] = [
    ...codes[0].map((code, i) => vehicleOf(code.split(","), i, map)),
    ...codes[1].map((code, i) => aircraftIn(code.split(","), i, map)),
  ];
  const known = agents.filter((agent) => agent !== null);
  const ids = new Set(known.map((agent) => agent.id));
  return known.length === agents.length && ids.size === agents.length ? known : null;
}

function fields(said: (string | number)[], usual: (string | number)[]): string {
  const texts = said.map((value, i) => (value === usual[i] ? "" : escaped(String(value))));
  while (texts.at(-1) === "" && texts.length > 2) texts.pop(); // an agent is never an empty text
  return texts.join();
}

function escaped(text: string): string {
  return encodeURIComponent(text).replaceAll(between, "%7E");
}

function vehicleOf(texts: string[], index: number, map: Size): Vehicle | null {
  const [start, goal] = [cellOf(texts, 0, map), cellOf(texts, 2, map)];
  const speed = numberOf(texts[4], usualVehicle.speed, 1e-3, 1e4);
  const radius = numberOf(texts[5], usualVehicle.radius, 0, 32);
  const readyAt = numberOf(texts[6], usualVehicle.readyAt, 0, 1e6);
  const breaches = texts[8] ? wholeOf(texts[8]) : usualVehicle.breaches;
  const weight = numberOf(texts[9], 1, 0, mostWeight);
  if (!start || !goal || speed === null || radius === null || readyAt === null) return null;
  const [abilities, reach] = [abilitiesIn(texts.slice(10, 14)), numberOf(texts[14], usualVehicle.reach, 0, mostReach)];
  if (breaches === undefined || weight === null || !abilities || reach === null) return null;
  const id = idOf(texts[7], usualId("ground", index));
  return { kind: "ground", id, start, goal, speed, radius, readyAt, breaches, reach, ...abilities, weight };
}

function aircraftIn(texts: string[], index: number, map: Size): Aircraft | null {
  const [start, goal] = [cellOf(texts, 0, map), cellOf(texts, 2, map)];
  const isWrong = (cell: Cell | null, from: number) => !cell && Boolean(texts[from] || texts[from + 1]);
  const speed = numberOf(texts[4], usualAircraft.speed, 1e-3, 1e4);
  const breaches = texts[5] ? wholeOf(texts[5]) : usualAircraft.breaches;
  const [range, endurance] = [limitOf(texts[7]), limitOf(texts[8])];
  const reserve = numberOf(texts[9], usualAircraft.reserve, 0, mostReserve);
  if (isWrong(start, 0) || isWrong(goal, 2) || speed === null || breaches === undefined) return null;
  const weight = numberOf(texts[10], 1, 0, mostWeight);
  if (range === undefined || endurance === undefined || reserve === null || weight === null) return null;
  const [recharge, bases] = [limitOf(texts[11]), basesIn(texts[12], map)];
  const abilities = abilitiesIn(texts.slice(13, 17));
  if (recharge === undefined || bases === null || !abilities) return null;
  const id = idOf(texts[6], usualId("air", index));
  return { kind: "air", id, start, goal, speed, breaches, range, endurance, reserve, recharge, bases, ...abilities, weight };
}

function cellOf(texts: string[], from: number, map: Size): Cell | null {
  const [x, y] = [wholeOf(texts[from]), wholeOf(texts[from + 1])];
  return x !== undefined && y !== undefined && x < map.width && y < map.height ? [x, y] : null;
}

function wholeOf(text: string | undefined): number | undefined {
  return /^\d{1,6}$/.test(text ?? "") ? Number(text) : undefined;
}

function numberOf(text: string | undefined, usual: number, least: number, most: number): number | null {
  if (!text) return usual;
  const value = Number(text);
  return value >= least && value <= most ? value : null;
}

function basesIn(text: string | undefined, map: Size): Cell[] | null {
  const texts = text ? text.split(inBases) : [];
  const cells = Array.from({ length: Math.ceil(texts.length / 2) }, (_, i) => cellOf(texts, 2 * i, map));
  const known = cells.filter((cell) => cell !== null);
  return known.length === cells.length && cells.length <= mostBases ? known : null;
}

// Of a battery: null where there is none, undefined where the text is no limit.
function limitOf(text: string | undefined): number | null | undefined {
  return text ? (numberOf(text, 0, 1e-3, 1e9) ?? undefined) : null;
}

function idOf(text: string | undefined, usual: string): string {
  return text ? decodeURIComponent(text) : usual;
}
