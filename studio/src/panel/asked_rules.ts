// The rules of a plan beside how many removals there may be, in words.
import type { Plan } from "../domain/plan";
import { squareMetres } from "../domain/units";

// "at most 300 m² demolished; 2 obstacles protected"; null where there are none.
export function askedRules(plan: Plan): string | null {
  const rules: Record<string, unknown> = { ...plan.options, ...plan.mission?.rules };
  const number = (name: string) => (typeof rules[name] === "number" ? (rules[name] as number) : null);
  const [area, weight, share] = [number("budget_m2"), number("budget"), number("minimise_demolition")];
  const [kept, forced] = [countOf(rules["protect"]), countOf(rules["force"])];
  const parts = [];
  if (area !== null) parts.push(`at most ${squareMetres(area)} demolished`);
  if (weight !== null) parts.push(`removals that weigh at most ${weight}`);
  if (share === 0) parts.push("of the best plans the one that demolishes least");
  if (share) parts.push(`the least demolition within ${+(100 * share).toPrecision(3)} % of the best plan`);
  if (rules["collisions"] === false) parts.push("vehicles pass through each other");
  if (kept > 0) parts.push(`${kept === 1 ? "1 obstacle" : `${kept} obstacles`} protected`);
  if (forced > 0) parts.push(`${forced === 1 ? "1 obstacle" : `${forced} obstacles`} to be removed`);
  return parts.length > 0 ? parts.join("; ") : null;
}

function countOf(list: unknown): number {
  return Array.isArray(list) ? list.length : 0;
}
