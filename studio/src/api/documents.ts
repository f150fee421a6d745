// The documents of the service besides maps and plans, as docs/server.md and its OpenAPI description have them.
import type { AgentDocument } from "../domain/agent_document";
import type { AtGoal } from "../domain/mission";
import type { RequestOptions } from "../domain/plan";

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
  rules: { separation: number; at_goal: AtGoal };
}

// An error, as RFC 9457 has it.
export interface ProblemDocument {
  type?: string; // the service always says it, a proxy need not
  title: string;
  status: number;
  detail: string;
}
