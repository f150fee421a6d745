// All in one file, for pages without a bundler or a server: the module and the worker's script are texts in it.
import { connectionTo } from "./browser_worker.js";
import { Planner } from "./planner.js";
import { WorkerPlanner } from "./remote.js";

export * from "./api.js";
export { Planner, PlannerMap } from "./planner.js";
export { type Cancellable, WorkerMap, WorkerPlanner } from "./remote.js";

// build.mjs puts them here.
declare const WASM_BASE64: string;
declare const WORKER_SCRIPT: string;

let compiled: Promise<WebAssembly.Module> | undefined;

function module(): Promise<WebAssembly.Module> {
  compiled ??= WebAssembly.compile(Uint8Array.from(atob(WASM_BASE64), (letter) => letter.charCodeAt(0)));
  return compiled;
}

export async function createPlanner(): Promise<Planner> {
  return new Planner(await module());
}

/** In browsers: a planner in a worker of its own. The page's policy has to allow workers from `blob:`. */
export async function createWorkerPlanner(): Promise<WorkerPlanner> {
  return new WorkerPlanner(await module(), (listener) => {
    const url = URL.createObjectURL(new Blob([WORKER_SCRIPT], { type: "text/javascript" }));
    const connection = connectionTo(new Worker(url), listener);
    URL.revokeObjectURL(url);
    return connection;
  });
}
