// What becomes of a plan when a vehicle is late and everybody keeps to its orders: who has to wait for it does.
import { type Agent, type Order, ownBreaches, type PathMoment, type Plan, type TimedPoint } from "../domain/plan";

// A point of a planned path, or a place on the way where somebody waits, as it comes to be.
export interface Stop {
  position: number; // on the planned path: the point's index, and a share of the move to the next one
  x: number;
  y: number;
  arrives: number;
  leaves: number;
}

export type Retimed = ReadonlyMap<string, readonly Stop[]>; // by agent

const rounding = 1e-9;

// The agent stands still where it is at `from`, for so long.
export function retimed(plan: Plan, agent: string, from: number, by: number): Retimed {
  const holds = new Map(plan.agents.map(({ id }) => [id, new Map<number, number>()]));
  const late = plan.agents.find(({ id }) => id === agent)!;
  holds.get(agent)!.set(positionAtTime(late.path, from), from + by);
  const all = new Map(plan.agents.map((one) => [one.id, stopsOf(one, holds.get(one.id)!)]));
  // Orders have no cycle: each pass settles at least one more of them.
  const orders = plan.orders ?? [];
  for (let [pass, isSettled] = [0, false]; !isSettled && pass <= orders.length; ++pass) {
    isSettled = true;
    for (const order of orders) {
      const free = mayGoOn(order, all);
      const position = positionOf(order.after);
      if (leavesAt(all.get(order.after.agent)!, position) >= free - rounding) continue;
      const held = holds.get(order.after.agent)!;
      held.set(position, free);
      all.set(order.after.agent, stopsOf(plan.agents.find(({ id }) => id === order.after.agent)!, held));
      isSettled = false;
    }
  }
  return all;
}

// The timed path that comes of it.
export function pathOf(stops: readonly Stop[]): TimedPoint[] {
  return stops.flatMap(({ x, y, arrives, leaves }): TimedPoint[] =>
    leaves > arrives ? [[x, y, arrives], [x, y, leaves]] : [[x, y, arrives]],
  );
}

// Where on a planned path an agent is at a time: the last point that it has reached, and a share of the next move.
export function positionAtTime(path: readonly TimedPoint[], time: number): number {
  let last = 0;
  while (last + 1 < path.length && path[last + 1]![2] <= time) ++last;
  const next = path[last + 1];
  const [x, y, since] = path[last]!;
  if (!next || time <= since || (next[0] === x && next[1] === y)) return last;
  return last + (time - since) / (next[2] - since);
}

function positionOf({ point, fraction = 0 }: PathMoment): number {
  return point + fraction;
}

// A plan may be ahead of an order by a little; then it may stay so.
function mayGoOn({ before, slack }: Order, all: Retimed): number {
  return arrivesAt(all.get(before.agent)!, positionOf(before)) + Math.min(slack, 0);
}

function arrivesAt(stops: readonly Stop[], position: number): number {
  return timeAt(stops, position, "arrives");
}

function leavesAt(stops: readonly Stop[], position: number): number {
  return timeAt(stops, position, "leaves");
}

function timeAt(stops: readonly Stop[], position: number, which: "arrives" | "leaves"): number {
  const next = stops.findIndex((stop) => stop.position >= position);
  const after = stops[next];
  if (!after) return stops.at(-1)!.arrives;
  const before = stops[next - 1];
  if (after.position === position || !before) return after[which];
  const share = (position - before.position) / (after.position - before.position);
  return before.leaves + share * (after.arrives - before.leaves);
}

// Vehicles leave no place before they were to, and wait less where they come late; a breach takes as long as it takes.
function stopsOf(agent: Agent, holds: ReadonlyMap<number, number>): Stop[] {
  const { path, kind } = agent;
  const works = (until: number) => kind === "air" || ownBreaches(agent).some((one) => Math.abs(one.until - until) < rounding);
  const positions = [...new Set([...path.keys(), ...holds.keys()])].sort((a, b) => a - b);
  const stops: Stop[] = [];
  for (const position of positions) {
    const { x, y, t } = planned(path, position);
    const before = stops.at(-1);
    const arrives = before ? arrival(before, planned(path, before.position)) : t;
    stops.push({ position, x, y, arrives, leaves: Math.max(arrives, holds.get(position) ?? arrives) });

    function arrival(last: Stop, was: { x: number; y: number; t: number }): number {
      const waits = was.x === x && was.y === y;
      return waits && !works(t) ? Math.max(t, last.leaves) : last.leaves + t - was.t;
    }
  }
  return stops;
}

function planned(path: readonly TimedPoint[], position: number): { x: number; y: number; t: number } {
  const last = Math.floor(position);
  const [x, y, t] = path[last]!;
  const share = position - last;
  const next = path[last + 1];
  if (share === 0 || !next) return { x, y, t };
  return { x: x + share * (next[0] - x), y: y + share * (next[1] - y), t: t + share * (next[2] - t) };
}
