// Keeps the plans shown up with the mission. The latest question wins: one is asked at a time, those in between are
// dropped. When nothing changes for a moment, the rest is asked: whether the plans hold, what each removal saves, what
// other numbers of removals reach, what the paper would do.
import { signal, type Signal } from "@preact/signals";
import { type CheckReport, pause, type Progress, ServiceError } from "../api/client";
import type { PlanRequest } from "../api/documents";
import type { LayerName } from "../domain/mission";
import { objectiveOf, type Plan, valueOf } from "../domain/plan";
import { bestAtPrice, Curve, type Front } from "./curve";
import {
  beforeRequest,
  draftBeforeRequest,
  draftRequest,
  keyOf,
  paperRequest,
  planRequest,
  type Question,
  quick,
  stepRequest,
  thoroughRequest,
} from "./request";

export interface PlanService {
  plan(map: string, request: PlanRequest, signal?: AbortSignal, tell?: (progress: Progress) => void): Promise<Plan>;
  check(map: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport>;
}

// What the independent check says of a plan: null while it is not known.
export type Verdict = { valid: true } | { valid: false; reason: string } | null;

export interface Judged {
  plan: Plan;
  verdict: Verdict;
  draft?: boolean; // made in a hurry: the plan itself follows
}

export interface Pace {
  calm: number; // ms without change after which the rest is asked
  patience: number; // ms that a plan may take while a newer question waits
  fluent: number; // ms: where plans take longer, a draft comes first
}

// What is known about a mission.
export interface Results {
  plans: Signal<Readonly<Partial<Record<LayerName, Judged>>>>;
  front: Signal<Front | null>;
  answered: Signal<Question | null>; // what the plans answer
  progress: Signal<Progress | null>;
  failure: Signal<ServiceError | null>;
}

export class Planner implements Results {
  readonly plans = signal<Readonly<Partial<Record<LayerName, Judged>>>>({});
  readonly front = signal<Front | null>(null);
  readonly answered = signal<Question | null>(null);
  readonly progress = signal<Progress | null>(null);
  readonly failure = signal<ServiceError | null>(null);

  #wanted: Question | null = null;
  #working: { control: AbortController; began: number } | null = null;
  #resting: AbortController | null = null;
  #curve: Curve | null = null;
  #took = 0; // ms, the last plan that was no draft

  constructor(
    private readonly service: PlanService,
    private readonly pace: Pace = { calm: 150, patience: 600, fluent: 80 },
  ) {}

  ask(question: Question): void {
    this.#wanted = question;
    this.#resting?.abort();
    if (this.#working) return this.#hurry(this.#working);
    if (this.#isAnswered(question)) {
      this.#wanted = null;
      this.answered.value = question;
      void this.#rest(question);
    } else {
      void this.#work();
    }
  }

  // The plan under way is given up; what was shown before stays.
  stop(): void {
    this.#wanted = null;
    this.#resting?.abort();
    this.#working?.control.abort();
    this.progress.value = null;
    if (this.plans.value.after?.draft) this.failure.value = stopped();
  }

  // Whether what is shown answers the latest question.
  isUpToDate(): boolean {
    return this.#working === null && this.#wanted === null;
  }

  // Another map: nothing of the old plans fits.
  clear(): void {
    this.stop();
    this.#took = 0;
    this.plans.value = {};
    this.front.value = null;
    this.#curve = null;
    this.answered.value = null;
    this.failure.value = null;
  }

  #isAnswered(question: Question): boolean {
    const last = this.answered.value;
    return last !== null && this.failure.value === null && keyOf.plan(last) === keyOf.plan(question);
  }

  // A plan that takes long is dropped for a newer question, but not so soon that none ever ends.
  #hurry(working: { control: AbortController; began: number }): void {
    const left = working.began + this.pace.patience - performance.now();
    setTimeout(() => this.#wanted && working.control.abort(), Math.max(0, left));
  }

