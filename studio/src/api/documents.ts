// The documents of the service besides maps and plans, as docs/server.md and its OpenAPI description have them.
import type { AgentDocument } from "../domain/agent_document";
import type { Cell, Point } from "../domain/geometry";
import type { AtGoal } from "../domain/mission";
import type { Plan, RequestOptions } from "../domain/plan";
import type { ZoneCollection } from "../domain/zone";

export interface MapEntry {
  id: string;
  uploaded: boolean;
  loaded: boolean;
}

export interface PlanRequest {
  mission: MissionDocument;
  options?: RequestOptions;
}

// A mission file; what options say is not in its rules.
export interface MissionDocument {
  format: "waybreaker-mission/1";
  time_unit?: "s"; // on maps with metres
  agents: AgentDocument[];
  rules: { separation: number; at_goal: AtGoal; collisions?: boolean; unreached?: number; zones?: ZoneCollection };
}

// What has happened to a plan ("waybreaker-state/1", docs/live.md).
export interface StateDocument {
  format: "waybreaker-state/1";
  sequence: number; // of reports, rising
  now: number;
  agents: AgentState[];
  failed: { obstacle: number; at: number }[];
  found: { cells: Cell[]; blocked: boolean }[];
}

export interface AgentState {
  id: string;
  passed: number; // the last point of its path that it has left behind, counted from 0
  at: Point; // cells
  doing: "driving" | "waiting" | "breaching" | "lost";
}

export interface RevisionRequest {
  plan: Plan;
  state: StateDocument;
  time_limit?: number;
}

// `plan` is null where none came of it.
export interface RevisionAnswer {
  status: "kept" | "revised" | "no_plan" | "broken";
  reason?: Exclude<Plan["status"], "solved">; // without a plan
  halts: { agent: string; point: number; by: number }[]; // broken: who must stop before which point of its path, and when
  plan: Plan | null;
}

// An error, as RFC 9457 has it.
export interface ProblemDocument {
  type?: string; // the service always says it, a proxy need not
  title: string;
  status: number;
  detail: string;
}
