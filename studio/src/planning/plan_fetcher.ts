// Requests what a question needs and stores it in the results: first what has to follow the mouse, the rest when there
// is time.
import { type CheckReport, type Progress, stopped } from "../api/client";
import type { PlanRequest } from "../api/documents";
import { hasPaperMethod } from "../domain/agents";
import type { LayerName } from "../domain/mission";
import { type Plan, reached } from "../domain/plan";
import { Chase } from "./chase";
import { bestAtPrice, Curve, instead } from "./curve";
import {
  beforeRequest,
  canKeep,
  canRemove,
  draftBeforeRequest,
  draftRequest,
  explainRequest,
  furtherLimits,
  hasDraft,
  hasReasons,
  isCut,
  isHasty,
  keptBeforeRequest,
  keptRequest,
  keyOf,
  paperRequest,
  planRequest,
  type Question,
  stepRequest,
} from "./request";
import { type Judged, type KnownResults, verdictOf } from "./results";

export interface PlanService {
  plan(
    map: string,
    request: PlanRequest,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<Plan>;
  check(map: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport>;
}

// ms: where plans take longer, drafts follow the mouse.
export interface Limits {
  fluent: number; // drafts that keep what the last plan removed
  slow: number; // rough ones, where nothing can be kept
  patience: number; // rough ones in any case
}

export class PlanFetcher {
  readonly #chase: Chase;
  #removed: { key: string; ids: readonly number[] } | null = null; // by the last plan in full
  #curve: Curve | null = null;
  #kept: { key: string; plan: Plan } | null = null; // what stood in for a draft
  #took = 0; // ms, the last plan that was no draft
  #began = 0; // when the search did

  constructor(
    private readonly service: PlanService,
    private readonly results: KnownResults,
    private readonly limits: Limits,
  ) {
    this.#chase = new Chase(
      (question, stop) => service.plan(question.map, planRequest(question, question.removals as number), stop),
      (question, plan, began) => {
        if (this.#removed?.key !== keyOf.places(question)) return; // something else is asked by now
        this.#took = timeOf(plan, began);
        this.#remember(question, plan);
      },
    );
  }

  // What was asked for beside what the caller waits for.
  stop(): void {
    this.#chase.stop();
  }

  forget(): void {
    this.#took = 0;
    this.#removed = null;
    this.#curve = null;
    this.#kept = null;
  }

  // What has to follow the mouse: the plan, or a draft of it.
  async fetchFirst(question: Question, stop: AbortSignal): Promise<void> {
    this.#began = performance.now();
    const { fluent, slow, patience } = this.limits;
    const removed = this.#took <= patience ? this.#removedBefore(question) : null;
    const isSlow = this.#took > (removed ? fluent : slow) && hasDraft(question) && !this.#isKnown(question);
    if (!isSlow || !(await this.#draft(question, removed, stop))) await this.#plan(question, stop);
  }

  // What a draft can go on removing: the last plan was for other places alone.
  #removedBefore(question: Question): readonly number[] | null {
    return canKeep(question) && this.#removed?.key === keyOf.places(question) ? this.#removed.ids : null;
  }

  #remember(question: Question, { agents, removed }: Plan): void {
    const ids = removed.map(({ obstacle }) => obstacle);
    this.#removed = agents.length > 0 ? { key: keyOf.places(question), ids } : null;
  }

  // The check of the plan that is shown, a longer search where the first was short, the way without removals, the curve,
  // what each removal saves, the paper's plan.
  async fetchRest(question: Question, stop: AbortSignal): Promise<void> {
    const { plans } = this.results;
    if (plans.value.after?.rough === "draft") await this.#plan(question, stop);
    await this.#judge("after", question, stop);
    if (!plans.value.before) {
      this.#show("before", { plan: await this.service.plan(question.map, beforeRequest(question), stop), verdict: null }, stop);
    }
    await this.#search(question, stop);
    await this.#judge("before", question, stop);
    if (canRemove(question)) await this.#trace(question, stop);
    await this.#explain(question, stop); // late: on large maps it takes longest
    await this.#paper(question, stop);
  }

  async #plan(question: Question, stop: AbortSignal): Promise<void> {
    const kept = this.results.beforeFor(question);
    const isKnown = this.#isKnown(question);
    const { removals } = question;
    const began = performance.now();
    this.#chase.rest();
    const [after, before] = await Promise.all([
      removals === "auto"
        ? this.#trace(question, stop, this.#onProgress(stop)).then((plans) => bestAtPrice(plans, question.price))
        : (this.#traced(question, removals) ??
          this.service.plan(question.map, planRequest(question, removals), stop, this.#onProgress(stop))),
      kept || !question.withBefore ? null : this.service.plan(question.map, beforeRequest(question), stop),
    ]);
    if (stop.aborted) throw stopped();
    if (!isKnown) this.#took = removals === "auto" ? performance.now() - began : timeOf(after, began);
    this.#remember(question, after);
    const beside = before ? { plan: before, verdict: null } : kept;
    const isQuick = !isKnown && isHasty(after, question);
    const others = [beside?.plan, isQuick ? this.#draftOf(question) : undefined];
    const plan = removals === "auto" ? after : this.#orKnown(question, after, others);
    const rough = isQuick ? { rough: "quick" as const } : {};
    this.results.answer(question, { after: { plan, verdict: null, ...rough }, ...(beside && { before: beside }) });
    if (!isQuick) this.results.progress.value = null;
  }

  // Seconds count from where the search began, whatever it is made of.
  #onProgress(stop: AbortSignal): (progress: Progress) => void {
    return (progress) => {
      const seconds = (performance.now() - this.#began) / 1000;
      if (!stop.aborted) this.results.progress.value = { ...progress, seconds };
    };
  }

  // Where the first answer came before the search had ended: the search again, for longer.
  async #search(question: Question, stop: AbortSignal): Promise<void> {
    const { plans } = this.results;
    for (const limit of furtherLimits(question)) {
      const { after: shown, before } = plans.value;
      if (shown?.rough !== "quick") return;
      const removals = question.removals === "auto" ? shown.plan.removed.length : question.removals;
      const isBeforeCut = before !== undefined && isCut(before.plan, null);
      const [plan, other] = await Promise.all([
        this.service.plan(question.map, planRequest(question, removals, limit), stop, this.#onProgress(stop)),
        isBeforeCut ? this.service.plan(question.map, beforeRequest(question, limit), stop) : null,
      ]);
      if (stop.aborted) throw stopped();
      if (other && isAsGood(other, before!.plan)) this.#show("before", { plan: other, verdict: null }, stop);
      const better = this.#orKnown(question, plan, [plans.value.before?.plan]);
      const same = hasSamePaths(better, shown.plan);
      const rough = limit !== null && isCut(plan, limit) ? { rough: "quick" as const } : {};
      this.#show("after", { plan: better, verdict: same ? shown.verdict : null, ...rough }, stop);
      this.#improveCurve(question, removals, better, stop);
      await this.#judge("after", question, stop);
    }
    this.results.progress.value = null;
  }

  #draftOf(question: Question): Plan | undefined {
    const { answered, plans } = this.results;
    const { after } = plans.value;
    const isOfIt = answered.value !== null && keyOf.plan(answered.value) === keyOf.plan(question);
    return isOfIt && after?.rough === "draft" ? after.plan : undefined;
  }

  // The best plan of as many removals or fewer, where the question was the same but for their number, or of `others`.
  #known(question: Question, others: readonly (Plan | undefined)[] = []): Plan | null {
    const { removals } = question;
    const most = removals === "auto" ? Infinity : removals;
    const key = keyOf.front(question);
    const { answered, plans } = this.results;
    const shown = answered.value && keyOf.front(answered.value) === key ? plans.value.after : undefined;
    const all = this.#curve?.key === key ? [...this.#curve.plans] : [];
    if (shown && shown.rough !== "draft") all.push(shown.plan);
    if (this.#kept?.key === key) all.push(this.#kept.plan);
    if (!question.options.force) all.push(...others.filter((plan) => plan !== undefined)); // which force nothing
    const fitting = all.filter((plan) => plan.removed.length <= most && plan.agents.length > 0);
    return fitting.reduce<Plan | null>((best, plan) => (best && reached(best) <= reached(plan) ? best : plan), null);
  }

  // Unless a better one is known.
  #orKnown(question: Question, plan: Plan, others: readonly (Plan | undefined)[] = []): Plan {
    const known = this.#known(question, others);
    return known && !isAsGood(plan, known) ? instead(plan, known) : plan;
  }

  // The same, fast: with what was removed before, or else roughly. Whether there is a plan.
  async #draft(question: Question, removed: readonly number[] | null, stop: AbortSignal): Promise<boolean> {
    const kept = this.results.beforeFor(question);
    const shown = this.results.plans.value.after;
    const isAuto = question.removals === "auto";
    const known = this.#known(question);
    const removals = question.removals === "auto" ? (shown?.plan.removed.length ?? 1) : question.removals;
    const asked = removed ? keptRequest(question, removed) : draftRequest(question, removals);
    const askedBefore = removed ? keptBeforeRequest(question) : draftBeforeRequest(question);
    const [made, before] = await Promise.all([
      (isAuto && known) || this.service.plan(question.map, asked, stop),
      kept || !question.withBefore ? null : this.service.plan(question.map, askedBefore, stop),
      removed && !isAuto && this.#chase.follow(question),
    ]);
    const rough = removed && made !== known ? { ...made, bound: null } : made; // of what is kept alone
    if (stop.aborted) throw stopped();
    const plan = isAuto ? rough : this.#orKnown(question, rough);
    if (plan.agents.length === 0) return false;
    if (known) this.#kept = { key: keyOf.front(question), plan: known };
    const draft = (made: Plan): Judged => ({ plan: made, verdict: null, rough: "draft" });
    const beside = before ? draft(before) : kept;
    this.results.answer(question, { after: draft(plan), ...(beside && { before: beside }) });
    return true;
  }

  // What each number of removals reaches, one after the other: each is shown as soon as it is known, and what is known
  // of an unchanged question is not asked again.
  async #trace(
    question: Question,
    stop: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<readonly Plan[]> {
    const key = keyOf.front(question);
    if (this.#curve?.key !== key) this.#curve = new Curve(key, question.options.force?.length ?? 0);
    const curve = this.#curve;
    // The best and the bound of a step are not those of the answer.
    const onStepProgress = ({ state, seconds }: Progress) => onProgress?.({ state, seconds });
    while (!curve.isDone) {
      const plan =
        this.results.planFor(question, curve.next) ??
        (await this.service.plan(question.map, stepRequest(question, curve.next), stop, onStepProgress));
      if (stop.aborted) throw stopped();
      const isWanted = curve.next === question.removals;
      curve.add(isWanted ? this.#better(plan, stop) : this.#orKnown({ ...question, removals: curve.next }, plan));
      if (isWanted) this.#better(curve.plans.at(-1)!, stop); // with fewer removals time may have done for a better one
      this.results.front.value = curve.front(question.of.objective);
      if (isWanted) await this.#judge("after", question, stop);
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

  // The plan or the one that is shown: the better of them is shown, so that curve and headline agree.
  #better(plan: Plan, stop: AbortSignal): Plan {
    const { after } = this.results.plans.value;
    if (after && after.rough !== "draft" && isAsGood(after.plan, plan)) return after.plan;
    this.#show("after", { plan, verdict: null }, stop);
    return plan;
  }

  // The plan again with what each removal saves, and what is out of range.
  async #explain(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.results.plans.value.after;
    if (!shown || !hasReasons(question, shown.plan)) return;
    const removals = question.removals === "auto" ? shown.plan.removed.length : question.removals;
    const plan = await this.service.plan(question.map, explainRequest(question, removals), stop);
    if (!isAsGood(plan, shown.plan)) return;
    this.#show("after", { plan, verdict: hasSamePaths(plan, shown.plan) ? shown.verdict : null }, stop);
    this.#improveCurve(question, removals, plan, stop);
    await this.#judge("after", question, stop);
  }

  #improveCurve(question: Question, removals: number, plan: Plan, stop: AbortSignal): void {
    if (stop.aborted || this.#curve?.key !== keyOf.front(question)) return;
    this.#curve.improve(removals, plan);
    this.results.front.value = this.#curve.front(question.of.objective);
  }

  async #paper(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.results.plans.value.after?.plan;
    if (!shown || !hasPaperMethod(question.of)) return;
    const removals = question.removals === "auto" ? shown.removed.length : question.removals;
    const paper =
      question.method === "paper"
        ? shown
        : await this.service.plan(question.map, paperRequest(question, removals), stop);
    this.#show("paper", { plan: paper, verdict: null }, stop);
    await this.#judge("paper", question, stop);
  }

  // The independent check of what is shown, unless that has been done.
  async #judge(layer: LayerName, question: Question, stop: AbortSignal): Promise<void> {
    const { plans } = this.results;
    const judged = plans.value[layer];
    if (!judged || judged.verdict || judged.plan.agents.length === 0) return;
    const report = await this.service.check(question.map, judged.plan, stop);
    const now = plans.value[layer];
    if (now?.plan === judged.plan) this.#show(layer, { ...now, verdict: verdictOf(report) }, stop);
  }

  #show(layer: LayerName, judged: Judged, stop: AbortSignal): void {
    if (!stop.aborted) this.results.show(layer, judged);
  }
}

// ms: the planner's own, which is neither fetching of the planner and the map nor the network.
function timeOf({ seconds }: Plan, began: number): number {
  return seconds?.total !== undefined ? seconds.total * 1000 : performance.now() - began;
}

function isAsGood(plan: Plan, than: Plan): boolean {
  return reached(plan) <= reached(than) * (1 + 1e-9);
}

function hasSamePaths(a: Plan, b: Plan): boolean {
  return JSON.stringify(a.agents) === JSON.stringify(b.agents);
}