  async #work(): Promise<void> {
    let done: Question | null = null;
    while (this.#wanted) {
      const question = this.#wanted;
      this.#wanted = null;
      const control = new AbortController();
      this.#working = { control, began: performance.now() };
      done = null;
      try {
        const isSlow = this.#took > this.pace.fluent && !this.#isKnown(question);
        if (!isSlow || !(await this.#draft(question, control.signal))) await this.#first(question, control.signal);
        this.failure.value = null;
        done = question;
      } catch (error) {
        const trouble = asServiceError(error);
        const dropped = trouble.trouble === "stopped" && this.#wanted !== null;
        if (dropped) continue;
        this.failure.value = trouble;
        if (trouble.trouble !== "refused") continue;
        this.answered.value = question;
        this.plans.value = {}; // those of another question would mislead
      }
    }
    this.#working = null;
    this.progress.value = null;
    if (done) void this.#rest(done);
  }

  // What has to follow the mouse.
  async #first(question: Question, stop: AbortSignal): Promise<void> {
    const tell = (progress: Progress) => (this.progress.value = progress);
    const kept = this.#keptBefore(question);
    const isKnown = this.#isKnown(question);
    const { removals } = question;
    const began = performance.now();
    const [after, before] = await Promise.all([
      removals === "auto"
        ? this.#trace(question, stop, tell).then((plans) => bestAtPrice(plans, question.price))
        : (this.#traced(question, removals) ??
          this.service.plan(question.map, planRequest(question, removals), stop, tell)),
      kept || !question.withBefore ? null : this.service.plan(question.map, beforeRequest(question), stop),
    ]);
    if (stop.aborted) throw stopped();
    if (!isKnown) this.#took = performance.now() - began;
    const beside = before ? { plan: before, verdict: null } : kept;
    this.answered.value = question;
    this.plans.value = { after: { plan: after, verdict: null }, ...(beside && { before: beside }) };
    this.progress.value = null;
  }

  // The same, soon but roughly. Whether there is a way so soon.
  async #draft(question: Question, stop: AbortSignal): Promise<boolean> {
    const kept = this.#keptBefore(question);
    const removals =
      question.removals === "auto" ? (this.plans.value.after?.plan.removed.length ?? 1) : question.removals;
    const [plan, before] = await Promise.all([
      this.service.plan(question.map, draftRequest(question, removals), stop),
      kept || !question.withBefore ? null : this.service.plan(question.map, draftBeforeRequest(question), stop),
    ]);
    if (stop.aborted) throw stopped();
    if (plan.agents.length === 0) return false;
    const beside = before ? { plan: before, verdict: null, draft: true } : kept;
    this.answered.value = question;
    this.plans.value = { after: { plan, verdict: null, draft: true }, ...(beside && { before: beside }) };
    return true;
  }

