// Plans in full behind the drafts that follow the mouse: the latest question, now and then, so that they have the processor.
import { pause } from "../api/client";
import type { Plan } from "../domain/plan";
import type { Question } from "./request";

const between = 250; // ms, and before the first

type Ask = (question: Question, stop: AbortSignal) => Promise<Plan>;

export class Chase {
  #wanted: Question | null = null;
  #running: AbortController | null = null;

  // `done` is told each plan, and when it was asked for.
  constructor(
    private readonly ask: Ask,
    private readonly done: (question: Question, plan: Plan, began: number) => void,
  ) {}

  follow(question: Question): void {
    this.#wanted = question;
    if (!this.#running) void this.#run();
  }

  // Nothing follows what is under way.
  rest(): void {
    this.#wanted = null;
  }

  stop(): void {
    this.rest();
    this.#running?.abort();
  }

  async #run(): Promise<void> {
    const control = (this.#running = new AbortController());
    try {
      for (;;) {
        await pause(between, control.signal);
        const question = this.#wanted;
        if (!question) break;
        this.#wanted = null;
        const began = performance.now();
        this.done(question, await this.ask(question, control.signal), began);
      }
    } catch {
      // What fails says so when the mouse rests.
    }
    this.#running = null;
    if (this.#wanted) void this.#run();
  }
}
