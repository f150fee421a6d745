import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Plan, PlanRequest } from "../../src/api/answers";
import { ServiceError, type CheckReport, type Progress } from "../../src/api/client";
import { freshMission } from "../../src/mission/mission";
import { Planner, type PlanService } from "../../src/mission/planner";
import type { Question } from "../../src/mission/request";
import { planOf } from "./plans";

interface Asked {
  what: "plan" | "front" | "check";
  request: PlanRequest | null;
  signal: AbortSignal | undefined;
  answer(plan: Plan): void;
  report(report: CheckReport): void;
  fail(error: ServiceError): void;
  tell(progress: Progress): void;
}

// A service whose answers the test gives.
class FakeService implements PlanService {
  readonly asked: Asked[] = [];

  plan: PlanService["plan"] = (_, request, signal, tell) => this.#note<Plan>("plan", request, signal, tell);
  front: PlanService["front"] = (_, request, signal, tell) => this.#note<Plan>("front", request, signal, tell);
  check = (_: string, __: Plan, signal?: AbortSignal) => this.#note<CheckReport>("check", null, signal);

  last(): Asked {
    return this.asked.at(-1)!;
  }

  #note<T>(
    what: Asked["what"],
    request: PlanRequest | null,
    signal?: AbortSignal,
    tell: (progress: Progress) => void = () => undefined,
  ): Promise<T> {
    return new Promise((done, fail) => {
      signal?.addEventListener("abort", () => fail(new ServiceError("stopped", "")));
      const give = (value: unknown) => done(value as T);
      this.asked.push({ what, request, signal, answer: give, report: give, fail, tell });
    });
  }
}

const question = (x: number, more: Partial<Question> = {}): Question => ({
  of: freshMission("m", { start: [x, 0], goal: [9, 9] }),
  map: "m",
  mission: { start: [x, 0], goal: [9, 9] },
  options: {},
  method: "exact",
  removals: 2,
  withBefore: false,
  ...more,
});
const startOf = (asked: Asked) => asked.request?.mission.start[0];
const settle = () => vi.advanceTimersByTimeAsync(0);
const pace = { calm: 100, patience: 500 };

let service: FakeService;
let planner: Planner;

beforeEach(() => {
  vi.useFakeTimers();
  service = new FakeService();
  planner = new Planner(service, pace);
});
afterEach(() => vi.useRealTimers());

it("asks one at a time, and then the latest", async () => {
  for (const x of [1, 2, 3, 4]) planner.ask(question(x));
  expect(service.asked.map(startOf)).toEqual([1]);
  service.last().answer(planOf({}));
  await settle();
  expect(service.asked.map(startOf)).toEqual([1, 4]);
  const plan = planOf({ after: 50 });
  service.last().answer(plan);
  await settle();
  expect(planner.plans.value.after?.plan).toBe(plan);
  expect(planner.answered.value?.mission.start).toEqual([4, 0]);
});

it("drops a plan that takes long once there is a newer question", async () => {
  planner.ask(question(1));
  const slow = service.last();
  await vi.advanceTimersByTimeAsync(pace.patience + 100);
  expect(slow.signal?.aborted).toBe(false); // nobody waits for something else
  planner.ask(question(2));
  await settle();
  expect(slow.signal?.aborted).toBe(true);
  expect(startOf(service.last())).toBe(2);
  expect(planner.failure.value).toBeNull();
});

it("lets a plan end that has only begun", async () => {
  planner.ask(question(1));
  planner.ask(question(2));
  await vi.advanceTimersByTimeAsync(pace.patience - 50);
  expect(service.asked).toHaveLength(1);
  expect(service.last().signal?.aborted).toBe(false);
  await vi.advanceTimersByTimeAsync(100);
  expect(service.asked.map(startOf)).toEqual([1, 2]);
});

it("does not let the patience for an old plan end a new one", async () => {
  planner.ask(question(1));
  planner.ask(question(2));
  service.last().answer(planOf({}));
  await settle();
  planner.ask(question(3));
  await vi.advanceTimersByTimeAsync(pace.patience - 50);
  expect(service.last().signal?.aborted).toBe(false);
});

it("stops when told to, and says so", async () => {
  planner.ask(question(1));
  planner.stop();
  await settle();
  expect(service.last().signal?.aborted).toBe(true);
  expect(planner.failure.value?.trouble).toBe("stopped");
});

