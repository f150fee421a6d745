// Agents as mission files, plan files and requests have them (docs/contract.md).
import { abilitiesDocument, type AbilitiesDocument, abilitiesOf } from "./abilities";
import {
  type Agents,
  type Aircraft,
  canRecharge,
  isLimited,
  type MissionAgent,
  placeOf,
  usualAircraft,
  usualVehicle,
  vehiclesFirst,
} from "./agents";
import type { Cell } from "./geometry";
import { type Scale, scaled } from "./units";

export interface AgentDocument extends AbilitiesDocument {
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
  reach?: number; // cells
  weight?: number;
  range?: number; // cells
  endurance?: number;
  reserve?: number;
  recharge?: number; // units of time
  bases?: readonly Cell[];
  flown?: number; // by ready_at, in units of time
}

// `cell`: how large one is, in the unit of the agents' speeds.
export function agentDocuments(agents: Agents, cell: number): AgentDocument[] {
  return agents.map((agent) => {
    const { id, kind } = agent;
    const [start, goal] = [placeOf(agents, agent, "start"), placeOf(agents, agent, "goal")];
    const weight = agent.weight !== 1 && { weight: agent.weight };
    const common = { id, kind, start, goal, speed: agent.speed / cell, ...weight, ...abilitiesDocument(agent, cell) };
    if (agent.kind === "air") {
      return { ...common, ...(agent.breaches !== null && { breaches: agent.breaches }), ...batteryOf(agent, cell) };
    }
    return {
      ...common,
      radius: agent.radius,
      ...(agent.readyAt > 0 && { ready_at: agent.readyAt }),
      ...(agent.breaches > 0 && { breaches: agent.breaches }),
      ...(agent.reach !== usualVehicle.reach && { reach: agent.reach }),
    };
  });
}

// A reserve of what never ends is none, and nobody lands to recharge it.
function batteryOf(aircraft: Aircraft, cell: number): Partial<AgentDocument> {
  const { range, endurance, reserve, recharge, bases } = aircraft;
  return {
    ...(range !== null && { range: range / cell }),
    ...(endurance !== null && { endurance }),
    ...(reserve > 0 && isLimited(aircraft) && { reserve }),
    ...(recharge !== null && canRecharge(aircraft) && { recharge, ...(bases.length > 0 && { bases }) }),
  };
}

// An aircraft that starts or ends where the first vehicle does stays with it.
export function agentsOf(documents: readonly AgentDocument[], scale: Scale): Agents {
  const first = documents.find((agent) => agent.kind === "ground");
  const isApart = (place: Cell, other: Cell | undefined) => place.join() !== other?.join();
  const agents = documents.map((agent): MissionAgent => {
    const { id, kind, start, goal, weight = 1 } = agent;
    const speed = speedOf(agent, scale);
    const abilities = abilitiesOf(agent, scale);
    if (kind === "ground") {
      const { radius = usualVehicle.radius, ready_at: readyAt = usualVehicle.readyAt } = agent;
      const { breaches = usualVehicle.breaches, reach = usualVehicle.reach } = agent;
      return { kind, id, start, goal, speed, radius, readyAt: scaled(readyAt, scale.seconds), breaches, reach, ...abilities, weight };
    }
    const places = { start: isApart(start, first?.start) ? start : null, goal: isApart(goal, first?.goal) ? goal : null };
    const { breaches = usualAircraft.breaches, range, endurance, reserve = usualAircraft.reserve, recharge } = agent;
    const limits = {
      range: range === undefined ? usualAircraft.range : scaled(range, scale.cell),
      endurance: endurance === undefined ? usualAircraft.endurance : scaled(endurance, scale.seconds),
      recharge: recharge === undefined ? usualAircraft.recharge : scaled(recharge, scale.seconds),
    };
    const { bases = usualAircraft.bases } = agent;
    return { kind, id, ...places, speed, breaches, ...limits, reserve, bases, ...abilities, weight };
  });
  return vehiclesFirst(agents);
}

function speedOf({ speed = 1 }: Pick<AgentDocument, "speed">, { cell, seconds }: Scale): number {
  return scaled(speed, cell / seconds);
}
