// All of a mission that is rehearsed as one plan: what was done until now, and after that the revision.
import type { Agent, Plan, Recharge, Removed, TimedPoint } from "../domain/plan";
import { positionAt } from "../play/motion";

export interface Chapter {
  before: Plan; // the story so far, and the plan that was to follow
  driven: ReadonlyMap<string, TimedPoint[]>;
  next: Plan | null;
  now: number;
  failed: number | null; // an obstacle that was not opened
}

// `before` goes on until now, and then `next` does;
// null: nothing does, all stay where they are. `driven`: of who was late, the path that was driven instead.
export function storyOf({ before, driven, next, now, failed }: Chapter): Plan {
  const agents = before.agents.map((agent): Agent => {
    const own = driven.get(agent.id);
    const past = own ? [...until(agent, own[0]![2]), ...until({ path: own }, now)] : until(agent, now);
    const ahead = next?.agents.find(({ id }) => id === agent.id);
    const path = tidy([...past, ...(ahead?.path ?? [])]);
    const { reached, ...same } = agent;
    const left = (ahead ?? agent).reached === false;
    const lost = agent.lost || (next !== null && !ahead);
    const waits = [...partsUntil(agent.waits, now), ...(ahead?.waits ?? [])];
    const recharges = goneOn(partsUntil(agent.recharges, now), ahead?.recharges ?? []);
    return { ...same, path, ...(left && { reached: false }), ...(lost && { lost }), waits, recharges };
  });
  return {
    ...before,
    ...(next && { bound: next.bound, after: figuresOf(before, next), orders: next.orders ?? [] }),
    agents,
    removed: removedOf(before, next, now, failed),
  };
}

// The figures of a plan, in the form that the mission had when it began.
function figuresOf({ after }: Plan, next: Plan): Plan["after"] {
  const { makespan, flowtime, ground_makespan } = next.after;
  return { ...after, makespan, flowtime, ground_makespan };
}

// What has been opened, what is being opened, and what is to be.
function removedOf(before: Plan, next: Plan | null, now: number, failed: number | null): Removed[] {
  const opened = new Map(openedOf(next).map(({ obstacle, at }) => [obstacle, at]));
  const kept = before.removed
    .filter(({ obstacle, cleared_at }) => obstacle !== failed && (cleared_at <= now || opened.has(obstacle)))
    .map((one): Removed => {
      const cleared_at = Math.max(one.cleared_at, one.cleared_at > now ? (opened.get(one.obstacle) ?? 0) : 0);
      const { saves, ...rest } = one;
      return { ...rest, cleared_at, entered_at: one.entered_at !== null && one.entered_at <= now ? one.entered_at : null };
    });
  const known = new Set(kept.map(({ obstacle }) => obstacle));
  return [...kept, ...(next?.removed ?? []).filter(({ obstacle }) => !known.has(obstacle))];
}

function openedOf(plan: Plan | null): { obstacle: number; at: number }[] {
  return (plan?.mission?.rules?.opened ?? []) as { obstacle: number; at: number }[];
}

// The path of an agent until a time, where it is then its last point.
function until(agent: Pick<Agent, "path">, time: number): TimedPoint[] {
  const at = positionAt(agent, time);
  if (!at || agent.path[0]![2] >= time) return agent.path.slice(0, 1);
  return [...agent.path.filter(([, , t]) => t < time), [at.x, at.y, Math.min(time, agent.path.at(-1)![2])]];
}

// Times rise; no point comes twice.
function tidy(path: readonly TimedPoint[]): TimedPoint[] {
  const result: TimedPoint[] = [];
  for (const point of path) {
    const last = result.at(-1);
    if (!last || point[2] > last[2] + 1e-9) result.push(point);
  }
  return result;
}

function partsUntil<Part extends { from: number; until: number }>(parts: readonly Part[] = [], now: number): Part[] {
  return parts.filter(({ from }) => from < now).map((part) => ({ ...part, until: Math.min(part.until, now) }));
}

// Whoever stood at a base, and goes on to, has recharged once.
function goneOn(past: readonly Recharge[], ahead: readonly Recharge[]): Recharge[] {
  const [last, next] = [past.at(-1), ahead[0]];
  if (!last || !next || next.from > last.until || next.at.join() !== last.at.join()) return [...past, ...ahead];
  return [...past.slice(0, -1), { ...last, until: next.until }, ...ahead.slice(1)];
}
