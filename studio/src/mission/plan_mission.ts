// The mission that a plan file answers, as far as the page can ask it.
import { type AgentDocument, agentsOf } from "../domain/agent_document";
import { type Agents, hasPaperMethod } from "../domain/agents";
import { alsoOf } from "../domain/also";
import { defaults, type Mark, type Mission, mostRemovals } from "../domain/mission";
import { isTeam, paceOf, type Plan } from "../domain/plan";
import { type Scale, scaled, secondsPerUnit } from "../domain/units";
import { withTimes, zonesOf } from "../domain/zone";
import { isObject, leftOut } from "./mission_file";

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
  const cell = plan.map.cell_size;
  const scale = { cell, seconds: secondsPerUnit(paceOf(plan), cell) };
  const agents = agentsOfPlan(plan, scale);
  if (!agents) return null;
  const { options } = plan;
  const rules = plan.mission?.rules ?? {};
  const unreached = typeof rules.unreached === "number" ? scaled(rules.unreached, scale.seconds) : null;
  const method = options.select === "hits" && hasPaperMethod({ agents, unreached }) ? "paper" : "exact";
  const marks = (ids: number[] | undefined, mark: Mark) => (ids ?? []).map((id): [number, Mark] => [id, mark]);
  return {
    ...defaults,
    map,
    agents,
    removals: Math.min(options.removals ?? defaults.removals, mostRemovals),
    method,
    objective: options.objective ?? defaults.objective,
    breachTime: scaled(options.breach_time ?? 0, scale.seconds),
    breachTimePerCell: scaled(options.breach_time_per_cell ?? 0, scale.seconds),
    rubble: scaled(options.rubble ?? 0, scale.seconds),
    separation: Number(rules.separation ?? defaults.separation),
    atGoal: rules.at_goal === "leave" ? "leave" : "stay",
    collisions: rules.collisions !== false,
    unreached,
    zones: withTimes(zonesOf(rules.zones) ?? [], (time) => scaled(time, scale.seconds)),
    also: alsoOf(saidOf(plan), method, options.removals ?? defaults.removals),
    marks: new Map([...marks(options.protect, "protect"), ...marks(options.force, "force")]),
  };
}

// Rules and method in the terms of requests. The heuristic of options is the one that the planner has anyway.
function saidOf({ options, mission }: Plan): Record<string, unknown> {
  const { heuristic, ...others } = options;
  return { ...mission?.rules, ...(mission?.method as object | undefined), ...others };
}

// A plan is of agents that the command took: only what the page cannot say is left out.
export function leftOutOfPlan({ agents, options, mission }: Plan): string[] {
  const said = (mission?.agents ?? agents) as AgentDocument[];
  const known = said.length === agents.length ? said.map((agent, i) => ({ ...agents[i]!, ...agent })) : said;
  return leftOut({ agents: known, rules: { removals: options.removals ?? defaults.removals } });
}

// What the options say of the only vehicle counts more than what the mission does.
function agentsOfPlan(plan: Plan, scale: Scale): Agents | null {
  const { agents, options, mission } = plan;
  if (!agents.some((agent) => agent.kind === "ground")) return null;
  const said = (mission?.agents ?? []) as Partial<AgentDocument>[];
  const stated = !isTeam(plan) && options.radius !== undefined ? { radius: options.radius } : {};
  const whole = agents.map(({ id, kind, start, goal, speed }, i) => ({ ...said[i], ...stated, id, kind, start, goal, speed }));
  return agentsOf(whole, scale);
}
