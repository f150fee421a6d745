// Plans as plan files have them.
import type { Cell, Point } from "./geometry";
import type { Pace } from "./units";

export type Objective = "makespan" | "ground-makespan" | "flowtime";

// How a plan was made; each is the option of `waybreaker plan` of that name.
export interface PlanOptions {
  paper?: boolean;
  removals?: number;
  select?: "exact" | "hits";
  planner?: "theta";
  weight?: number;
  flight?: "optimal" | "nearest";
  timing?: "enforce" | "ignore";
  objective?: Objective;
  breach_time?: number;
  breach_time_per_cell?: number;
  rubble?: number;
  protect?: number[];
  force?: number[];
  explain?: boolean;
  bound?: boolean;
  time_limit?: number;
  radius?: number;
}

// Of a request: tags and names beside ids. Plans name ids alone.
export interface RequestOptions extends Omit<PlanOptions, "protect" | "select" | "planner"> {
  select?: string;
  planner?: string;
  minimise_demolition?: number;
  gap?: number; // ends the search as soon as the plan is proven to be that good
  protect?: (number | string)[];
}

export interface Route {
  id: string;
  length: number | null;
}

export interface Outcome {
  // One vehicle and one aircraft have the first two, a team has the third: one for each agent, in the plan's order.
  ground?: { length: number | null; expanded: number; generated: number; seconds?: number };
  air?: { length: number };
  routes?: Route[];
  makespan: number | null;
  flowtime: number | null;
  ground_makespan: number | null;
}

export interface Bound {
  makespan?: number;
  flowtime?: number;
  ground_makespan?: number;
  gap: number | null;
}

export interface Removed {
  obstacle: number;
  cells: number;
  hits: number;
  source_id?: number;
  name?: string;
  weight?: number;
  at: Cell;
  cleared_at: number;
  entered_at: number | null;
  saves?: number | null; // with options.explain: how much later the mission ends without this one
  by?: string; // of a team: the aircraft that breaches it
}

export interface FrontPoint {
  makespan: number | null;
  flowtime: number | null;
  ground_makespan?: number | null;
  bound: Bound | null;
  removed: number[];
  area_m2?: number; // that these cover
  status?: Plan["status"]; // left out where there is a plan
}

// Whether planning ended before it was known what so many removals reach.
export function isUnknown({ status }: Pick<FrontPoint, "status">): boolean {
  return status === "limit_reached" || status === "stopped" || status === "not_found";
}

// What is not removed only because no aircraft can fly there and home; how long the one that comes nearest would fly, and
// how long it may, in units of time.
export interface OutOfRange {
  obstacle: number;
  agent: string;
  flight: number;
  longest: number;
}

export type TimedPoint = [x: number, y: number, t: number];

export interface Agent {
  id: string;
  kind: "ground" | "air";
  speed: number; // cells per unit of time
  start: Cell;
  goal: Cell;
  waits?: ExplainedWait[]; // of a vehicle that waits anywhere
  surface?: Surface; // of a vehicle, where the map knows its ways
  recharges?: Recharge[]; // of an aircraft that lands on its way, in order of time
  reached?: false; // of a vehicle that stays at its start, for it would not arrive in time
  lost?: boolean; // in a rehearsal: where its path ends
  path: TimedPoint[]; // two points in a row at the same place are a wait
}

// A stay at a base, from which an aircraft leaves with a full battery.
export interface Recharge {
  at: Cell;
  from: number;
  until: number;
  flown: number; // units of time in the air since its battery was full
}

// What a path leads over, in cells; the first three add up to its length.
export interface Surface {
  ways: number;
  off_ways: number;
  unknown: number;
  near_water?: number; // within 5 m of it
}

// A point of an agent's path, counted from 0, or a share of the move to the next one.
export interface PathMoment {
  agent: string;
  point: number;
  fraction?: number;
}

// What waits for what: `after` is not left before the other agent has got to `before`.
export interface Order {
  before: PathMoment;
  after: PathMoment;
  why: "opening" | "passing";
  obstacle?: number;
  slack: number;
}

export interface RevisionNote {
  number: number;
  sequence: number; // of the last report that it knows
  now: number; // when that was; paths begin then
  decided: { agent: string; point: number; time: number }[]; // until then an agent keeps to the plan before
}

// A part of a wait that has one reason.
export interface ExplainedWait {
  at: Point;
  from: number;
  until: number;
  reason: "nothing" | "readiness" | "opening" | "agent" | "rubble" | "zone";
  obstacle?: number; // that is opened
  agent?: string; // who opens it, or is let past
  zone?: number; // that is over then: which, from 1
}

export interface Plan {
  format: "waybreaker-plan/1";
  status: "solved" | "no_plan" | "not_found" | "limit_reached" | "stopped";
  map: { source: string; width: number; height: number; cell_size: number; digest: string };
  options: PlanOptions & Record<string, unknown>;
  mission?: { agents: unknown[]; rules?: Record<string, unknown> } & Record<string, unknown>; // a mission file
  limit_reached?: boolean;
  before: Outcome;
  after: Outcome;
  bound: Bound | null;
  removed: Removed[];
  demolition?: { removals: number; cells: number; area_m2?: number; structures?: number }; // what all of them destroy
  out_of_range?: OutOfRange[]; // with options.explain
  next?: { obstacle: number; source_id?: number; name?: string; saves: number | null }[];
  front?: FrontPoint[];
  agents: Agent[]; // none where there is no plan
  barred_by?: { zone: number; agent: string; at: number }; // where there is none: the zone with times, from 1, in whose way, when
  orders?: Order[];
  revision?: RevisionNote; // of a plan that was made while the mission was under way
  seconds?: Record<string, number>;
}

// Whether the plan is for others than one vehicle and one aircraft. Those that cannot get there are in its mission.
export function isTeam({ after }: Plan): boolean {
  return after.routes !== undefined;
}

// Where a ground agent stands to breach what is in its way itself.
export function ownBreaches({ id, waits = [] }: Agent): ExplainedWait[] {
  return waits.filter(({ reason, agent }) => reason === "opening" && agent === id);
}

export function objectiveOf(plan: Plan): Objective {
  return plan.options.objective ?? "makespan";
}

// Where there is no plan, its mission alone says who was to go.
export function paceOf({ agents, mission }: Plan): Pace {
  const all = agents.length > 0 ? agents : ((mission?.agents ?? []) as { speed?: number }[]);
  return { inSeconds: mission?.time_unit === "s", speeds: all.map((agent) => agent.speed) };
}

const members = { makespan: "makespan", "ground-makespan": "ground_makespan", flowtime: "flowtime" } as const;
type Figures = Partial<Record<(typeof members)[Objective], number | null>>;

// Of an outcome, a bound, a point of the curve.
export function valueOf(of: Figures, objective: Objective): number | null {
  return of[members[objective]] ?? null;
}

// The plan's own objective; Infinity where there is no way.
export function reached(plan: Plan): number {
  return valueOf(plan.after, objectiveOf(plan)) ?? Infinity;
}
