// The documents of docs/contract.md: missions (section 6), plans (section 4), reports of the check; and the state of a mission under way
// (docs/live.md).

/** x to the right, y down; the upper left cell is [0, 0]. */
export type Cell = [x: number, y: number];

/** Whether a vehicle passes corners of blocked cells. */
export type Corners = "none" | "cut" | "squeeze";
export type Objective = "makespan" | "flowtime" | "ground-makespan";

export interface GroundAgent {
  id: string;
  kind: "ground";
  start: Cell;
  goal: Cell;
  /** Cells a unit of time; 1. */
  speed?: number;
  /** In cells; 0.5. */
  radius?: number;
  corners?: Corners;
  /** Until then it stands at its start; 0. */
  ready_at?: number;
  /** How it gets to its start if it is on its way already: the last point is there, at ready_at. */
  approach?: Waypoint[];
  /** How many obstacles it removes itself at most, for itself or for others; 0. */
  breaches?: number;
  /** What its arrival counts for in the flowtime, in people or beds; 1. */
  weight?: number;
}

export interface AirAgent {
  id: string;
  kind: "air";
  /** Any place, also between the centres of cells. */
  start: [x: number, y: number];
  goal: Cell;
  speed?: number;
  /** As of a ground agent. */
  ready_at?: number;
  approach?: Waypoint[];
  weight?: number;
  /** How many obstacles it removes at most; no limit. */
  breaches?: number;
  /** The longest flight from its start to its goal, in cells, hovering counted; no limit. */
  range?: number;
  /** The same, as a time; no limit. */
  endurance?: number;
  /** The share of both that is not planned with; 0. */
  reserve?: number;
  /** Under way: how long it has been in the air by `ready_at` since its battery was full; 0. */
  flown?: number;
}

/** An obstacle, by id, and when it opens, or its breach failed. */
export interface Opening {
  obstacle: number;
  at: number;
}

export interface Rules {
  /** How many obstacles may be removed; 3. */
  removals?: number;
  /** What they may weigh together. */
  budget?: number;
  /** The same in square metres; each obstacle weighs its area. */
  budget_m2?: number;
  /** Obstacles, by id, that must stay. */
  protect?: (number | string)[];
  /** Obstacles that must be removed. */
  force?: number[];
  /** Obstacles that open at that time, whoever opens them. */
  opened?: Opening[];
  /** Of a mission under way: breaches that have failed, each once for each time. */
  failed?: number[];
  /** How often a breach that has failed may be tried again; 0. */
  retries?: number;
  breach_time?: number;
  breach_time_per_cell?: number;
  /** How much longer a vehicle takes for each removed obstacle that it drives through; 0. */
  rubble?: number;
  timing?: "enforce" | "ignore";
  objective?: Objective;
  /** A share, 0 to 1: of the plans that are at most so much worse than the best, the one that demolishes least. */
  minimise_demolition?: number;
  /** Whether vehicles keep clear of each other; true. */
  collisions?: boolean;
  /** A vehicle that is not at its goal by then counts as if it arrived then; with `collisions: false`. */
  unreached?: number;
  /** In cells, between vehicles; 0. */
  separation?: number;
  at_goal?: "stay" | "leave";
  /** What agents keep out of: a GeoJSON FeatureCollection of polygons in cells, with `crs: "cells"` (docs/crews.md). */
  zones?: Record<string, unknown>;
}

export interface Method {
  select?: "exact" | "hits" | "greedy" | "none";
  flight?: "optimal" | "nearest";
  planner?: "optimal" | "theta" | "lazy-theta" | "astar" | "jps" | "dijkstra" | "bfs";
  heuristic?: string;
  weight?: number;
  tie_break?: "g-max" | "g-min";
  moves?: 4 | 8;
  bound?: boolean;
  explain?: boolean;
}

export interface Limits {
  /** How long planning may take; 10. null: no limit. */
  seconds?: number | null;
  /** Of each single search. Unlike a limit in seconds, it ends at the same plan every time. */
  expansions?: number;
  /** A share, 0 to 1: a plan is good enough that is proven to be no more than that above the best possible. */
  gap?: number;
}

/** What the day brings, laid over the map before it is planned on. */
export interface Overlay {
  /** GeoJSON or OpenStreetMap data, as seen from the mission file. */
  file: string;
  as: "water" | "debris" | "closed" | "wall" | "free";
  /** In metres, of lines. */
  width?: number;
}

export interface Mission {
  format: "waybreaker-mission/1";
  /** The map file that it is for, as seen from its own. */
  map?: string;
  /**
   * Refused here, where there are no such files: `waybreaker map overlay` lays them over a map; plan on that one, and leave this out.
   */
  overlays?: Overlay[];
  agents: (GroundAgent | AirAgent)[];
  rules?: Rules;
  method?: Method;
  limits?: Limits;
  time_unit?: "s";
  [other: string]: unknown;
}

export type Status = "solved" | "no_plan" | "not_found" | "limit_reached" | "stopped";

/** x, y in cells, and the time. Two in a row at one place are a wait. */
export type Waypoint = [x: number, y: number, t: number];

export interface Removal {
  obstacle: number;
  cells: number;
  hits: number;
  source_id?: number;
  name?: string;
  weight?: number;
  area_m2?: number;
  /** Where the air agent is when it breaches. */
  at: Cell;
  /** Which air agent, in the plan of a team. */
  by?: string;
  begun_at?: number;
  cleared_at: number;
  /** When a vehicle first touches it; null: never. */
  entered_at: number | null;
  saves?: number | null;
  /** Plan B, of plans made with --plan-b: what the objective comes to if this breach fails; null: there is no plan. */
  if_failed?: { objective: number | null; removed: number[] };
}

