// Who a mission is about: any number of vehicles, and aircraft that open the way for them.
import { type Abilities, hasOwnAbilities, usualAbilities } from "./abilities";
import type { Cell } from "./geometry";

export type End = "start" | "goal";

// Speeds are metres a second, times seconds: cells and steps where the map has no scale.
export interface Vehicle extends Abilities {
  kind: "ground";
  id: string;
  start: Cell;
  goal: Cell;
  speed: number;
  radius: number; // cells
  readyAt: number; // it stands at its start until then
  breaches: number; // how many obstacles it may breach itself, for itself or for others
  reach: number; // cells between it and what it breaches for others, at most
  weight: number; // what its arrival counts in the sum of arrivals
}

// A place that is null is that of the first vehicle.
export interface Aircraft extends Abilities {
  kind: "air";
  id: string;
  start: Cell | null;
  goal: Cell | null;
  speed: number;
  breaches: number | null; // how many obstacles it may breach; null: any number
  range: number | null; // metres or cells from take-off to landing; null: any
  endurance: number | null; // the same as a time
  reserve: number; // the share of both that is not planned with
  recharge: number | null; // how long it stands at a base until its battery is full; null: it flies once
  bases: readonly Cell[]; // none: its start and its goal
  weight: number;
}

export type MissionAgent = Vehicle | Aircraft;
export type Agents = readonly MissionAgent[]; // at least one is a vehicle

export const usualVehicle = { speed: 1, radius: 0.5, readyAt: 0, breaches: 0, reach: 1, ...usualAbilities, weight: 1 };
const noBattery = { range: null, endurance: null, reserve: 0, recharge: null, bases: [] as readonly Cell[] };

export const mostBases = 100; // of one aircraft
export const usualAircraft = { start: null, goal: null, speed: 1, breaches: null, ...noBattery, ...usualAbilities, weight: 1 };

// One robot and one aircraft, which starts and ends with it.
export function pair(start: Cell, goal: Cell, radius = usualVehicle.radius): Agents {
  return [
    { kind: "ground", id: "ground", start, goal, ...usualVehicle, radius },
    { kind: "air", id: "air", ...usualAircraft },
  ];
}

// One vehicle that breaches nothing and one aircraft, which count alike: the mission of the paper, and of whoever has added
// nobody.
type PairAgent = Pick<MissionAgent, "kind"> & { weight?: number; breaches?: number | null };
export function isPair(agents: readonly PairAgent[]): boolean {
  const alike = agents.every(({ weight = 1 }) => weight === 1);
  return agents.length === 2 && agents[0]!.kind !== agents[1]!.kind && alike && !agents.some(breachesFromTheGround);
}

// Whether it may open the way, for itself or for others.
export function mayBreach(agent: MissionAgent): boolean {
  return agent.breaches !== 0;
}

// Whether anything is said of what an agent opens and how.
export function isSpecialist(agent: MissionAgent): boolean {
  return hasOwnAbilities(agent) || (agent.kind === "ground" && agent.reach !== usualVehicle.reach);
}

function breachesFromTheGround({ kind, breaches }: PairAgent): boolean {
  return kind === "ground" && (breaches ?? 0) > 0;
}

// What of a mission says who arrives, and what that counts.
export interface Counted {
  agents: Agents;
  unreached: number | null;
}

// The paper's method knows no others.
export function hasPaperMethod({ agents, unreached }: Counted): boolean {
  return isPair(agents) && unreached === null;
}

// Whether anybody may open the way: without them nothing is removed.
export function canOpen(agents: Agents): boolean {
  return aircraftOf(agents).length > 0 || agents.some(breachesFromTheGround);
}

// Whether its battery ends.
export function isLimited({ range, endurance }: Pick<Aircraft, "range" | "endurance">): boolean {
  return range !== null || endurance !== null;
}

// Whether it flies again with a full battery. One without an end needs no more.
export function canRecharge({ recharge, ...battery }: Pick<Aircraft, "range" | "endurance" | "recharge">): boolean {
  return recharge !== null && isLimited(battery);
}

// Where aircraft recharge beside their starts and goals, each place once.
export function basesOf(agents: Agents): Cell[] {
  const all = aircraftOf(agents).filter(canRecharge).flatMap(({ bases }) => bases);
  return [...new Map(all.map((cell) => [cell.join(), cell])).values()];
}

export function limitsFlights(agents: Agents): boolean {
  return aircraftOf(agents).some(isLimited);
}

