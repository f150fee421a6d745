// The Worker: one planner, which answers one call after the other.
import type { FromWorker, ToWorker } from "./messages";
import { Planner, Refused } from "./planner";

const least = 250; // ms between two reports, as the service has it

let planner: Planner | null = null;
let reported = 0;

function send(message: FromWorker): void {
  postMessage(message);
}

function report(best: number, bound: number): void {
  if (performance.now() - reported < least) return;
  reported = performance.now();
  send({ kind: "progress", best, bound });
}

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  try {
    if (data instanceof WebAssembly.Module) {
      planner = new Planner(data, report);
      return;
    }
    reported = performance.now();
    send({ kind: "answer", text: planner!.run(data) });
  } catch (error) {
    const kind = error instanceof Refused ? "refused" : "failed";
    send({ kind, reason: error instanceof Error ? error.message : String(error) });
  }
});