export interface Wait {
  at: [x: number, y: number];
  from: number;
  until: number;
  reason: "opening" | "agent" | "readiness" | "rubble" | "zone" | "nothing";
  obstacle?: number;
  agent?: string;
  /** Which of the mission's zones, counted from 1. */
  zone?: number;
}

export interface Itinerary {
  id: string;
  kind: "ground" | "air";
  speed: number;
  start: Cell;
  goal: Cell;
  /** Only if false: it is not at its goal in time, and stands at its start until `unreached` of the rules. */
  reached?: boolean;
  gain?: number;
  waits?: Wait[];
  path: Waypoint[];
}

/** An agent has got to that point of its path, or that share of the move from there to the next one. */
export interface Moment {
  agent: string;
  /** Counted from 0. */
  point: number;
  fraction?: number;
}

/** The agent of `after` may not leave from there before that of `before` has got there. */
export interface Order {
  before: Moment;
  after: Moment;
  why: "opening" | "passing";
  /** Of an opening. */
  obstacle?: number;
  /** How late the first may be until the second is put off. */
  slack: number;
}

export interface Route {
  id: string;
  length: number | null;
  expanded?: number;
  generated?: number;
  seconds?: number;
}

export interface Outcome {
  ground?: { length: number | null; expanded: number; generated: number; seconds?: number };
  air?: { length: number | null };
  /** In the plan of a team, in place of `ground` and `air`. */
  routes?: Route[];
  makespan: number | null;
  flowtime: number | null;
  ground_makespan: number | null;
}

/** The bound under the name of the objective, and the gap to it. */
export type Bound = { [objective in "makespan" | "flowtime" | "ground_makespan"]?: number } & { gap: number | null };

export interface Step {
  makespan: number | null;
  flowtime: number | null;
  ground_makespan: number | null;
  bound: Bound | null;
  removed: number[];
  status?: Status;
  area_m2?: number;
}

/** Cells that turned out to be other than the map says. Blocked ones are one new obstacle. */
export interface Found {
  cells: Cell[];
  /** true. */
  blocked?: boolean;
  /** Whether aircraft may breach it; false. */
  destructible?: boolean;
}

/** What has happened to an agent of a plan. */
export interface AgentState {
  id: string;
  /** The last point of its path, counted from 0, that it has left behind. */
  passed: number;
  /** Where it is, in cells; where the plan has it by now. */
  at?: [x: number, y: number];
  /** "driving" (flying as well). Who has stopped blocks its cells, who is lost nothing; neither takes any further part. */
  doing?: "driving" | "waiting" | "breaching" | "stopped" | "lost";
  /** It is to go there from now on. */
  goal?: Cell;
  /** Of an aircraft: how long it has been in the air since its battery was full; as planned. */
  flown?: number;
}

/** What has happened to a plan by `now`, on its clock. */
export interface State {
  format: "waybreaker-state/1";
  /** Of reports, rising from 1. One that the plan knows already changes nothing. */
  sequence: number;
  now: number;
  /** Who is not named is where the plan has it. */
  agents?: AgentState[];
  /** What is open, whoever opened it, or will be at that time. */
  opened?: Opening[];
  /** Breaches that left the obstacle standing. */
  failed?: Opening[];
  found?: Found[];
  /** New agents. */
  joined?: (GroundAgent | AirAgent)[];
}

/** What a plan says of itself that was made while the mission was under way. */
export interface Revision {
  /** 1 for the first one. */
  number: number;
  /** Of the last report that it knows. */
  sequence: number;
  /** When that was. Paths begin then. */
  now: number;
  /**
   * What has become of the plan before. "kept": nothing better was found than the rest of it. "revised": the rest is another one.
   * "no_plan": none was found. "broken": agents are bound to meet what is in their way, unless they stop (`halts`).
   */
  status?: "kept" | "revised" | "no_plan" | "broken";
  /** SHA-256 of the text of the plan before. */
  supersedes?: string;
  /** Up to which point of its path each agent keeps to the plan before, and when it is there. */
  decided: { agent: string; point: number; time: number }[];
  /** If broken: who must stop, before which point of its path, by when. */
  halts?: { agent: string; point: number; by: number }[];
  /** Since the mission began. */
  found?: Found[];
}

export interface Plan {
  format: "waybreaker-plan/1";
  status: Status;
  limit_reached?: true;
  /** Of a plan that revises another. */
  revision?: Revision;
  map: { source: string; width: number; height: number; cell_size: number; digest: string };
  options: Record<string, unknown>;
  mission: Mission;
  before: Outcome;
  after: Outcome;
  bound: Bound | null;
  removed: Removal[];
  demolition?: { removals: number; cells: number; area_m2?: number; structures?: number };
  next?: { obstacle: number; source_id?: number; name?: string; saves: number }[];
  agents: Itinerary[];
  /** What 0, 1, 2, ... removals reach, of `front`. */
  front?: Step[];
  /** Of a solved plan: what waits for what. */
  orders?: Order[];
  seconds?: { label: number; search: number; select: number; flight: number; total: number };
}

export interface Violation {
  rule: string;
  message: string;
  [other: string]: unknown;
}

export interface Report {
  format: "waybreaker-check/1";
  valid: boolean;
  violations: Violation[];
}