// Whether aircraft open the way for one vehicle: then nobody gets in anybody's way, and plans are fast.
export function drivesAlone({ agents, unreached }: Counted): boolean {
  const alike = unreached === null && agents.every(({ weight }) => weight === 1);
  const clears = agents.some(breachesFromTheGround);
  return alike && !clears && vehiclesOf(agents).length === 1 && aircraftOf(agents).length > 0;
}

export function vehiclesOf(agents: Agents): Vehicle[] {
  return agents.filter((agent) => agent.kind === "ground");
}

export function aircraftOf(agents: Agents): Aircraft[] {
  return agents.filter((agent) => agent.kind === "air");
}

// The vehicle and the aircraft of a pair.
export function ofPair(agents: Agents): { ground: Vehicle; air: Aircraft } | null {
  return isPair(agents) ? { ground: vehiclesOf(agents)[0]!, air: aircraftOf(agents)[0]! } : null;
}

// A marker to drag: one end of the way of the agent at a place of the list.
export interface Handle {
  agent: number;
  end: End;
}

export function handlesOf(agents: Agents): Handle[] {
  return agents.flatMap((_, agent): Handle[] => [
    { agent, end: "start" },
    { agent, end: "goal" },
  ]);
}

export function isSameHandle(a: Handle | null, b: Handle | null): boolean {
  return a?.agent === b?.agent && a?.end === b?.end;
}

export function placeOf(agents: Agents, agent: MissionAgent, end: End): Cell {
  return agent[end] ?? vehiclesOf(agents)[0]![end];
}

export function cellOf(agents: Agents, { agent, end }: Handle): Cell {
  return placeOf(agents, agents[agent]!, end);
}

export function changed(agents: Agents, index: number, part: Partial<Vehicle> | Partial<Aircraft>): Agents {
  return agents.map((agent, i) => (i === index ? ({ ...agent, ...part } as MissionAgent) : agent));
}

// Names that nobody has to think of: vehicles are numbered, aircraft called air1, air2, ...
export function usualId(kind: MissionAgent["kind"], index: number): string {
  return kind === "ground" ? String(index + 1) : `air${index + 1}`;
}

export function freshId(agents: Agents, kind: MissionAgent["kind"]): string {
  const taken = new Set(agents.map((agent) => agent.id));
  for (let i = 0; ; ++i) if (!taken.has(usualId(kind, i))) return usualId(kind, i);
}

export function vehiclesFirst(agents: Agents): Agents {
  return [...vehiclesOf(agents), ...aircraftOf(agents)];
}

// With one agent more. Whoever is called by its kind gets a name that tells it from others, unless they are a pair again.
// An aircraft that joins a robot which is alone takes its breaches over.
export function joined(agents: Agents, one: MissionAgent): Agents {
  const { breaches, reach } = usualVehicle;
  const isTakenOver = agents.length === 1 && one.kind === "air";
  const others = agents.map((agent) =>
    agent.kind === "ground" && isTakenOver ? { ...agent, breaches, reach, ...usualAbilities } : agent,
  );
  const named = others.map((agent) => (agent.id === agent.kind ? { ...agent, id: freshId(agents, agent.kind) } : agent));
  const all = vehiclesFirst([...named, { ...one, id: freshId(named, one.kind) }]);
  return isPair(all) ? vehiclesFirst([...others, { ...one, id: one.kind }]) : all;
}

// The vehicle of a pair without its aircraft: it breaks what is in its way itself.
export function onItsOwn(agents: Agents, breaches: number): Agents {
  return vehiclesOf(agents).map((vehicle) => ({ ...vehicle, breaches }));
}

// Without one. Those of a pair that is left are called by their kinds, unless somebody named them.
export function left(agents: Agents, index: number): Agents {
  const rest = agents.filter((_, i) => i !== index);
  const usual = /^(air)?\d+$/;
  return isPair(rest) ? rest.map((agent) => (usual.test(agent.id) ? { ...agent, id: agent.kind } : agent)) : rest;
}

// How many colours tell agents of one kind from each other; further ones use them again.
export const colourCount = { ground: 10, air: 4 };

export interface AgentLook {
  kind: MissionAgent["kind"];
  colour: number; // 0 to colourCount - 1
  round: number; // how often all colours have been used by those before
}

// By id. Nobody of a pair needs a colour of its own.
export function looksOf(agents: readonly { id: string; kind: MissionAgent["kind"] }[]): ReadonlyMap<string, AgentLook> {
  const count = { ground: 0, air: 0 };
  const looks = new Map<string, AgentLook>();
  if (isPair(agents)) return looks;
  for (const { id, kind } of agents) {
    const index = count[kind]++;
    const colours = colourCount[kind];
    looks.set(id, { kind, colour: index % colours, round: Math.floor(index / colours) });
  }
  return looks;
}
