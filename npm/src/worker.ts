// In browsers.
import { connectionTo } from "./browser_worker.js";
import { compile, type PlannerOptions } from "./load.js";
import { WorkerPlanner } from "./remote.js";

export * from "./api.js";
export { type Cancellable, WorkerMap, WorkerPlanner } from "./remote.js";

/** A planner in a worker of its own: the page stays smooth, and calls can be cancelled. */
export async function createWorkerPlanner(options: PlannerOptions = {}): Promise<WorkerPlanner> {
  const module = await compile(options.wasm ?? new URL("./waybreaker.wasm", import.meta.url), (url) => fetch(url));
  return new WorkerPlanner(module, (listener) =>
    connectionTo(new Worker(new URL("./worker_thread.js", import.meta.url), { type: "module" }), listener),
  );
}
