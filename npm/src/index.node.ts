// In Node.
import { read } from "./read.node.js";
import { compile, type PlannerOptions } from "./load.js";
import { Planner } from "./planner.js";

export * from "./api.js";
export { Planner, PlannerMap } from "./planner.js";

/** A planner on this thread. Called again, it makes another, with memory of its own. */
export async function createPlanner(options: PlannerOptions = {}): Promise<Planner> {
  return new Planner(await compile(options.wasm ?? new URL("./waybreaker.wasm", import.meta.url), read));
}
