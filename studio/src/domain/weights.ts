// How much arrivals count in a sum.
import type { AgentDocument } from "./agent_document";
import { objectiveOf, type Plan } from "./plan";

// Whether arrivals count by weights: then their sum says nothing to anyone, but their average does.
export function isWeighed(plan: Plan): boolean {
  return weightsOf(plan).some((weight) => weight !== 1);
}

// What the objective is divided by where it is told.
export function averagedOver(plan: Plan): number {
  const sums = objectiveOf(plan) === "flowtime" && isWeighed(plan);
  return (sums && weightsOf(plan).reduce((sum, weight) => sum + weight, 0)) || 1;
}

function weightsOf({ mission }: Plan): number[] {
  return ((mission?.agents ?? []) as AgentDocument[]).map(({ weight = 1 }) => weight);
}
