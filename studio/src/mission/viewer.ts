// The page of a single plan: everything is in the document, no server is needed.
import { signal } from "@preact/signals";
import type { CheckReport } from "../api/client";
import { CellMap } from "../domain/cell_map";
import type { Background, MapDescription, Obstacles } from "../domain/map";
import { defaults, type LayerName, type Mission } from "../domain/mission";
import type { FrontPoint, Plan } from "../domain/plan";
import { type Judged, type Results, verdictOf } from "../planning/results";
import { begin } from "./history";
import { PageState } from "./page_state";
import { markersOf } from "./plan_mission";
import { Translation } from "./translate";

export interface PlanDocument {
  map: MapDescription;
  obstacles: Obstacles;
  background: Background;
  plans: { name: "plan" | "before" | "paper"; plan: Plan; check?: CheckReport }[]; // checked when the page was written
  front?: FrontPoint[];
}

export function viewerOf(document: PlanDocument): PageState {
  const plans: Partial<Record<LayerName, Judged>> = {};
  for (const { name, plan, check } of document.plans) {
    plans[name === "plan" ? "after" : name] = { plan, verdict: check ? verdictOf(check) : null };
  }
  const plan = plans.after?.plan;
  const front = document.front ?? plan?.front ?? [];
  const results: Results = {
    plans: signal(plans),
    front: signal(front.length > 0 ? { points: front, from: plan?.options.force?.length ?? 0, key: "", isDone: true } : null),
    answered: signal(null),
    progress: signal(null),
    failure: signal(null),
  };
  const speeds = plan?.agents.map((agent) => agent.speed);
  const page = new PageState(results, speeds);
  const cells = new CellMap(document.obstacles);
  const map = { description: document.map, cells, background: document.background };
  page.shown.value = { base: map, map, ids: new Translation(cells, cells, []) };
  page.history.value = begin(missionOf(document.map.id, plan, Object.keys(plans) as LayerName[]));
  page.loading.value = false;
  return page;
}

function missionOf(map: string, plan: Plan | undefined, layers: LayerName[]): Mission {
  const ground = plan?.agents.find((agent) => agent.kind === "ground");
  const air = plan?.agents.find((agent) => agent.kind === "air");
  return {
    ...defaults,
    map,
    markers: ground ? markersOf(ground, air) : { start: [0, 0], goal: [0, 0] },
    removals: Math.min(plan?.options.removals ?? 0, 8),
    objective: plan?.options.objective ?? "makespan",
    layers: (["before", "after", "paper"] as const).filter((name) => layers.includes(name) && name !== "paper"),
  };
}
