// Why agents wait, read off the plan. For a vehicle: what would have been in its way, had it gone on a little sooner.
import type { AgentDocument } from "../domain/agent_document";
import { usualVehicle } from "../domain/agents";
import type { CellMap } from "../domain/cell_map";
import type { Box } from "../domain/geometry";
import type { Agent, Plan, Removed, TimedPoint } from "../domain/plan";
import { arrival, type Wait, waits } from "./motion";

export type Cause =
  | { kind: "opening"; removed: Removed } // it was not open yet
  | { kind: "vehicle"; id: string } // it had to be let past
  | { kind: "breach"; removed: Removed }; // an aircraft opens it

const touch = 1e-6; // cells: discs and squares that touch do not overlap
const shares = [0.02, 0.2, 1]; // of a wait: how much sooner, until something is in the way

interface Body {
  agent: Agent;
  radius: number;
}

export class Waiting {
  readonly #bodies: Body[];
  readonly #separation: number;
  readonly #staysAtGoal: boolean;
  readonly #causes = new Map<string, Cause | null>();

  constructor(
    private readonly plan: Plan,
    private readonly cells: CellMap, // of the map that was planned on
  ) {
    const said = (plan.mission?.agents ?? []) as Partial<AgentDocument>[];
    const rules = plan.mission?.rules ?? {};
    const usual = plan.options.radius ?? usualVehicle.radius;
    this.#bodies = plan.agents.flatMap((agent, i) =>
      agent.kind === "ground" ? [{ agent, radius: said[i]?.radius ?? usual }] : [],
    );
    this.#separation = Number(rules.separation ?? 0);
    this.#staysAtGoal = rules.at_goal !== "leave";
  }

  // Of a wait that waits() names; null where nothing is found.
  causeOf(agent: Agent, wait: Wait): Cause | null {
    const key = `${agent.id} ${wait.from}`;
    const known = this.#causes.get(key);
    if (known !== undefined) return known;
    const cause = this.#find(agent, wait);
    this.#causes.set(key, cause);
    return cause;
  }

  #find(agent: Agent, wait: Wait): Cause | null {
    const body = this.#bodies.find((one) => one.agent === agent);
    if (!body) return this.#breach(agent, wait);
    const next = waits(agent).find(({ from }) => from >= wait.until);
    const run = agent.path.filter(([, , t]) => t >= wait.until && t <= (next?.from ?? Infinity));
    const entries = this.plan.removed.map((removed) => ({ removed, at: this.#entry(run, removed.obstacle, body.radius) }));
    for (const share of shares) {
      const sooner = share * (wait.until - wait.from);
      const shifted = run.map(([x, y, t]): TimedPoint => [x, y, t - sooner]);
      let [first, cause]: [number, Cause | null] = [Infinity, null];
      for (const { removed, at } of entries) {
        if (at - sooner >= removed.cleared_at || at - sooner >= first) continue;
        [first, cause] = [at - sooner, { kind: "opening", removed }];
      }
      for (const other of this.#bodies) {
        if (other === body) continue;
        const met = this.#meeting(shifted, other, body.radius, first);
        if (met < first) [first, cause] = [met, { kind: "vehicle", id: other.agent.id }];
      }
      if (cause) return cause;
    }
    return next ? this.causeOf(agent, next) : null; // it would only have waited there
  }

  #breach({ id }: Agent, { at, from, until }: Wait): Cause | null {
    const isHere = ({ by, at: place, cleared_at: time }: Removed) =>
      (by ?? id) === id && place[0] === at[0] && place[1] === at[1] && from < time && time <= until + touch;
    const removed = this.plan.removed.find(isHere);
    return removed ? { kind: "breach", removed } : null;
  }

  // When a disc first overlaps an obstacle; Infinity if it never does.
  #entry(run: readonly TimedPoint[], obstacle: number, radius: number): number {
    for (const [a, b] of legs(run)) {
      const reach = radius + 0.5;
      const near: Box = {
        left: Math.min(a[0], b[0]) - reach,
        right: Math.max(a[0], b[0]) + reach,
        top: Math.min(a[1], b[1]) - reach,
        bottom: Math.max(a[1], b[1]) + reach,
      };
      const shares = this.cells.runsOf(obstacle, near).map(([x, y, length]) => {
        const inner: Box = { left: x - 0.5 + touch, right: x + length - 0.5 - touch, top: y - 0.5 + touch, bottom: y + 0.5 - touch };
        return shareUntil(a, b, inner, radius);
      });
      const first = Math.min(...shares);
      if (first <= 1) return a[2] + first * (b[2] - a[2]);
    }
    return Infinity;
  }

  // When a run first overlaps the other vehicle, before a time; Infinity if it does not.
  #meeting(run: readonly TimedPoint[], { agent, radius }: Body, own: number, before: number): number {
    const [start, end] = [agent.path[0]!, agent.path.at(-1)!];
    const still = this.#staysAtGoal ? Infinity : arrival(agent);
    const path: TimedPoint[] = [[start[0], start[1], -Infinity], ...agent.path, [end[0], end[1], still]];
    const others = legs(path);
    for (const [a, b] of legs(run)) {
      if (a[2] >= before) break;
      for (const [c, d] of others) {
        if (d[2] <= a[2]) continue;
        if (c[2] >= b[2]) break;
        const met = overlapTime([a, b], [c, d], own + radius + this.#separation - touch);
        if (met !== null) return met;
      }
    }
    return Infinity;
  }
}

