// Drafts that follow the mouse, and the plans that follow them.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ServiceError } from "../../src/api/client";
import type { Plan } from "../../src/domain/plan";
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

describe("where plans take a moment", () => {
  const plan = planOf({ removed: [4], after: 90 });
  const shown = () => planner.results.plans.value.after!;
  const chased = 250; // ms after a draft

  beforeEach(async () => {
    planner.ask(question(1));
    await vi.advanceTimersByTimeAsync(pace.fluent + 1);
    service.last().answer(plan);
    await settle();
  });

  it("a draft follows the mouse that keeps what was removed", async () => {
    for (const x of [2, 3]) {
      planner.ask(question(x));
      expect(service.last().request?.options).toMatchObject({ select: "exact", force: [4], removals: 1, gap: 1 });
      service.last().answer({ ...planOf({ removed: [4], after: 95 }), bound: { makespan: 95, gap: 0 } });
      await settle();
      expect(shown()).toMatchObject({ plan: { after: { makespan: 95 }, bound: null }, rough: "draft" });
      expect(startIn(planner.results.answered.value)).toEqual([x, 0]);
    }
  });

  it("so is the way without removals, until the mouse rests", async () => {
    planner.ask(question(2, { withBefore: true }));
    const [after, before] = service.asked.slice(-2);
    expect(before!.request?.options).toMatchObject({ select: "exact", removals: 0, gap: 1 });
    after!.answer(planOf({ removed: [4], after: 95 }));
    before!.answer(planOf({ after: 120 }));
    await settle();
    expect(planner.results.plans.value.before?.rough).toBe("draft");
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    const options = service.asked.slice(-2).map((asked) => asked.request?.options);
    expect(options.map((asked) => asked?.removals).sort()).toEqual([0, 2]);
    for (const asked of options) expect(asked).not.toHaveProperty("gap");
  });

  // A drag from one place to another, of so many steps.
  const drag = async (from: number, to: number, answer: Plan) => {
    for (let x = from; x <= to; ++x) {
      planner.ask(question(x));
      service.last().answer(answer);
      await vi.advanceTimersByTimeAsync((chased + 10) / (to - from + 1));
    }
  };

  it("is planned in full behind the drafts, which keep what that removes", async () => {
    await drag(2, 5, plan);
    const full = service.last();
    expect(startOf(full)).toBe(5); // the latest
    expect(full.request?.options).toMatchObject({ select: "exact", removals: 2 });
    expect(full.request?.options).not.toHaveProperty("force");
    await drag(6, 6, plan);
    planner.ask(question(7));
    service.last().answer(plan);
    full.answer(planOf({ removed: [5, 6], after: 80 }));
    await settle();
    expect(startIn(planner.results.answered.value)).toEqual([7, 0]);
    expect(shown().plan).toEqual({ ...plan, bound: null });
    planner.ask(question(8));
    expect(service.last().request?.options).toMatchObject({ force: [5, 6], removals: 2 });
  });

  it("nothing follows behind once the mouse rests", async () => {
    planner.ask(question(2));
    service.last().answer(plan);
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    expect(service.last().request?.options).toMatchObject({ select: "exact", removals: 2 });
    const asked = service.asked.length;
    await vi.advanceTimersByTimeAsync(2 * chased);
    expect(service.asked).toHaveLength(asked);
    service.last().answer(plan);
    await settle();
    expect(shown()).toEqual({ plan, verdict: null });
  });

  it("nothing is kept where more than places has changed, or in the paper's method", async () => {
    planner.ask(question(1, { removals: 3 }));
    expect(service.last().request?.options).not.toHaveProperty("force");
    service.last().answer(plan);
    await settle();
    planner.ask(question(1, { method: "paper" }));
    await vi.advanceTimersByTimeAsync(pace.fluent + 1);
    service.last().answer(plan);
    await settle();
    planner.ask(question(2, { method: "paper" }));
    expect(service.last().request?.options).not.toHaveProperty("force");
  });

  it("goes on behind the drafts where that fails, and ends when it is stopped", async () => {
    await drag(2, 5, plan);
    service.last().fail(new ServiceError("refused", "Too much."));
    await settle();
    expect(planner.results.failure.value).toBeNull();
    await drag(6, 9, plan);
    const full = service.last();
    expect(full.request?.options).not.toHaveProperty("force");
    planner.stop();
    await settle();
    expect(full.signal?.aborted).toBe(true);
  });
});

