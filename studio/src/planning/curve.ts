// The curve: what each number of removals reaches, as far as it is known.
import { mostRemovals } from "../domain/mission";
import { type Bound, type FrontPoint, isUnknown, type Objective, objectiveOf, type Plan, reached, valueOf } from "../domain/plan";

export interface Front {
  points: readonly FrontPoint[]; // for `from` removals, one more, ...
  from: number;
  key: string; // of the question
  isDone: boolean;
}

export class Curve {
  readonly plans: Plan[] = []; // for `from` removals, one more, ...

  // With fewer removals than have to be there is nothing to compare.
  constructor(
    readonly key: string,
    readonly from: number,
  ) {}

  get next(): number {
    return this.from + this.plans.length;
  }

  get isDone(): boolean {
    return this.next > mostRemovals;
  }

  // One removal more may stay unused: where the time did not do for a plan as good as the last, the last is kept.
  add(plan: Plan): void {
    const last = this.plans.at(-1);
    this.plans.push(last && reached(last) < reached(plan) ? instead(plan, last) : plan);
  }

  // A better plan of so many removals serves for more of them, too.
  improve(removals: number, plan: Plan): void {
    const first = removals - this.from;
    for (let i = first; i < this.plans.length; ++i) {
      const known = this.plans[i]!;
      if (reached(plan) < reached(known)) this.plans[i] = i === first ? plan : instead(known, plan);
    }
  }

  front(objective: Objective): Front {
    const points = this.plans.map(({ after, bound, removed, status }): FrontPoint => {
      return { ...after, bound, removed: removed.map((one) => one.obstacle), ...(status !== "solved" && { status }) };
    });
    return { points: consistent(points, objective), from: this.from, key: this.key, isDone: this.isDone };
  }
}

// A plan of fewer removals as the answer for those of `plan`. What was proven with fewer does not hold with more: the bound is
// that of `plan`, and what one removal more would take is not known.
export function instead(plan: Plan, better: Plan): Plan {
  const { limit_reached, next, mission, ...kept } = better;
  const objective = objectiveOf(plan);
  const { removals } = plan.options;
  return {
    ...kept,
    ...(plan.limit_reached && { limit_reached: true }),
    options: { ...better.options, ...(removals !== undefined && { removals }) },
    ...(mission && { mission: { ...mission, rules: { ...mission.rules, removals } } }),
    bound: rebound(plan.bound, reached(better), objective),
  };
}

// A bound beside another value than it was proven with.
function rebound(bound: Bound | null, value: number, objective: Objective): Bound | null {
  const limit = bound && valueOf(bound, objective);
  return bound && { ...bound, gap: limit && Number.isFinite(value) ? Math.max(0, value / limit - 1) : null };
}

// Where time was short, points can be better than they were planned: what fewer removals reach, more do, and what bounds
// more of them, bounds fewer. Of what is not known, nothing is said.
export function consistent(points: readonly FrontPoint[], objective: Objective): FrontPoint[] {
  const reached = (point: FrontPoint) => valueOf(point, objective) ?? Infinity;
  const limit = (point: FrontPoint) => (point.bound && valueOf(point.bound, objective)) ?? -Infinity;
  const bounded = (bound: FrontPoint["bound"], point: FrontPoint) => rebound(bound, reached(point), objective);
  const better: FrontPoint[] = [];
  for (const point of points) {
    const last = isUnknown(point) ? undefined : better.findLast((one) => !isUnknown(one));
    better.push(last && reached(last) < reached(point) ? { ...last, bound: bounded(point.bound, last) } : point);
  }
  for (let i = better.length - 2; i >= 0; --i) {
    if (limit(better[i + 1]!) > limit(better[i]!)) better[i] = { ...better[i]!, bound: bounded(better[i + 1]!.bound, better[i]!) };
  }
  return better;
}

// As many removals as save at least the price each: whatever number of the last is left out, it would cost more.
export function bestAtPrice(plans: readonly Plan[], price: number): Plan {
  const isWorth = (i: number, best: number) => {
    const saved = reached(plans[best]!) - reached(plans[i]!);
    return Number.isNaN(saved) || (saved > 1e-9 && saved > price * (i - best) - 1e-9); // NaN: no way with either
  };
  return plans[plans.reduce((best, _, i) => (isWorth(i, best) ? i : best), 0)]!;
}
