// A mission that is played while things go wrong: each piece of news revises the plan that holds, and can be taken back.
import { batch, computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { type CheckReport, type Client, ServiceError } from "../api/client";
import type { RevisionAnswer } from "../api/documents";
import type { Cell, Point } from "../domain/geometry";
import { objectiveOf, type Plan, type TimedPoint, valueOf } from "../domain/plan";
import type { Rehearsed } from "../domain/rehearsed";
import { averagedOver } from "../domain/weights";
import type { Clock } from "../play/clock";
import { duration, positionAt } from "../play/motion";
import { knownAt, type News } from "./news";
import { pathOf, retimed } from "./retimed";
import { stateOf } from "./state";
import { storyOf } from "./story";

// One piece of news, and what came of it.
export interface Step {
  news: News;
  now: number; // when it was known
  said: number; // where playback stood
  answer: RevisionAnswer;
  before: Plan; // the story until then, as it was to go on
  story: Plan; // as it goes on
  was: number | null; // the objective before, and after
  is: number | null;
}

interface Around {
  plan: ReadonlySignal<Plan | null>; // that is rehearsed; null: there is none
  map: () => string; // that it is for, as the client calls it
  clock: Clock;
  shown: Signal<Rehearsed | null>;
}

const patience = 2; // seconds that a revision is planned for
const fluent = 0.3; // while rubble is held over the map

export class Rehearsal {
  readonly steps = signal<readonly Step[]>([]);
  readonly working = signal(false);
  readonly failure = signal<string | null>(null);
  readonly checked = signal<{ plan: Plan; report: CheckReport } | null>(null);
  // Whether there is a plan that can be revised.
  readonly available: ReadonlySignal<boolean>;
  // The plan that holds; null: none is left.
  readonly held = computed<Plan | null>(() => {
    const last = this.steps.value.at(-1);
    return last ? last.answer.plan : this.around.plan.value;
  });

  #undone: (readonly Step[])[] = []; // what undo goes back to
  #held: readonly Step[] | null = null; // while a gesture goes on: those before it
  #wanted: { news: News; said: number; done: boolean } | null = null;
  #control: AbortController | null = null;

  constructor(
    private readonly client: Pick<Client, "revise" | "check">,
    private readonly around: Around,
  ) {
    this.available = computed(() => isRehearsable(around.plan.value));
  }

  // Where playback stands. Where it does not: when the last news was known, or at the beginning.
  get time(): number {
    return this.around.clock.time.value ?? this.steps.value.at(-1)?.now ?? 0;
  }

  // News that comes earlier than what has happened already takes its place. Not `done`: of a gesture that goes on, whose
  // last piece of news counts.
  async happens(news: News, done = true): Promise<void> {
    if (!this.available.value) return;
    this.around.clock.pause();
    this.#held ??= this.steps.value;
    this.#wanted = { news, said: this.#wanted?.said ?? this.time, done };
    if (this.#control) return;
    await this.#work();
  }

  // A gesture that came to nothing.
  abandon(): void {
    if (!this.#held) return;
    const before = this.#held;
    this.#stop();
    this.#show(before, this.time);
  }

  undo(): void {
    const last = this.steps.value.at(-1);
    const before = this.#undone.pop();
    this.#stop();
    if (before && last) this.#show(before, last.said);
  }

  // Back to the plan.
  reset(): void {
    this.#undone = [];
    this.#stop();
    if (this.steps.value.length > 0) this.#show([], this.time);
  }

  #stop(): void {
    this.#control?.abort();
    this.#control = null;
    this.#wanted = null;
    this.#held = null;
    batch(() => {
      this.working.value = false;
      this.failure.value = null;
    });
  }

  // The latest news wins: those in between are dropped.
  async #work(): Promise<void> {
    const control = (this.#control = new AbortController());
    this.working.value = true;
    while (this.#wanted) {
      const { news, said, done } = this.#wanted;
      this.#wanted = null;
      const earlier = (this.#held ??= this.steps.value);
      const kept = earlier.filter((step) => step.now <= news.at);
      try {
        const step = await this.#step(kept, news, said, done ? patience : fluent, control.signal);
        if (control.signal.aborted) return;
        this.failure.value = null;
        this.#show([...kept, step], step.now);
      } catch (error) {
        if (control.signal.aborted) return;
        this.failure.value = error instanceof ServiceError ? error.message : String(error);
      }
      if (done) {
        if (!this.failure.value) this.#undone.push(earlier);
        this.#held = null;
        await this.#check(control.signal);
      }
    }
    this.#control = null;
    this.working.value = false;
  }

  // The independent check of the plan that holds now.
  async #check(stop: AbortSignal): Promise<void> {
    const plan = this.steps.value.at(-1)?.answer.plan;
    if (!plan || this.#wanted) return;
    try {
      const report = await this.client.check(this.around.map(), plan, stop);
      if (!stop.aborted) this.checked.value = { plan, report };
    } catch {
      // It is not said to be checked.
    }
  }

  async #step(kept: readonly Step[], news: News, said: number, seconds: number, stop: AbortSignal): Promise<Step> {
    const last = kept.at(-1);
    const plan = last ? last.answer.plan : this.around.plan.value;
    if (!plan) throw new ServiceError("refused", "There is no plan left that anything could happen to.");
    const before = last?.story ?? plan;
    const answer = await this.client.revise(
      this.around.map(),
      { plan, state: stateOf(plan, news), time_limit: seconds },
      stop,
    );
    const now = knownAt(news);
    const story = storyOf({
      before,
      driven: drivenIn(plan, news),
      next: answer.plan,
      now,
      failed: news.kind === "failed" ? news.obstacle : null,
    });
    const value = (of: Plan) => {
      const sum = valueOf(of.after, objectiveOf(of));
      return sum === null ? null : sum / averagedOver(of);
    };
    return { news, now, said, answer, before, story, was: value(plan), is: answer.plan && value(answer.plan) };
  }

  #show(steps: readonly Step[], time: number): void {
    const { clock, shown } = this.around;
    const plan = steps.at(-1)?.story ?? this.around.plan.value;
    batch(() => {
      this.steps.value = steps;
      shown.value = rehearsedOf(steps);
      if (plan) clock.goOn(time, duration(plan));
    });
  }
}

// Of who is late, what is driven instead.
function drivenIn(plan: Plan, news: News): ReadonlyMap<string, TimedPoint[]> {
  if (news.kind !== "delayed") return new Map();
  return new Map([...retimed(plan, news.agent, news.at, news.by)].map(([id, stops]) => [id, pathOf(stops)]));
}

export function isRehearsable(plan: Plan | null): boolean {
  return plan !== null && plan.status === "solved" && plan.agents.length > 0 && whyNotRehearsed(plan) === null;
}

// What cannot be planned anew on its way, in words; null where all of it can.
export function whyNotRehearsed({ options }: Plan): string | null {
  if (options.timing === "ignore") return "Plans whose timing is ignored cannot be rehearsed: they enter what still stands.";
  return null;
}

function rehearsedOf(steps: readonly Step[]): Rehearsed | null {
  const last = steps.at(-1);
  if (!last) return null;
  const { story, before, now, answer } = last;
  const decided = answer.plan?.revision?.decided ?? [];
  return {
    plan: story,
    before,
    now,
    committed: new Map(decided.map(({ agent, time }) => [agent, time])),
    moments: steps.map((step) => step.now),
    rubble: steps.flatMap(({ news }) => (news.kind === "rubble" ? news.runs : [])),
    failed: steps.flatMap(({ news, before: old }) => (news.kind === "failed" ? [{ obstacle: news.obstacle, at: breachCell(old, news.obstacle) }] : [])),
    lost: steps.flatMap(({ news, before: old }) => (news.kind === "lost" ? [{ agent: news.agent, at: placeIn(old, news.agent, news.at), time: news.at }] : [])),
  };
}

function breachCell(plan: Plan, obstacle: number): Cell {
  return plan.removed.find((one) => one.obstacle === obstacle)!.at;
}

function placeIn(plan: Plan, id: string, time: number): Point {
  const at = positionAt(plan.agents.find((agent) => agent.id === id)!, time)!;
  return [at.x, at.y];
}
