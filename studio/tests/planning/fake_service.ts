// A service whose answers the test gives, and what it is asked.
import { vi } from "vitest";
import { type CheckReport, type Progress, ServiceError } from "../../src/api/client";
import type { PlanRequest } from "../../src/api/documents";
import { freshMission } from "../../src/domain/mission";
import type { Plan } from "../../src/domain/plan";
import type { PlanService } from "../../src/planning/plan_fetcher";
import type { Question } from "../../src/planning/request";

export interface Asked {
  what: "plan" | "check";
  request: PlanRequest | null;
  signal: AbortSignal | undefined;
  answer(plan: Plan): void;
  report(report: CheckReport): void;
  fail(error: ServiceError): void;
  onProgress(progress: Progress): void;
}

export class FakeService implements PlanService {
  readonly asked: Asked[] = [];

  plan: PlanService["plan"] = (_, request, signal, onProgress) => this.#note<Plan>("plan", request, signal, onProgress);
  check = (_: string, __: Plan, signal?: AbortSignal) => this.#note<CheckReport>("check", null, signal);

  last(): Asked {
    return this.asked.at(-1)!;
  }

  #note<T>(
    what: Asked["what"],
    request: PlanRequest | null,
    signal?: AbortSignal,
    onProgress: (progress: Progress) => void = () => undefined,
  ): Promise<T> {
    return new Promise((done, fail) => {
      signal?.addEventListener("abort", () => fail(new ServiceError("stopped", "")));
      const give = (value: unknown) => done(value as T);
      this.asked.push({ what, request, signal, answer: give, report: give, fail, onProgress });
    });
  }
}

export const missionFrom = (x: number): PlanRequest["mission"] => ({
  format: "waybreaker-mission/1",
  agents: [
    { id: "ground", kind: "ground", start: [x, 0], goal: [9, 9] },
    { id: "air", kind: "air", start: [x, 0], goal: [9, 9] },
  ],
  rules: { separation: 0, at_goal: "stay" },
});

export const question = (x: number, more: Partial<Question> = {}): Question => ({
  of: freshMission("m", { start: [x, 0], goal: [9, 9] }),
  map: "m",
  mission: missionFrom(x),
  options: {},
  method: "exact",
  removals: 2,
  price: 10,
  withBefore: false,
  ...more,
});

// Where the first agent starts, of a request and of what was asked.
export const startIn = (request: { mission: PlanRequest["mission"] } | null) => request?.mission.agents[0]!.start;
export const startOf = (asked: Asked) => startIn(asked.request)?.[0];

// Of a planner in tests, with fake timers.
export const pace = { calm: 150, patience: 500, fluent: 20, slow: 80 };
export const settle = () => vi.advanceTimersByTimeAsync(0);
