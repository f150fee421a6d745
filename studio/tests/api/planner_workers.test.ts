import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { ServiceError } from "../../src/api/client";
import { PlannerWorkers, type Port } from "../../src/api/planner_workers";
import type { Call, FromWorker, ToWorker } from "../../src/worker/messages";

// Answers when it is told to.
class FakeWorker implements Port {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly calls: Call[] = [];
  ended = false;

  postMessage(message: ToWorker): void {
    if (message instanceof WebAssembly.Module) return;
    this.calls.push(message);
    if (message.what === "open" || message.what === "close") queueMicrotask(() => this.say({ kind: "answer", text: "" }));
  }
  say(message: FromWorker): void {
    this.onmessage?.({ data: message } as MessageEvent<FromWorker>);
  }
  terminate(): void {
    this.ended = true;
  }
  whats(): string[] {
    return this.calls.map((call) => ("map" in call ? `${call.what} ${call.map}` : call.what));
  }
}

const empty = WebAssembly.compile(new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]));
let workers: FakeWorker[] = [];
let planners: PlannerWorkers;

function start(): Port {
  workers.push(new FakeWorker());
  return workers.at(-1)!;
}
const plan = (map: string, options = {}) =>
  planners.ask({ what: "plan", map, request: "{}" }, { needs: map, ...options });
const settled = () => vi.advanceTimersByTimeAsync(1);
const troubleOf = async (asked: Promise<unknown>) => {
  const error = await asked.catch((reason: unknown) => reason);
  expect(error).toBeInstanceOf(ServiceError);
  return error as ServiceError;
};

beforeEach(async () => {
  await empty;
  vi.useFakeTimers();
  workers = [];
  planners = new PlannerWorkers(start, empty, (map) => `document of ${map}`);
});
afterEach(() => {
  vi.useRealTimers();
});

it("opens a map once, and asks one call at a time", async () => {
  const answers = [plan("a"), plan("a"), plan("a")];
  await settled();
  expect(workers.map((worker) => worker.whats())).toEqual([
    ["open a", "plan a"],
    ["open a", "plan a"],
  ]);
  workers[0]!.say({ kind: "answer", text: "first" });
  await settled();
  expect(workers[0]!.whats()).toEqual(["open a", "plan a", "plan a"]);
  workers[0]!.say({ kind: "answer", text: "third" });
  workers[1]!.say({ kind: "answer", text: "second" });
  expect(await Promise.all(answers)).toEqual(["first", "second", "third"]);
});

it("tells how far a plan is", async () => {
  const seen: unknown[] = [];
  const asked = plan("a", { onProgress: (progress: unknown) => seen.push(progress) });
  await settled();
  await vi.advanceTimersByTimeAsync(500);
  workers[0]!.say({ kind: "progress", best: Infinity, bound: 12 });
  workers[0]!.say({ kind: "answer", text: "done" });
  expect(await asked).toBe("done");
  expect(seen).toEqual([{ state: "planning", seconds: expect.closeTo(0.5, 1), best: null, bound: 12 }]);
});

it("says what the planner refuses, and goes on", async () => {
  const refused = troubleOf(plan("a"));
  await settled();
  workers[0]!.say({ kind: "refused", reason: "the start lies inside obstacle 1" });
  expect((await refused).message).toBe("The start lies inside obstacle 1.");
  const next = plan("a");
  await settled();
  workers[0]!.say({ kind: "answer", text: "a plan" });
  expect(await next).toBe("a plan");
  expect(workers).toHaveLength(1);
});

it("ends the Worker of a call that is stopped, and starts another", async () => {
  const control = new AbortController();
  const stopped = troubleOf(plan("a", { signal: control.signal }));
  await settled();
  control.abort();
  expect((await stopped).trouble).toBe("stopped");
  await vi.advanceTimersByTimeAsync(1000);
  expect(workers[0]!.ended).toBe(true);
  const next = plan("a");
  await settled();
  expect(workers[1]!.whats()).toEqual(["open a", "plan a"]);
  workers[1]!.say({ kind: "answer", text: "a plan" });
  expect(await next).toBe("a plan");
});

it("keeps the Worker of a stopped call that is soon done", async () => {
  const control = new AbortController();
  const stopped = troubleOf(plan("a", { signal: control.signal }));
  await settled();
  control.abort();
  await stopped;
  workers[0]!.say({ kind: "answer", text: "late" });
  await vi.advanceTimersByTimeAsync(1000);
  expect(workers[0]!.ended).toBe(false);
  const next = plan("a");
  await settled();
  workers[0]!.say({ kind: "answer", text: "a plan" });
  expect(await next).toBe("a plan");
});

it("lets no stopped calls keep a new one waiting", async () => {
  const control = new AbortController();
  const stopped = [1, 2, 3].map(() => troubleOf(plan("a", { signal: control.signal })));
  await settled();
  control.abort();
  await Promise.all(stopped);
  const next = plan("a");
  await settled();
  expect(workers).toHaveLength(3);
  workers[2]!.say({ kind: "answer", text: "a plan" });
  expect(await next).toBe("a plan");
});

it("starts another Worker where one fails", async () => {
  const failed = troubleOf(plan("a"));
  await settled();
  workers[0]!.say({ kind: "failed", reason: "unreachable" });
  expect((await failed).message).toBe("The planner failed (unreachable).");
  expect(workers[0]!.ended).toBe(true);
  const next = plan("a");
  await settled();
  workers[1]!.say({ kind: "answer", text: "a plan" });
  expect(await next).toBe("a plan");
});

it("keeps few maps in a Worker", async () => {
  for (const map of ["a", "b", "c", "d", "e"]) {
    const asked = plan(map);
    await settled();
    workers[0]!.say({ kind: "answer", text: "" });
    await asked;
  }
  expect(workers[0]!.whats().at(-1)).toBe("close a");
});

it("says that the planner could not be fetched", async () => {
  planners = new PlannerWorkers(start, Promise.reject(new TypeError("fetch failed")), () => "");
  expect((await troubleOf(plan("a"))).trouble).toBe("gone");
});
