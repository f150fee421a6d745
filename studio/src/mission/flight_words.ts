// How far aircraft can fly, in words: what they land with, and what is too far for them.
import type { AgentDocument } from "../domain/agent_document";
import type { Agent, OutOfRange, Plan } from "../domain/plan";
import { duration, length, percent, type Units } from "../domain/units";
import { arrival } from "../play/motion";
import { nameOf, rechargeWords } from "../play/story";

// As the plan's mission says them.
function batteryIn({ mission }: Plan, id: string): Partial<AgentDocument> {
  return ((mission?.agents ?? []) as AgentDocument[]).find((agent) => agent.id === id) ?? {};
}

// “recharges at 120,45 for 5 min, with 300 m of 1000 m left” for each time that it does, and at last “lands with 225 m of
// 1000 m left; 20 % are to be in reserve”; nothing where the battery has no end.
export function landings(plan: Plan, agent: Agent, units: Units): string[] {
  const { range, endurance, reserve = 0, flown = 0, ready_at: readyAt = 0 } = batteryIn(plan, agent.id);
  if (agent.kind === "ground" || (range ?? endurance) === undefined) return [];
  const of = (all: number, gone: number, text: typeof length) => `${text(Math.max(all - gone, 0), units)} of ${text(all, units)}`;
  const left = (time: number) =>
    [
      ...(range === undefined ? [] : [of(range, time * agent.speed, length)]),
      ...(endurance === undefined ? [] : [of(endurance, time, duration)]),
    ].join(" and ");
  const { recharges = [] } = agent;
  const charged = recharges.map((one) => `${rechargeWords(one)} for ${duration(one.until - one.from, units, true)}, with ${left(one.flown)} left`);
  const full = recharges.at(-1)?.until ?? readyAt - flown; // when its battery was last, or would have been
  const kept = reserve > 0 ? `; ${percent(reserve)} are to be in reserve` : "";
  return [...charged, `lands with ${left(arrival(agent) - full)} left${kept}`];
}

// What is out of range of one aircraft.
export interface TooFar {
  can: string; // “the aircraft can fly 800 m with 20 % in reserve”
  obstacles: { id: number; needs: string }[]; // “there and back is 880 m”
}

export function tooFar(plan: Plan, units: Units): TooFar[] {
  const byAgent = new Map<string, OutOfRange[]>();
  for (const one of plan.out_of_range ?? []) byAgent.set(one.agent, [...(byAgent.get(one.agent) ?? []), one]);
  return [...byAgent].flatMap(([id, obstacles]) => {
    const agent = plan.agents.find((one) => one.id === id);
    if (!agent) return [];
    const { range = Infinity, endurance = Infinity, reserve = 0 } = batteryIn(plan, id);
    const byRange = range / agent.speed <= endurance;
    const [size, longest] = [byRange ? agent.speed : 1, obstacles[0]!.longest];
    const limit = { id, byRange, longest: longest * size, reserve };
    const told = obstacles.map((one) => ({ id: one.obstacle, needs: needs(limit, one.flight * size, units) }));
    return [{ can: can(limit, units), obstacles: told }];
  });
}

// The same of one obstacle, in a sentence; null where it is not out of range.
export function whyTooFar(plan: Plan, obstacle: number, units: Units): string | null {
  for (const { can: longest, obstacles } of tooFar(plan, units)) {
    const found = obstacles.find(({ id }) => id === obstacle);
    if (found) return `Out of range: ${longest}; ${found.needs}.`;
  }
  return null;
}

interface Limit {
  id: string;
  byRange: boolean; // or by time
  longest: number; // cells, or units of time
  reserve: number;
  still?: boolean; // it is under way
}

function can({ id, byRange, longest, reserve, still }: Limit, units: Units): string {
  const kept = reserve > 0 ? ` with ${percent(reserve)} in reserve` : "";
  const far = byRange ? length(longest, units) : `for ${duration(longest, units)}`;
  return `${nameOf({ id, kind: "air" })} can ${still ? "still " : ""}fly ${far}${kept}`;
}

function needs({ byRange, longest }: Limit, flight: number, units: Units, way = "there and back"): string {
  const text = (value: number) => (byRange ? length(value, units) : duration(value, units, true));
  const figure = text(flight) === text(longest) ? "a little more" : text(flight);
  return `${way} ${byRange ? "is" : "takes"} ${figure}`;
}

const refusal = new RegExp(
  [
    /^(?:obstacle (\d+) must be removed, but )?/,
    /the (.+) agent can (still )?fly (for )?(\S+) (?:cells|units of time)(?:, with (\S+) % in reserve)?/,
    /; (.+) (?:is|takes) (\S+?)(: send it .+?)?\.?$/,
  ]
    .map(({ source }) => source)
    .join(""),
  "i",
);

const unopened = /^obstacle (\d+) must be removed, but no agent can breach it\.?$/i;

// What the planner says of flights that are too long and of what nobody opens, in the page's units and words; other messages as
// they are.
export function refusalWords(message: string, units: Units, obstacleName: (id: number) => string): string {
  const kept = unopened.exec(message)?.[1];
  if (kept !== undefined) return `${obstacleName(Number(kept))} must be removed, but nobody here opens it.`;
  const [, forced, id, still, byTime, longest, reserve, leg, flight, remedy = ""] = refusal.exec(message) ?? [];
  if (id === undefined) return message;
  const limit = { id, byRange: !byTime, longest: Number(longest), reserve: Number(reserve ?? 0) / 100, still: !!still };
  const way = forced ? "there and back" : leg!;
  const flies = `${can(limit, units)}; ${needs(limit, Number(flight), units, way)}${remedy}.`;
  const whole = forced ? `${obstacleName(Number(forced))} must be removed, but ${flies}` : flies;
  return whole.charAt(0).toUpperCase() + whole.slice(1);
}
