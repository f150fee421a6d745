// The mission that a plan file answers, as far as the page can ask it.
import type { Cell } from "../domain/geometry";
import { defaults, type Mark, type Markers, type Mission, mostRemovals } from "../domain/mission";
import type { Agent, Plan } from "../domain/plan";
import { isObject } from "./mission_file";

export function isPlan(value: unknown): value is Plan {
  if (!isObject(value) || value.format !== "waybreaker-plan/1") return false;
  const { agents, map, options } = value;
  if (!Array.isArray(agents) || !isObject(map) || !isObject(options)) return false;
  const isPlaced = (agent: unknown) => isObject(agent) && Array.isArray(agent.start) && Array.isArray(agent.goal);
  return agents.every(isPlaced) && typeof map.source === "string" && typeof map.digest === "string";
}

// Under which names a service may hold the map: that of a file, or that of something sent.
export function mapsOfPlan({ map }: Plan): string[] {
  const sent = `upload-${map.digest.replace("sha256:", "").slice(0, 16)}`;
  return [map.source, sent, `${sent}-8`];
}

// Null where there was no plan: such a file does not say where from and where to.
export function missionOfPlan(plan: Plan, map: string): Mission | null {
  const ground = plan.agents.find((agent) => agent.kind === "ground");
  const air = plan.agents.find((agent) => agent.kind === "air");
  if (!ground) return null;
  const { options } = plan;
  const marks = (ids: number[] | undefined, mark: Mark) => (ids ?? []).map((id): [number, Mark] => [id, mark]);
  return {
    ...defaults,
    map,
    markers: markersOf(ground, air),
    removals: Math.min(options.removals ?? defaults.removals, mostRemovals),
    method: options.select === "hits" ? "paper" : "exact",
    objective: options.objective ?? defaults.objective,
    groundSpeed: ground.speed * plan.map.cell_size,
    airSpeed: (air?.speed ?? 1) * plan.map.cell_size,
    breachTime: options.breach_time ?? 0,
    breachTimePerCell: options.breach_time_per_cell ?? 0,
    radius: options.radius ?? defaults.radius,
    marks: new Map([...marks(options.protect, "protect"), ...marks(options.force, "force")]),
  };
}

export function markersOf(ground: Agent, air: Agent | undefined): Markers {
  return {
    start: ground.start,
    goal: ground.goal,
    ...(air && !isSame(air.start, ground.start) && { air_start: air.start }),
    ...(air && !isSame(air.goal, ground.goal) && { air_goal: air.goal }),
  };
}

function isSame([ax, ay]: Cell, [bx, by]: Cell): boolean {
  return ax === bx && ay === by;
}
