// The page of a single plan: everything is in the document, no server is needed.
import { signal } from "@preact/signals";
import type { CheckReport } from "../api/client";
import { Bands, type ReachDocument } from "../domain/bands";
import { CellMap } from "../domain/cell_map";
import type { Background, MapDescription, Obstacles } from "../domain/map";
import { freshMission, type LayerName, type Mission } from "../domain/mission";
import { type FrontPoint, objectiveOf, paceOf, type Plan, valueOf } from "../domain/plan";
import { consistent } from "../planning/curve";
import { type Judged, type Results, verdictOf } from "../planning/results";
import { begin } from "./history";
import { PageState } from "./page_state";
import { missionOfPlan } from "./plan_mission";
import { Translation } from "./translate";

export interface PlanDocument {
  map: MapDescription;
  obstacles: Obstacles;
  background: Background;
  plans: { name: "plan" | "before" | "paper"; plan: Plan; check?: CheckReport }[]; // checked when the page was written
  front?: FrontPoint[];
  reach?: ReachDocument; // of many places
}

export function viewerOf(document: PlanDocument): PageState {
  const plans: Partial<Record<LayerName, Judged>> = {};
  for (const { name, plan, check } of document.plans) {
    plans[name === "plan" ? "after" : name] = { plan, verdict: check ? verdictOf(check) : null };
  }
  const plan = plans.after?.plan;
  const front = plan ? frontOf(document.front ?? plan.front ?? [], plan) : [];
  const results: Results = {
    plans: signal(plans),
    front: signal(front.length > 0 ? { points: front, from: plan?.options.force?.length ?? 0, key: "", isDone: true } : null),
    answered: signal(null),
    working: signal(false),
    progress: signal(null),
    failure: signal(null),
  };
  const page = new PageState(results, plan && paceOf(plan));
  const cells = new CellMap(document.obstacles);
  const map = { description: document.map, cells, background: document.background };
  page.shown.value = { base: map, map, ids: new Translation(cells, cells, []) };
  page.history.value = begin(missionOf(document.map.id, plan, Object.keys(plans) as LayerName[]));
  if (document.reach) page.bands.value = Bands.of(document.reach);
  page.loading.value = false;
  return page;
}

// The plan itself may have had more time than its point of the curve.
function frontOf(points: readonly FrontPoint[], plan: Plan): FrontPoint[] {
  const objective = objectiveOf(plan);
  const own: FrontPoint = { ...plan.after, bound: plan.bound, removed: plan.removed.map((one) => one.obstacle) };
  const index = (plan.options.removals ?? 0) - (plan.options.force?.length ?? 0);
  const isBetter = (point: FrontPoint) => (valueOf(own, objective) ?? Infinity) < (valueOf(point, objective) ?? Infinity);
  return consistent(points.map((point, i) => (i === index && isBetter(point) ? { ...planned(point), ...own } : point)), objective);
}

function planned({ status, ...point }: FrontPoint): FrontPoint {
  return point;
}

function missionOf(map: string, plan: Plan | undefined, layers: LayerName[]): Mission {
  const mission = (plan && missionOfPlan(plan, map)) ?? freshMission(map, { start: [0, 0], goal: [0, 0] });
  return {
    ...mission,
    removals: Math.min(plan?.options.removals ?? 0, 8),
    method: "exact",
    marks: new Map(),
    layers: (["before", "after", "paper"] as const).filter((name) => layers.includes(name) && name !== "paper"),
  };
}