it("asks for the rest when it is calm, and not before", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({ removed: [4], after: 90 }));
  await settle();
  await vi.advanceTimersByTimeAsync(pace.calm - 10);
  expect(service.asked).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(20);

  expect(service.last().what).toBe("check");
  expect(planner.plans.value.after?.verdict).toBeNull();
  service.last().report({ valid: true, violations: [] });
  await settle();
  expect(planner.plans.value.after?.verdict).toEqual({ valid: true });

  expect(service.last().request?.options?.explain).toBe(true);
  const explained = planOf({ removed: [4], after: 90 });
  explained.removed[0]!.saves = 10;
  service.last().answer(explained);
  await settle();
  expect(planner.plans.value.after?.plan).toBe(explained);
  service.last().report({ valid: true, violations: [] });
  await settle();

  expect(service.last().request?.options?.removals).toBe(0);
  service.last().answer(planOf({}));
  await settle();
  service.last().report({ valid: true, violations: [] });
  await settle();

  expect(service.last().what).toBe("front");
  service.last().answer({ ...planOf({}), front: [{ makespan: 100, flowtime: 200, bound: null, removed: [] }] });
  await settle();
  expect(planner.front.value?.points).toHaveLength(1);

  expect(service.last().request?.options?.paper).toBe(true);
  service.last().answer(planOf({ removed: [4] }));
  await settle();
  service.last().report({ valid: false, violations: [{ rule: "x", message: "too early" }] });
  await settle();
  expect(planner.plans.value.paper?.verdict).toEqual({ valid: false, reason: "too early" });
});

it("gives up the rest when something changes", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({}));
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  const check = service.last();
  expect(check.what).toBe("check");
  planner.ask(question(2));
  await settle();
  expect(check.signal?.aborted).toBe(true);
  expect(planner.failure.value).toBeNull();
});

it("keeps the plan it has where another is worse", async () => {
  planner.ask(question(1));
  const first = planOf({ removed: [4], after: 90 });
  service.last().answer(first);
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  service.last().report({ valid: true, violations: [] });
  await settle();
  service.last().answer(planOf({ removed: [5], after: 95 }));
  await settle();
  expect(planner.plans.value.after?.plan).toBe(first);
});

it("takes the time for a better plan once there is one", async () => {
  planner.ask(question(1));
  expect(service.last().request?.options?.time_limit).toBeGreaterThan(0);
  service.last().answer({ ...planOf({ removed: [4], after: 90 }), seconds: { total: 2.1 } });
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  service.last().report({ valid: true, violations: [] });
  await settle();
  expect(service.last().request?.options?.time_limit).toBeUndefined();
  service.last().tell({ state: "planning", seconds: 5 });
  expect(planner.progress.value?.seconds).toBe(5);
  const better = planOf({ removed: [5], after: 80 });
  service.last().answer(better);
  await settle();
  expect(planner.plans.value.after).toEqual({ plan: better, verdict: null });
  expect(planner.progress.value).toBeNull();
  expect(service.last().what).toBe("check");
});

it("fetches the way without removals at once where it is shown, and keeps it while it holds", async () => {
  planner.ask(question(1, { withBefore: true }));
  expect(service.asked.map((asked) => asked.request?.options?.removals)).toEqual([2, 0]);
  const before = planOf({});
  service.asked[0]!.answer(planOf({ removed: [4] }));
  service.asked[1]!.answer(before);
  await settle();
  planner.ask(question(1, { withBefore: true, removals: 3 }));
  expect(service.asked).toHaveLength(3);
  service.last().answer(planOf({ removed: [4] }));
  await settle();
  expect(planner.plans.value.before?.plan).toBe(before);
});

it("takes the last plan of the front where the number of removals is left to it", async () => {
  planner.ask(question(1, { removals: "auto" }));
  expect(service.last().what).toBe("front");
  const plan = { ...planOf({ removed: [4] }), front: [] };
  service.last().answer(plan);
  await settle();
  expect(planner.plans.value.after?.plan).toBe(plan);
});

it("keeps what it shows when the service refuses or is gone", async () => {
  planner.ask(question(1));
  const plan = planOf({});
  service.last().answer(plan);
  await settle();
  planner.ask(question(2));
  service.last().fail(new ServiceError("gone", "The server does not answer."));
  await settle();
  expect(planner.failure.value?.trouble).toBe("gone");
  expect(planner.plans.value.after?.plan).toBe(plan);
  planner.ask(question(2));
  service.last().answer(planOf({}));
  await settle();
  expect(planner.failure.value).toBeNull();
});
