// Keeps the results up to date with the mission. One question is asked at a time, and the latest wins: those in between
// are dropped. When nothing changes for a moment, the rest is requested.
import { pause, ServiceError, stopped } from "../api/client";
import { PlanFetcher, type PlanService } from "./plan_fetcher";
import { keyOf, type Question } from "./request";
import { KnownResults } from "./results";

export interface Pace {
  calm: number; // ms without change after which the rest is requested
  patience: number; // ms that a plan may take while a newer question waits
  fluent: number; // ms: where plans take longer, one that keeps what the last removed follows the mouse
  slow: number; // ms: where they take longer and nothing can be kept, a rough draft comes first
}

interface Work {
  control: AbortController;
  began: number;
}

export class Planner {
  readonly results = new KnownResults();

  readonly #fetcher: PlanFetcher;
  #wanted: Question | null = null;
  #working: Work | null = null;
  #resting: { control: AbortController; question: Question } | null = null;

  constructor(
    service: PlanService,
    private readonly pace: Pace = { calm: 150, patience: 600, fluent: 10, slow: 80 },
  ) {
    this.#fetcher = new PlanFetcher(service, this.results, pace);
  }

  ask(question: Question): void {
    this.#wanted = question;
    const isAnswered = !this.#working && this.results.isAnswered(question);
    const goesOn = isAnswered && this.#resting !== null && keyOf.plan(this.#resting.question) === keyOf.plan(question);
    if (!goesOn) this.#resting?.control.abort();
    this.results.working.value = true;
    if (this.#working) return this.#hurry(this.#working);
    if (isAnswered) {
      this.#wanted = null;
      this.results.answered.value = question;
      if (!goesOn) void this.#rest(question);
    } else {
      void this.#work();
    }
  }

  // Cancels what is asked for; what was shown before stays.
  stop(): void {
    this.#wanted = null;
    this.#fetcher.stop();
    this.#resting?.control.abort();
    this.#resting = null;
    this.#working?.control.abort();
    this.results.progress.value = null;
    this.results.working.value = false;
    if (this.results.plans.value.after?.rough === "draft") this.results.failure.value = stopped();
  }

  // Whether what is shown answers the latest question.
  isUpToDate(): boolean {
    return this.#working === null && this.#wanted === null;
  }

  // Another map: nothing of the old plans fits.
  clear(): void {
    this.stop();
    this.#fetcher.forget();
    this.results.clear();
  }

  // A plan that takes long is dropped for a newer question, but not so soon that none ever ends.
  #hurry(working: Work): void {
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
        await this.#fetcher.fetchFirst(question, control.signal);
        this.results.failure.value = null;
        done = question;
      } catch (error) {
        const trouble = asServiceError(error);
        const dropped = trouble.trouble === "stopped" && this.#wanted !== null;
        if (dropped) continue;
        this.results.failure.value = trouble;
        if (trouble.trouble === "refused") this.results.answer(question, {}); // plans of another question would mislead
      }
    }
    this.#working = null;
    if (done) return void this.#rest(done);
    this.results.progress.value = null;
    this.results.working.value = false;
  }

  async #rest(question: Question): Promise<void> {
    const control = new AbortController();
    const resting = (this.#resting = { control, question });
    const stop = control.signal;
    try {
      await pause(this.pace.calm, stop);
      await this.#fetcher.fetchRest(question, stop);
    } catch (error) {
      // Other results may be missing, but a service that does not respond has to be reported.
      const trouble = asServiceError(error);
      const said = trouble.trouble === "gone" || trouble.trouble === "missing";
      if (said || (this.results.plans.value.after?.rough === "draft" && !stop.aborted)) this.results.failure.value = trouble;
    }
    if (this.#resting !== resting) return; // a later one goes on
    this.#resting = null;
    if (this.#working) return;
    this.results.progress.value = null;
    this.results.working.value = false;
  }
}

function asServiceError(error: unknown): ServiceError {
  return error instanceof ServiceError ? error : new ServiceError("refused", `The page failed: ${String(error)}.`);
}