  // The way without removals, where it is still that of the question.
  #keptBefore(question: Question): Judged | undefined {
    const last = this.answered.value;
    const { before } = this.plans.value;
    return last && !before?.draft && keyOf.before(last) === keyOf.before(question) ? before : undefined;
  }

  async #rest(question: Question): Promise<void> {
    const control = (this.#resting = new AbortController());
    const stop = control.signal;
    try {
      await pause(this.pace.calm, stop);
      if (this.plans.value.after?.draft) await this.#first(question, stop);
      await this.#judge("after", question, stop);
      if (!this.plans.value.before) {
        this.#show("before", await this.service.plan(question.map, beforeRequest(question), stop), stop);
      }
      await this.#judge("before", question, stop);
      await this.#trace(question, stop);
      if (!this.plans.value.after?.verdict) await this.#judge("after", question, stop); // it has improved on the way
      await this.#explain(question, stop); // late: on large maps it takes longest
      await this.#fetchPaper(question, stop);
    } catch (error) {
      // What is beside the plan may be missing; but that nobody answers has to be said.
      const trouble = asServiceError(error);
      const said = trouble.trouble === "gone" || trouble.trouble === "missing";
      if (said || (this.plans.value.after?.draft && !stop.aborted)) this.failure.value = trouble;
    }
  }

  // What each number of removals reaches, one after the other: each is shown as soon as it is known, and what is known
  // of an unchanged question is not asked again.
  async #trace(question: Question, stop: AbortSignal, tell?: (progress: Progress) => void): Promise<readonly Plan[]> {
    const key = keyOf.front(question);
    if (this.#curve?.key !== key) this.#curve = new Curve(key, question.options.force?.length ?? 0);
    const curve = this.#curve;
    const began = performance.now();
    const tellAll = (progress: Progress) => tell?.({ ...progress, seconds: (performance.now() - began) / 1000 });
    while (!curve.isDone) {
      const plan =
        this.#shownFor(question, curve.next) ??
        (await this.service.plan(question.map, stepRequest(question, curve.next), stop, tellAll));
      if (stop.aborted) throw stopped();
      curve.add(curve.next === question.removals ? this.#better(plan, stop) : plan);
      this.front.value = curve.front();
    }
    return curve.plans;
  }

  // Whether the curve has the answer.
  #isKnown(question: Question): boolean {
    if (question.removals !== "auto") return this.#traced(question, question.removals) !== null;
    return this.#curve?.key === keyOf.front(question) && this.#curve.isDone;
  }

  #traced(question: Question, removals: number): Plan | null {
    const curve = this.#curve;
    const plan = curve?.key === keyOf.front(question) ? curve.plans[removals - curve.from] : undefined;
    return plan?.options.removals === removals ? plan : null;
  }

  // The plan that is shown anyway, unless it had to be found in haste.
  #shownFor(question: Question, removals: number): Plan | null {
    const last = this.answered.value;
    const { after } = this.plans.value;
    const fits = last && keyOf.front(last) === keyOf.front(question) && last.removals === removals;
    return fits && after && !after.draft && !isHasty(after.plan) ? after.plan : null;
  }

  // The plan or the one that is shown: the better of them is shown, so that curve and headline agree.
  #better(plan: Plan, stop: AbortSignal): Plan {
    const { after } = this.plans.value;
    if (after && !after.draft && isAsGood(after.plan, plan)) return after.plan;
    this.#show("after", plan, stop);
    return plan;
  }

  // The plan again with what each removal saves; where time was short, perhaps a better one.
  async #explain(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.plans.value.after;
    const short = shown !== undefined && isHasty(shown.plan);
    if (!shown || (shown.plan.removed.length === 0 && !short)) return;
    const removals = question.removals === "auto" ? shown.plan.removed.length : question.removals;
    const tell = (progress: Progress) => {
      if (short && !stop.aborted) this.progress.value = progress;
    };
    try {
      const plan = await this.service.plan(question.map, thoroughRequest(question, removals), stop, tell);
      if (!isAsGood(plan, shown.plan)) return;
      this.#show("after", plan, stop, hasSamePaths(plan, shown.plan) ? shown.verdict : null);
    } finally {
      if (short && !stop.aborted) this.progress.value = null;
    }
    await this.#judge("after", question, stop);
  }

  async #fetchPaper(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.plans.value.after?.plan;
    if (!shown) return;
    const removals = question.removals === "auto" ? shown.removed.length : question.removals;
    const paper =
      question.method === "paper"
        ? shown
        : await this.service.plan(question.map, paperRequest(question, removals), stop);
    this.#show("paper", paper, stop);
    await this.#judge("paper", question, stop);
  }

  async #judge(layer: LayerName, question: Question, stop: AbortSignal): Promise<void> {
    const judged = this.plans.value[layer];
    if (!judged) return;
    const report = await this.service.check(question.map, judged.plan, stop);
    if (this.plans.value[layer]?.plan === judged.plan) this.#show(layer, judged.plan, stop, verdictOf(report));
  }

  #show(layer: LayerName, plan: Plan, stop: AbortSignal, verdict: Verdict = null): void {
    if (!stop.aborted) this.plans.value = { ...this.plans.value, [layer]: { plan, verdict } };
  }
}

function isHasty(plan: Plan): boolean {
  return (plan.seconds?.total ?? 0) >= quick;
}

export function verdictOf({ valid, violations }: CheckReport): Verdict {
  return valid ? { valid } : { valid, reason: violations.map((violation) => violation.message).join("; ") };
}

function isAsGood(plan: Plan, than: Plan): boolean {
  const value = (one: Plan) => valueOf(one.after, objectiveOf(one)) ?? Infinity;
  return value(plan) <= value(than) * (1 + 1e-9);
}

function hasSamePaths(a: Plan, b: Plan): boolean {
  return JSON.stringify(a.agents) === JSON.stringify(b.agents);
}

function stopped(): ServiceError {
  return new ServiceError("stopped", "Stopped.");
}

function asServiceError(error: unknown): ServiceError {
  return error instanceof ServiceError ? error : new ServiceError("refused", `The page failed: ${String(error)}.`);
}
