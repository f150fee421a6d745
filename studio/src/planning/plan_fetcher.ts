// Requests what a question needs and stores it in the results: first what has to follow the mouse, the rest when there
// is time.
import { type CheckReport, type Progress, stopped } from "../api/client";
import type { PlanRequest } from "../api/documents";
import type { LayerName } from "../domain/mission";
import { type Plan, reached } from "../domain/plan";
import { bestAtPrice, Curve, instead } from "./curve";
import {
  beforeRequest,
  canRemove,
  draftBeforeRequest,
  draftRequest,
  hasDraft,
  isHasty,
  isOfTeam,
  keyOf,
  paperRequest,
  planRequest,
  type Question,
  stepRequest,
  thoroughRequest,
} from "./request";
import { type KnownResults, type Verdict, verdictOf } from "./results";

export interface PlanService {
  plan(
    map: string,
    request: PlanRequest,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<Plan>;
  check(map: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport>;
}

export class PlanFetcher {
  #curve: Curve | null = null;
  #kept: { key: string; plan: Plan } | null = null; // what stood in for a draft
  #took = 0; // ms, the last plan that was no draft

  // Where plans take longer than `fluent` ms, a draft comes first.
  constructor(
    private readonly service: PlanService,
    private readonly results: KnownResults,
    private readonly fluent: number,
  ) {}

  forget(): void {
    this.#took = 0;
    this.#curve = null;
    this.#kept = null;
  }

  // What has to follow the mouse: the plan, or a draft of it.
  async fetchFirst(question: Question, stop: AbortSignal): Promise<void> {
    const isSlow = this.#took > this.fluent && hasDraft(question) && !this.#isKnown(question);
    if (!isSlow || !(await this.#draft(question, stop))) await this.#plan(question, stop);
  }

  // The checks of the plans, the curve, what each removal saves, the paper's plan.
  async fetchRest(question: Question, stop: AbortSignal): Promise<void> {
    const { plans } = this.results;
    if (plans.value.after?.draft) await this.#plan(question, stop);
    await this.#judge("after", question, stop);
    if (!plans.value.before) {
      this.#show("before", await this.service.plan(question.map, beforeRequest(question), stop), stop);
    }
    await this.#judge("before", question, stop);
    if (canRemove(question)) await this.#trace(question, stop);
    if (!plans.value.after?.verdict) await this.#judge("after", question, stop); // it has improved on the way
    await this.#explain(question, stop); // late: on large maps it takes longest
    await this.#paper(question, stop);
  }

  async #plan(question: Question, stop: AbortSignal): Promise<void> {
    const onProgress = (progress: Progress) => (this.results.progress.value = progress);
    const kept = this.results.beforeFor(question);
    const isKnown = this.#isKnown(question);
    const { removals } = question;
    const began = performance.now();
    const [after, before] = await Promise.all([
      removals === "auto"
        ? this.#trace(question, stop, onProgress).then((plans) => bestAtPrice(plans, question.price))
        : (this.#traced(question, removals) ??
          this.service.plan(question.map, planRequest(question, removals), stop, onProgress)),
      kept || !question.withBefore ? null : this.service.plan(question.map, beforeRequest(question), stop),
    ]);
    if (stop.aborted) throw stopped();
    if (!isKnown) this.#took = performance.now() - began;
    const beside = before ? { plan: before, verdict: null } : kept;
    const plan = removals === "auto" ? after : this.#orKnown(question, after);
    this.results.answer(question, { after: { plan, verdict: null }, ...(beside && { before: beside }) });
    this.results.progress.value = null;
  }

  // The best plan of as many removals or fewer, where the question was the same but for their number.
  #known(question: Question): Plan | null {
    const { removals } = question;
    const most = removals === "auto" ? Infinity : removals;
    const key = keyOf.front(question);
    const { answered, plans } = this.results;
    const shown = answered.value && keyOf.front(answered.value) === key ? plans.value.after : undefined;
    const all = this.#curve?.key === key ? [...this.#curve.plans] : [];
    if (shown && !shown.draft) all.push(shown.plan);
    if (this.#kept?.key === key) all.push(this.#kept.plan);
    const fitting = all.filter((plan) => plan.removed.length <= most);
    return fitting.reduce<Plan | null>((best, plan) => (best && reached(best) <= reached(plan) ? best : plan), null);
  }

  // Unless a better one is known.
  #orKnown(question: Question, plan: Plan): Plan {
    const known = this.#known(question);
    return known && !isAsGood(plan, known) ? instead(plan, known) : plan;
  }

  // The same, fast but rough. Whether there is a plan.
  async #draft(question: Question, stop: AbortSignal): Promise<boolean> {
    const kept = this.results.beforeFor(question);
    const shown = this.results.plans.value.after;
    const isAuto = question.removals === "auto";
    const known = this.#known(question);
    const removals = question.removals === "auto" ? (shown?.plan.removed.length ?? 1) : question.removals;
    const [rough, before] = await Promise.all([
      (isAuto && known) || this.service.plan(question.map, draftRequest(question, removals), stop),
      kept || !question.withBefore ? null : this.service.plan(question.map, draftBeforeRequest(question), stop),
    ]);
    if (stop.aborted) throw stopped();
    const plan = isAuto ? rough : this.#orKnown(question, rough);
    if (plan.agents.length === 0) return false;
    if (known) this.#kept = { key: keyOf.front(question), plan: known };
    const beside = before ? { plan: before, verdict: null, draft: true } : kept;
    this.results.answer(question, { after: { plan, verdict: null, draft: true }, ...(beside && { before: beside }) });
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
    const began = performance.now();
    // The best and the bound of a step are not those of the answer.
    const onStepProgress = ({ state }: Progress) => onProgress?.({ state, seconds: (performance.now() - began) / 1000 });
    while (!curve.isDone) {
      const plan =
        this.results.planFor(question, curve.next) ??
        (await this.service.plan(question.map, stepRequest(question, curve.next), stop, onStepProgress));
      if (stop.aborted) throw stopped();
      const isWanted = curve.next === question.removals;
      curve.add(isWanted ? this.#better(plan, stop) : this.#orKnown({ ...question, removals: curve.next }, plan));
      if (isWanted) this.#better(curve.plans.at(-1)!, stop); // with fewer removals time may have done for a better one
      this.results.front.value = curve.front(question.of.objective);
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
    if (after && !after.draft && isAsGood(after.plan, plan)) return after.plan;
    this.#show("after", plan, stop);
    return plan;
  }

  // The plan again with what each removal saves; where time was short, perhaps a better one.
  async #explain(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.results.plans.value.after;
    const short = shown !== undefined && isHasty(shown.plan);
    const isExplained = shown?.plan.removed.length === 0; // as far as it can be
    if (!shown || (isExplained && !short)) return;
    const removals = question.removals === "auto" ? shown.plan.removed.length : question.removals;
    const onProgress = (progress: Progress) => {
      if (short && !stop.aborted) this.results.progress.value = progress;
    };
    try {
      const plan = await this.service.plan(question.map, thoroughRequest(question, removals), stop, onProgress);
      if (!isAsGood(plan, shown.plan)) return;
      this.#show("after", plan, stop, hasSamePaths(plan, shown.plan) ? shown.verdict : null);
      this.#improveCurve(question, removals, plan, stop);
    } finally {
      if (short && !stop.aborted) this.results.progress.value = null;
    }
    await this.#judge("after", question, stop);
  }

  #improveCurve(question: Question, removals: number, plan: Plan, stop: AbortSignal): void {
    if (stop.aborted || this.#curve?.key !== keyOf.front(question)) return;
    this.#curve.improve(removals, plan);
    this.results.front.value = this.#curve.front(question.of.objective);
  }

  async #paper(question: Question, stop: AbortSignal): Promise<void> {
    const shown = this.results.plans.value.after?.plan;
    if (!shown || isOfTeam(question)) return;
    const removals = question.removals === "auto" ? shown.removed.length : question.removals;
    const paper =
      question.method === "paper"
        ? shown
        : await this.service.plan(question.map, paperRequest(question, removals), stop);
    this.#show("paper", paper, stop);
    await this.#judge("paper", question, stop);
  }

  async #judge(layer: LayerName, question: Question, stop: AbortSignal): Promise<void> {
    const { plans } = this.results;
    const judged = plans.value[layer];
    if (!judged) return;
    const report = await this.service.check(question.map, judged.plan, stop);
    if (plans.value[layer]?.plan === judged.plan) this.#show(layer, judged.plan, stop, verdictOf(report));
  }

  #show(layer: LayerName, plan: Plan, stop: AbortSignal, verdict: Verdict = null): void {
    if (!stop.aborted) this.results.show(layer, { plan, verdict });
  }
}

function isAsGood(plan: Plan, than: Plan): boolean {
  return reached(plan) <= reached(than) * (1 + 1e-9);
}

function hasSamePaths(a: Plan, b: Plan): boolean {
  return JSON.stringify(a.agents) === JSON.stringify(b.agents);
}
