// What the vehicles of a plan drive over, in plain words.
import { type Plan, type Surface } from "../domain/plan";
import { length, type Units } from "../domain/units";

// Of all ground agents together; null where the map does not know.
export function surfaceWords(plan: Plan, units: Units): string | null {
  const surfaces = plan.agents.flatMap(({ surface }) => surface ?? []);
  if (surfaces.length === 0) return null;
  const sum = (of: (surface: Surface) => number) => surfaces.reduce((all, one) => all + of(one), 0);
  const shows = (cells: number) => cells * units.cell >= 0.5; // rounds to more than nothing
  const parts = [
    `${length(sum((s) => s.ways), units)} on ways`,
    `${length(sum((s) => s.off_ways), units)} off ways`,
  ];
  const unknown = sum((s) => s.unknown);
  if (shows(unknown)) parts.push(`${length(unknown, units)} on unknown ground`);
  const wet = sum((s) => s.near_water ?? 0);
  const water = shows(wet) ? `; ${length(wet, units)} within 5\u00a0m of water` : "";
  const count = plan.agents.filter(({ kind }) => kind === "ground").length;
  const who = count > 1 ? "The vehicles drive" : "The ground robot drives";
  return `${who} ${parts.join(", ")}${water}.`;
}
