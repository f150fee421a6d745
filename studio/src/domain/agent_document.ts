// Agents as mission files, plan files and requests have them (docs/contract.md).
import {
  type Agents,
  type Aircraft,
  isLimited,
  type MissionAgent,
  placeOf,
  usualAircraft,
  usualVehicle,
  vehiclesFirst,
} from "./agents";
import type { Cell } from "./geometry";

export interface AgentDocument {
  id: string;
  kind: MissionAgent["kind"];
  start: Cell;
  goal: Cell;
  speed?: number; // cells per unit of time
  radius?: number;
  corners?: string;
  ready_at?: number;
  approach?: readonly (readonly [number, number, number])[];
  breaches?: number;
  weight?: number;
  range?: number; // cells
  endurance?: number;
  reserve?: number;
  flown?: number; // by ready_at, in units of time
}

// `cell`: how large one is, in the unit of the agents' speeds.
export function agentDocuments(agents: Agents, cell: number): AgentDocument[] {
  return agents.map((agent) => {
    const { id, kind } = agent;
    const [start, goal] = [placeOf(agents, agent, "start"), placeOf(agents, agent, "goal")];
    const weight = agent.weight !== 1 && { weight: agent.weight };
    const common = { id, kind, start, goal, speed: agent.speed / cell, ...weight };
    if (agent.kind === "air") {
      return { ...common, ...(agent.breaches !== null && { breaches: agent.breaches }), ...batteryOf(agent, cell) };
    }
    return {
      ...common,
      radius: agent.radius,
      ...(agent.readyAt > 0 && { ready_at: agent.readyAt }),
      ...(agent.breaches > 0 && { breaches: agent.breaches }),
    };
  });
}

// A reserve of what never ends is none.
function batteryOf({ range, endurance, reserve }: Aircraft, cell: number): Partial<AgentDocument> {
  return {
    ...(range !== null && { range: range / cell }),
    ...(endurance !== null && { endurance }),
    ...(reserve > 0 && isLimited({ range, endurance }) && { reserve }),
  };
}

// What the units of a file are on the page.
export interface Scale {
  cell: number; // metres, or 1
  seconds: number; // of a unit of time
}

// An aircraft that starts or ends where the first vehicle does stays with it.
export function agentsOf(documents: readonly AgentDocument[], scale: Scale): Agents {
  const first = documents.find((agent) => agent.kind === "ground");
  const isApart = (place: Cell, other: Cell | undefined) => place.join() !== other?.join();
  const agents = documents.map((agent): MissionAgent => {
    const { id, kind, start, goal, weight = 1 } = agent;
    const speed = speedOf(agent, scale);
    if (kind === "ground") {
      const { radius = usualVehicle.radius, ready_at: readyAt = usualVehicle.readyAt } = agent;
      const { breaches = usualVehicle.breaches } = agent;
      return { kind, id, start, goal, speed, radius, readyAt: scaled(readyAt, scale.seconds), breaches, weight };
    }
    const places = { start: isApart(start, first?.start) ? start : null, goal: isApart(goal, first?.goal) ? goal : null };
    const { breaches = usualAircraft.breaches, range, endurance, reserve = usualAircraft.reserve } = agent;
    const limits = {
      range: range === undefined ? usualAircraft.range : scaled(range, scale.cell),
      endurance: endurance === undefined ? usualAircraft.endurance : scaled(endurance, scale.seconds),
    };
    return { kind, id, ...places, speed, breaches, ...limits, reserve, weight };
  });
  return vehiclesFirst(agents);
}

function speedOf({ speed = 1 }: Pick<AgentDocument, "speed">, { cell, seconds }: Scale): number {
  return scaled(speed, cell / seconds);
}

// As it was said: dividing by a factor and multiplying again leaves something in the last digits.
export function scaled(value: number, factor: number): number {
  return Number((value * factor).toPrecision(15));
}
