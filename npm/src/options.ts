// What calls take beside maps and documents.
import type { Plan, State } from "./documents.js";

export interface PlanOptions {
  /** With measured seconds in the plan, as the command writes it. Without, equal input gives equal plans. */
  timing?: boolean;
}

export interface ReviseOptions extends PlanOptions {
  /** How long it takes until agents know of the new plan; until then they keep to the old one. 0. */
  reaction?: number;
  /** How long planning may take; 10. null: no limit. */
  seconds?: number | null;
}

/** The plan before, and what had happened to it. */
export interface Continuity {
  after: Plan | string;
  state: State | string;
}