type Leg = readonly [TimedPoint, TimedPoint];

function legs(path: readonly TimedPoint[]): Leg[] {
  return path.slice(1).map((point, i) => [path[i]!, point]);
}

// Where a leg is at a time within it.
function at([a, b]: Leg, t: number): [x: number, y: number] {
  if (a[0] === b[0] && a[1] === b[1]) return [a[0], a[1]];
  const share = (t - a[2]) / (b[2] - a[2]);
  return [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
}

// When two discs first come nearer than `reach`, while both are on these legs; null if they do not.
function overlapTime(one: Leg, other: Leg, reach: number): number | null {
  const [from, until] = [Math.max(one[0][2], other[0][2]), Math.min(one[1][2], other[1][2])];
  if (from >= until) return null;
  const apart = (t: number) => {
    const [[ax, ay], [bx, by]] = [at(one, t), at(other, t)];
    return [bx - ax, by - ay] as const;
  };
  const [[x, y], [xEnd, yEnd]] = [apart(from), apart(until)];
  const [dx, dy] = [xEnd - x, yEnd - y];
  // |(x, y) + share (dx, dy)| = reach
  const [a, b, c] = [dx * dx + dy * dy, x * dx + y * dy, x * x + y * y - reach * reach];
  if (c < 0) return from;
  const root = b * b - a * c;
  if (a === 0 || b >= 0 || root <= 0) return null;
  const share = (-b - Math.sqrt(root)) / a;
  return share < 1 ? from + share * (until - from) : null;
}

// The share of the way from a to b after which a disc reaches a box; Infinity if it does not. The distance is convex along the way.
function shareUntil(a: TimedPoint, b: TimedPoint, box: Box, radius: number): number {
  const distance = (share: number) => {
    const [x, y] = [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
    return Math.hypot(Math.max(box.left - x, 0, x - box.right), Math.max(box.top - y, 0, y - box.bottom));
  };
  if (distance(0) <= radius) return 0;
  let [low, high, nearest] = [0, 1, 0];
  for (let i = 0; i < 60; ++i) {
    const [third, other] = [low + (high - low) / 3, high - (high - low) / 3];
    if (distance(third) <= distance(other)) [high, nearest] = [other, third];
    else [low, nearest] = [third, other];
  }
  if (distance(nearest) > radius) return Infinity;
  let [outside, inside] = [0, nearest];
  for (let i = 0; i < 50; ++i) {
    const middle = (outside + inside) / 2;
    if (distance(middle) > radius) outside = middle;
    else inside = middle;
  }
  return inside;
}
