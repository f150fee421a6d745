// What can go wrong while a mission is played.
import type { Run } from "../domain/geometry";
import type { Plan } from "../domain/plan";

// `at`: when it happens, on the plan's clock.
export type News =
  | { kind: "failed"; obstacle: number; at: number } // its breach left it standing
  | { kind: "rubble"; runs: readonly Run[]; at: number }
  | { kind: "delayed"; agent: string; by: number; at: number } // a vehicle stands still
  | { kind: "lost"; agent: string; at: number }; // an aircraft

// When it is known: a breach is seen to have failed when it was to be made, a delay when it is over.
export function knownAt(news: News): number {
  return news.kind === "delayed" ? news.at + news.by : news.at;
}

// That the breach of an obstacle fails, when it is tried; null if it is open already, or will not be breached.
export function failureOf(plan: Plan, obstacle: number, time: number): News | null {
  const breach = plan.removed.find((one) => one.obstacle === obstacle);
  return breach && breach.cleared_at >= time ? { kind: "failed", obstacle, at: breach.cleared_at } : null;
}
