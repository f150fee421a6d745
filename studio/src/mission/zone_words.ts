// Zones with times in plain words.
import type { Plan } from "../domain/plan";
import { duration, type Units } from "../domain/units";
import { zoneName } from "../domain/zone";
import { nameOf } from "../play/story";
import type { Headline } from "./words";

// Which zone stands in whose way, where there is no plan for that; else null. `units`: of times, not of the objective's values.
export function barredHeadline({ barred_by: barred, mission }: Plan, units: Units): Headline | null {
  if (!barred) return null;
  const agents = (mission?.agents ?? []) as { id?: string; kind: "ground" | "air" }[];
  const agent = agents.find(({ id, kind }) => (id ?? kind) === barred.agent);
  const who = nameOf({ id: barred.agent, kind: agent?.kind ?? "ground" });
  return {
    tone: "bad",
    title: `No plan was found: after ${duration(barred.at, units)}, ${zoneName(mission, barred.zone)} stands in the way of ${who}`,
    figures: null,
    remedies: ["Give the zone other times, or remove it.", "Move start and goal away from it."],
  };
}
