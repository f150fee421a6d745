// In Node.
import { read } from "./read.node.js";
import { Worker } from "node:worker_threads";
import { compile, type PlannerOptions } from "./load.js";
import { type Connection, type Listener, WorkerPlanner } from "./remote.js";

export * from "./api.js";
export { type Cancellable, WorkerMap, WorkerPlanner } from "./remote.js";

function start(listener: Listener): Connection {
  const worker = new Worker(new URL("./worker_thread.node.js", import.meta.url));
  worker.on("message", listener.answered);
  worker.on("error", listener.failed);
  worker.unref(); // a program may end while nothing is asked
  return {
    post: (message) => worker.postMessage(message),
    hold: (busy) => (busy ? worker.ref() : worker.unref()),
    end: () => void worker.terminate(),
  };
}

/** A planner in a thread of its own: this one stays free, and calls can be cancelled. */
export async function createWorkerPlanner(options: PlannerOptions = {}): Promise<WorkerPlanner> {
  const module = await compile(options.wasm ?? new URL("./waybreaker.wasm", import.meta.url), read);
  return new WorkerPlanner(module, start);
}