describe("where plans take long", () => {
  const draft = { select: "hits", planner: "theta", weight: 1.5 };
  const plan = planOf({ removed: [4], after: 90 });

  beforeEach(async () => {
    planner.ask(question(1));
    await vi.advanceTimersByTimeAsync(pace.patience + 50);
    service.last().answer(plan);
    await settle();
  });

  it("a draft follows the mouse, and the plan when it rests", async () => {
    for (const x of [2, 3]) {
      planner.ask(question(x));
      expect(service.last().request?.options).toMatchObject({ ...draft, removals: 2 });
      service.last().answer(planOf({ removed: [4], after: 95 }));
      await settle();
      expect(planner.results.plans.value.after).toMatchObject({ verdict: null, rough: "draft" });
      expect(startIn(planner.results.answered.value)).toEqual([x, 0]);
    }
    const drafts = service.asked.length;
    await vi.advanceTimersByTimeAsync(pace.calm - 10);
    expect(service.asked).toHaveLength(drafts);
    await vi.advanceTimersByTimeAsync(20);
    expect(service.last().request?.options?.select).toBe("exact");
    service.last().answer(plan);
    await settle();
    expect(planner.results.plans.value.after).toEqual({ plan, verdict: null });
    expect(service.last().what).toBe("check");
  });

  it("a known plan is never replaced by a worse draft", async () => {
    const shown = () => planner.results.plans.value.after!;
    planner.ask(question(1, { removals: 3 }));
    expect(service.last().request?.options).toMatchObject({ ...draft, removals: 3 });
    service.last().answer(planOf({ removed: [4], after: 95, options: { removals: 3 } }));
    await settle();
    expect(shown().plan).toMatchObject({ after: { makespan: 90 }, options: { removals: 3 }, bound: null });
    expect(shown().rough).toBe("draft");
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    await vi.advanceTimersByTimeAsync(pace.slow + 50);
    service.last().answer(planOf({ removed: [5], after: 80, options: { removals: 3 } }));
    await settle();
    expect(shown().plan.after.makespan).toBe(80);

    planner.ask(question(1, { removals: "auto" })); // at once: the curve is not known yet
    await settle();
    expect(shown()).toMatchObject({ plan: { after: { makespan: 80 } }, rough: "draft" });
    expect(service.asked.filter((one) => one.request?.options?.select === "hits")).toHaveLength(1);
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    service.last().onProgress({ state: "planning", seconds: 1, best: 100, bound: 100 });
    expect(planner.results.progress.value?.best).toBeUndefined(); // of a step with fewer removals
  });

  it("nor by a worse plan of more removals", async () => {
    planner.ask(question(1, { removals: 3 }));
    service.last().answer(planOf({ after: null }));
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    service.last().answer({ ...planOf({ removed: [5], after: 97, gap: 0.2, options: { removals: 3 } }), bound: { makespan: 80, gap: 0.2125 } });
    await settle();
    const { after } = planner.results.plans.value;
    expect(after?.plan).toMatchObject({ after: { makespan: 90 }, bound: { makespan: 80, gap: 0.125 } });
    expect(after?.rough).toBeUndefined();
  });

  it("the plan is given up at once when the mouse moves again", async () => {
    planner.ask(question(2));
    service.last().answer(plan);
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    const exact = service.last();
    planner.ask(question(3));
    await settle();
    expect(exact.signal?.aborted).toBe(true);
    expect(service.last().request?.options).toMatchObject(draft);
    expect(planner.results.failure.value).toBeNull();
  });

  it("a draft that finds no way says nothing", async () => {
    planner.ask(question(2));
    service.last().answer(planOf({ after: null }));
    await settle();
    expect(service.last().request?.options?.select).toBe("exact");
    expect(planner.results.plans.value.after?.plan).toBe(plan);
  });

  it("the way without removals is a draft, too, until the plan comes", async () => {
    planner.ask(question(2, { withBefore: true }));
    const [after, before] = service.asked.slice(-2);
    expect(before!.request?.options).toMatchObject({ ...draft, removals: 0 });
    after!.answer(plan);
    before!.answer(planOf({}));
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    expect(service.asked.slice(-2).map((asked) => asked.request?.options?.select)).toEqual(["exact", "exact"]);
  });

  it("a plan that is stopped leaves a draft that says so", async () => {
    planner.ask(question(2));
    service.last().answer(plan);
    await vi.advanceTimersByTimeAsync(pace.calm + 1);
    planner.stop();
    await settle();
    expect(planner.results.failure.value?.trouble).toBe("stopped");
    planner.ask(question(2));
    expect(service.last().request?.options).toMatchObject(draft);
  });
});
