// The documents of the service and of plan files, as docs/server.md and its OpenAPI description have them.
// Cells are [x, y], counted from the upper-left one; points are in cells, a whole point is the centre of a cell, y down.

export type Cell = [number, number];
export type Point = [number, number];
export type TimedPoint = [x: number, y: number, t: number];

export interface MapEntry {
  id: string;
  uploaded: boolean;
  loaded: boolean;
}

export interface MapDescription {
  id: string;
  source: string;
  format: string;
  width: number;
  height: number;
  cell_size: number; // metres
  blocked: number;
  density: number;
  obstacles: { count: number; largest: { id: number; source_id: number; cells: number } | null };
  // to_lon_lat: [a, b, c, d, e, f] with lon = a x + b y + c, lat = d x + e y + f
  georeference: { crs: string; center: [lon: number, lat: number]; to_lon_lat: number[] } | null;
  start: Cell | null;
  goal: Cell | null;
  title: string;
  attribution: string;
  notes: string[];
  digest: string;
}

export interface Obstacle {
  id: number; // from 1, in the order of the array
  source_id: number; // OpenStreetMap's: ways positive, relations negative; 0 where unknown
  name: string;
  cells: number;
  bounds: [xMin: number, yMin: number, xMax: number, yMax: number];
  destructible: boolean;
  weight: number;
  breach_time: number;
}

export interface Obstacles {
  width: number;
  height: number;
  obstacles: Obstacle[];
  runs: number[]; // label, length, label, length, ...: row after row, a run may span rows; 0 is free
  next?: number | null; // what to ask the next part for; null in the last one
}

export interface Feature {
  kind: "street" | "rail" | "water" | "green" | "place";
  class: string;
  name: string;
  shape: "line" | "area" | "point";
  points: Point[][]; // parts of a line, rings of an area (even-odd), one part of one point
}

export interface Background {
  features: Feature[];
}

export interface Outcome {
  ground: { length: number | null; expanded: number; generated: number; seconds?: number };
  air: { length: number };
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
}

export interface FrontPoint {
  makespan: number | null;
  flowtime: number | null;
  ground_makespan?: number | null;
  bound: Bound | null;
  removed: number[];
}

export interface Agent {
  id: string;
  kind: "ground" | "air";
  speed: number; // cells per unit of time
  start: Cell;
  goal: Cell;
  path: TimedPoint[]; // two points in a row at the same place are a wait
}

export interface Plan {
  format: "waybreaker-plan/1";
  status: "solved" | "no_plan" | "limit_reached" | "stopped";
  map: { source: string; width: number; height: number; cell_size: number; digest: string };
  options: PlanOptions & Record<string, unknown>;
  before: Outcome;
  after: Outcome;
  bound: Bound | null;
  removed: Removed[];
  next?: { obstacle: number; source_id?: number; name?: string; saves: number | null }[];
  front?: FrontPoint[];
  agents: Agent[]; // none where there is no plan
  seconds?: Record<string, number>;
}

export interface Comparison {
  format: "waybreaker-compare/1";
  plans: { name: string; plan: Plan }[];
}

export type Objective = "makespan" | "ground-makespan" | "flowtime";

// What a request may say; each is the option of `waybreaker plan` of that name.
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
  protect?: number[];
  force?: number[];
  explain?: boolean;
  bound?: boolean;
  time_limit?: number;
  radius?: number;
}

export interface PlanRequest {
  mission: {
    start: Cell;
    goal: Cell;
    air_start?: Cell;
    air_goal?: Cell;
    ground_speed?: number;
    air_speed?: number;
  };
  options?: PlanOptions;
  methods?: { name: string; options: PlanOptions }[]; // for compare
}

// An error, as RFC 9457 has it.
export interface ProblemDocument {
  type: string;
  title: string;
  status: number;
  detail: string;
}
