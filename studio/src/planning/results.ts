// What is known about a mission, and for which questions it holds.
import { type Signal, signal } from "@preact/signals";
import type { CheckReport, Progress, ServiceError } from "../api/client";
import type { LayerName } from "../domain/mission";
import type { Plan } from "../domain/plan";
import type { Front } from "./curve";
import { keyOf, type Question } from "./request";

// The verdict of the independent check on a plan: null while unknown.
export type Verdict = { valid: true } | { valid: false; reason: string } | null;

export interface Judged {
  plan: Plan;
  verdict: Verdict;
  // Until the search has ended: a draft that follows the mouse, or the best of the first seconds.
  rough?: "draft" | "quick";
}

export type Plans = Readonly<Partial<Record<LayerName, Judged>>>;

export interface Results {
  plans: Signal<Plans>;
  front: Signal<Front | null>;
  answered: Signal<Question | null>; // what the plans answer
  working: Signal<boolean>; // whether anything is asked for
  progress: Signal<Progress | null>; // of the search for the plan that is shown; seconds since it was asked for
  failure: Signal<ServiceError | null>;
}

export class KnownResults implements Results {
  readonly plans = signal<Plans>({});
  readonly front = signal<Front | null>(null);
  readonly answered = signal<Question | null>(null);
  readonly working = signal(false);
  readonly progress = signal<Progress | null>(null);
  readonly failure = signal<ServiceError | null>(null);

  answer(question: Question, plans: Plans): void {
    this.answered.value = question;
    this.plans.value = plans;
  }

  show(layer: LayerName, judged: Judged): void {
    this.plans.value = { ...this.plans.value, [layer]: judged };
  }

  clear(): void {
    this.plans.value = {};
    this.front.value = null;
    this.answered.value = null;
    this.failure.value = null;
  }

  isAnswered(question: Question): boolean {
    const last = this.answered.value;
    return last !== null && this.failure.value === null && keyOf.plan(last) === keyOf.plan(question);
  }

  // The way without removals, where it is still that of the question.
  beforeFor(question: Question): Judged | undefined {
    const last = this.answered.value;
    const { before } = this.plans.value;
    return last && before?.rough !== "draft" && keyOf.before(last) === keyOf.before(question) ? before : undefined;
  }

  // The plan that is shown anyway, unless a better one may follow.
  planFor(question: Question, removals: number): Plan | null {
    const last = this.answered.value;
    const { after } = this.plans.value;
    const fits = last && keyOf.front(last) === keyOf.front(question) && last.removals === removals;
    return fits && after && !after.rough ? after.plan : null;
  }
}

export function verdictOf({ valid, violations }: CheckReport): Verdict {
  return valid ? { valid } : { valid, reason: violations.map((violation) => violation.message).join("; ") };
}
