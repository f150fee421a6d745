// Where the first answer comes before the search has ended.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ServiceError } from "../../src/api/client";
import type { Plan } from "../../src/domain/plan";
import { Planner } from "../../src/planning/planner";
import { searchState } from "../../src/planning/search_state";
import { planOf } from "../domain/plans";
import { FakeService, question } from "./fake_service";

const settle = () => vi.advanceTimersByTimeAsync(0);
const pace = { calm: 100, patience: 500, fluent: 20, slow: 80 };
const cut = (wanted: Parameters<typeof planOf>[0]): Plan => ({ ...planOf({ options: { removals: 2 }, ...wanted }), limit_reached: true });

let service: FakeService;
let planner: Planner;

beforeEach(async () => {
  vi.useFakeTimers();
  service = new FakeService();
  planner = new Planner(service, pace);
  planner.ask(question(1, { withBefore: true }));
  service.asked[1]!.answer(planOf({ after: 100 }));
});
afterEach(() => vi.useRealTimers());

const shown = () => planner.results.plans.value.after!;
const stage = () => searchState(planner.results, false).stage;
const limit = () => service.last().request?.options?.time_limit;

async function answerFirst(plan: Plan): Promise<void> {
  service.asked[0]!.answer(plan);
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
}

async function pass(): Promise<void> {
  expect(service.last().what).toBe("check");
  service.last().report({ valid: true, violations: [] });
  await settle();
}

it("what is shown is checked first, and then a longer search follows, and a longer one", async () => {
  expect(stage()).toBe("waiting");
  expect(limit()).toBeLessThan(5);
  await answerFirst(cut({ removed: [4], after: 90 }));
  expect([stage(), shown().rough]).toEqual(["looking", "quick"]);
  await pass();
  expect(shown()).toMatchObject({ rough: "quick", verdict: { valid: true } });
  expect(limit()).toBeGreaterThan(5);
  service.last().answer(cut({ removed: [5], after: 85 }));
  await settle();
  expect([stage(), shown().plan.after.makespan, shown().verdict]).toEqual(["looking", 85, null]);
  await pass();
  expect(limit()).toBeUndefined();
  service.last().answer(cut({ removed: [5], after: 85 }));
  await settle();
  expect(stage()).toBe("ended"); // by the service's own limit
  expect(shown()).toMatchObject({ verdict: { valid: true } }); // the same way: it need not be checked again
  expect(planner.results.progress.value).toBeNull();
});

it("a search that has ended is not asked for again", async () => {
  await answerFirst(cut({ removed: [4], after: 90 }));
  await pass();
  service.last().answer({ ...planOf({ removed: [5], after: 80, gap: 0 }), seconds: { total: 7 } });
  await settle();
  expect([stage(), shown().plan.after.makespan]).toEqual(["ended", 80]);
  await pass();
  await pass(); // of the way without removals
  expect(service.last().request?.options?.removals).toBe(0); // the curve
});

it("a longer search that finds less does not replace what is shown", async () => {
  await answerFirst(cut({ removed: [4], after: 90 }));
  await pass();
  service.last().answer(planOf({ removed: [5], after: 95 }));
  await settle();
  expect(shown().plan.after.makespan).toBe(90);
  expect([stage(), shown().verdict]).toEqual(["ended", { valid: true }]);
});

it("a way with nothing removed is a way, where time was too short for another", async () => {
  await answerFirst(cut({ after: null, status: "limit_reached" }));
  expect(shown().plan).toMatchObject({ after: { makespan: 100 }, options: { removals: 2 }, bound: null });
  expect(stage()).toBe("looking");
});

it("seconds count from where the search began, and the best so far is never worse than what is shown", async () => {
  service.asked[0]!.onProgress({ state: "planning", seconds: 0.5, best: 95, bound: 70 });
  expect(searchState(planner.results, false)).toMatchObject({ best: 95, bound: 70 });
  await vi.advanceTimersByTimeAsync(2000);
  await answerFirst({ ...cut({ removed: [4], after: 90 }), bound: { makespan: 80, gap: 0.125 } });
  await pass();
  service.last().onProgress({ state: "planning", seconds: 1, best: 99, bound: 75 });
  expect(searchState(planner.results, false)).toMatchObject({ stage: "looking", best: 90, bound: 80 });
  expect(searchState(planner.results, false).seconds).toBeCloseTo(2.1, 1);
  service.last().onProgress({ state: "planning", seconds: 2, best: 88, bound: 85 });
  expect(searchState(planner.results, false)).toMatchObject({ best: 88, bound: 85 });
});

it("the way without removals has the same time, where its own was cut", async () => {
  planner.ask(question(2, { withBefore: true }));
  await vi.advanceTimersByTimeAsync(pace.patience + 1);
  const [after, before] = service.asked.slice(-2);
  before!.answer(cut({ after: 100 }));
  after!.answer(cut({ removed: [4], after: 90 }));
  await vi.advanceTimersByTimeAsync(pace.calm + 1);
  await pass();
  const [longer, without] = service.asked.slice(-2);
  expect(without!.request?.options).toMatchObject({ removals: 0, time_limit: longer!.request?.options?.time_limit });
  longer!.answer(planOf({ removed: [4], after: 90 }));
  without!.answer(planOf({ after: 95 }));
  await settle();
  expect(planner.results.plans.value.before?.plan.after.makespan).toBe(95);
});

describe("stopped", () => {
  it("it keeps what is shown, and goes on where it was when asked again", async () => {
    await answerFirst(cut({ removed: [4], after: 90 }));
    await pass();
    planner.stop();
    await settle();
    expect([stage(), shown().plan.after.makespan]).toEqual(["stopped", 90]);
    expect(service.last().signal?.aborted).toBe(true);
    expect(planner.results.failure.value).toBeNull();
    planner.ask(question(1, { withBefore: true }));
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    expect(stage()).toBe("looking");
    expect(limit()).toBeGreaterThan(5); // the first is not asked for again
  });

  it("nothing is said to go on where the map is gone", async () => {
    await answerFirst(cut({ removed: [4], after: 90 }));
    expect(service.last().what).toBe("check");
    service.last().fail(new ServiceError("missing", "There is no such map."));
    await settle();
    expect(planner.results.working.value).toBe(false);
    expect([stage(), shown().verdict]).toEqual(["stopped", null]);
  });
});
