import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { ServiceError } from "../../src/api/client";
import { Planner } from "../../src/planning/planner";
import { planOf } from "../domain/plans";
import { FakeService, pace, question, settle, startIn, startOf } from "./fake_service";

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
  expect(planner.results.plans.value.after?.plan).toBe(plan);
  expect(startIn(planner.results.answered.value)).toEqual([4, 0]);
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
  expect(planner.results.failure.value).toBeNull();
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
  expect(planner.results.failure.value?.trouble).toBe("stopped");
});

it("asks for the rest when it is calm, and not before", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({ removed: [4], after: 90 }));
  await settle();
  await vi.advanceTimersByTimeAsync(pace.calm - 10);
  expect(service.asked).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(20);

  expect(service.last().what).toBe("check");
  expect(planner.results.plans.value.after?.verdict).toBeNull();
  service.last().report({ valid: true, violations: [] });
  await settle();
  expect(planner.results.plans.value.after?.verdict).toEqual({ valid: true });

  expect(service.last().request?.options?.removals).toBe(0);
  service.last().answer(planOf({}));
  await settle();
  service.last().report({ valid: true, violations: [] });
  await settle();

  for (const removals of [0, 1, 3, 4, 5, 6, 7, 8]) {
    expect(service.last().request?.options?.removals).toBe(removals);
    service.last().answer(planOf({}));
    await settle();
  }
  expect(service.last().request?.options?.explain).toBe(true);
  const explained = planOf({ removed: [4], after: 90 });
  explained.removed[0]!.saves = 10;
  service.last().answer(explained);
  await settle();
  expect(planner.results.plans.value.after).toEqual({ plan: explained, verdict: { valid: true } }); // the same way

  expect(service.last().request?.options?.paper).toBe(true);
  service.last().answer(planOf({ removed: [4] }));
  await settle();
  service.last().report({ valid: false, violations: [{ rule: "x", message: "too early" }] });
  await settle();
  expect(planner.results.plans.value.paper?.verdict).toEqual({ valid: false, reason: "too early" });
  expect(planner.results.working.value).toBe(false);
});

it("goes on with the rest where the same is asked again", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({}));
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  const check = service.last();
  planner.ask(question(1, { withBefore: true }));
  await settle();
  expect(service.last()).toBe(check);
  expect(check.signal?.aborted).toBe(false);
});

// Answers all that is asked before what each removal saves.
async function answerUntilExplained(after = 100): Promise<void> {
  while (service.last().request?.options?.explain !== true) {
    const { what, request } = service.last();
    const { removals } = request?.options ?? {};
    if (what === "check") service.last().report({ valid: true, violations: [] });
    else service.last().answer(planOf({ removed: removals ? [4] : [], after: removals ? after : 100 }));
    await settle();
  }
}

it("gives up the rest when something changes", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({}));
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  const check = service.last();
  expect(check.what).toBe("check");
  planner.ask(question(2));
  await settle();
  expect(check.signal?.aborted).toBe(true);
  expect(planner.results.failure.value).toBeNull();
});

it("keeps the plan it has where another is worse", async () => {
  planner.ask(question(1));
  const first = planOf({ removed: [4], after: 90 });
  service.last().answer(first);
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  service.last().report({ valid: true, violations: [] });
  await settle();
  await answerUntilExplained();
  service.last().answer(planOf({ removed: [5], after: 95 }));
  await settle();
  expect(planner.results.plans.value.after?.plan).toBe(first);
});

it("shows a better plan that is found on the way along the curve, and has it checked", async () => {
  planner.ask(question(1));
  service.last().answer(planOf({ removed: [4], after: 90 }));
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  service.last().report({ valid: true, violations: [] });
  await settle();
  await answerUntilExplained(85);
  expect(planner.results.plans.value.after?.plan.after.makespan).toBe(85);
  expect(planner.results.plans.value.after?.verdict).toEqual({ valid: true });
  expect(planner.results.front.value?.points[2]?.makespan).toBe(85);
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
  expect(planner.results.plans.value.before?.plan).toBe(before);
});

// What 0, 1, 2, ... removals reach; the last is reached by all further ones.
async function answerCurve(values: (number | null)[]): Promise<void> {
  for (let next = service.last(); next.request?.options?.removals !== undefined; next = service.last()) {
    const { removals } = next.request.options;
    const after = values[Math.min(removals, values.length - 1)]!;
    next.answer(planOf({ removed: Array.from({ length: removals }, (_, i) => i + 1), after, options: { removals } }));
    await settle();
    if (service.last() === next) return;
  }
}

it("shows each step of the curve as soon as it is known, and asks none of them twice", async () => {
  planner.ask(question(1, { removals: "auto" }));
  const asked = () => service.asked.map((one) => one.request?.options?.removals);
  service.last().answer(planOf({ after: 100 }));
  await settle();
  expect(planner.results.front.value).toMatchObject({ points: [{ makespan: 100 }], from: 0, isDone: false });
  expect(planner.results.plans.value.after).toBeUndefined();
  service.last().answer(planOf({ after: 90 }));
  await settle();
  expect(planner.results.front.value?.points.map((point) => point.makespan)).toEqual([100, 90]);
  planner.ask(question(1, { removals: "auto", price: 3 })); // the same curve at another price
  await vi.advanceTimersByTimeAsync(pace.patience + 1);
  await answerCurve([0, 0, 85, 80]);
  expect(planner.results.front.value?.isDone).toBe(true);
  expect(asked()).toEqual([0, 1, 2, 2, 3, 4, 5, 6, 7, 8]); // the third was dropped on the way
});

it("takes as many removals as save their price, where the number is left to it", async () => {
  const chosen = () => planner.results.plans.value.after?.plan.options.removals;
  planner.ask(question(1, { removals: "auto", price: 10 }));
  await answerCurve([100, 95, 75, 66, 60]);
  expect(chosen()).toBe(2); // the first alone is not worth it, with the second it is
  const steps = service.asked.length;
  for (const [price, removals] of [[9, 3], [6.5, 3], [5, 4], [13, 0], [0, 4]] as const) {
    planner.ask(question(1, { removals: "auto", price }));
    await settle();
    expect(chosen()).toBe(removals);
  }
  planner.ask(question(1, { removals: 1 }));
  await settle();
  expect(chosen()).toBe(1);
  expect(service.asked).toHaveLength(steps); // all of them are known
  planner.ask(question(2, { removals: "auto", price: 1000 }));
  await answerCurve([null, null, 80, 70]);
  expect(chosen()).toBe(2); // there is no way with fewer
});

it("never lets the curve rise where the time did not do", async () => {
  planner.ask(question(1, { removals: "auto", price: 0 }));
  await answerCurve([100, 90, 95]);
  expect(planner.results.front.value?.points.map((point) => point.makespan)).toEqual([100, ...Array(8).fill(90)]);
});

it("keeps what it shows when the service refuses or is gone", async () => {
  planner.ask(question(1));
  const plan = planOf({});
  service.last().answer(plan);
  await settle();
  planner.ask(question(2));
  service.last().fail(new ServiceError("gone", "The server does not answer."));
  await settle();
  expect(planner.results.failure.value?.trouble).toBe("gone");
  expect(planner.results.plans.value.after?.plan).toBe(plan);
  planner.ask(question(2));
  service.last().answer(planOf({}));
  await settle();
  expect(planner.results.failure.value).toBeNull();
});
