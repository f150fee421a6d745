// What the map shows of a mission that is rehearsed: what has happened, and the plan that followed from it.
import type { Cell, Point, Run } from "./geometry";
import type { Plan } from "./plan";

export interface Rehearsed {
  plan: Plan; // all of the mission: what was done until `now`, and what is to be done
  before: Plan; // the same, had the last news not come
  now: number; // when that was known
  committed: ReadonlyMap<string, number>; // by agent: until then it keeps to the plan before
  moments: readonly number[]; // when news came
  rubble: readonly Run[];
  failed: readonly { obstacle: number; at: Cell }[];
  lost: readonly { agent: string; at: Point; time: number }[];
}
