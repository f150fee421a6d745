// What agents open, in words.
import { type Abilities, opens } from "../domain/abilities";
import { type Agents, mayBreach } from "../domain/agents";
import type { Obstacle } from "../domain/map";
import { area, type Units } from "../domain/units";

// “up to 300 m², only what is named, in its own time”; “anything” where nothing is said.
export function abilityWords({ breachTime, breachTimePerCell, mostArea, only }: Abilities, units: Units): string {
  if (only?.length === 0) return "nothing";
  const said = [
    ...(mostArea === null ? [] : [`up to ${area(mostArea / units.cell ** 2, units)}`]),
    ...(only === null ? [] : ["only what is named"]),
    ...(breachTime === null && breachTimePerCell === null ? [] : ["in its own time"]),
  ];
  return said.join(", ") || "anything";
}

const mostNamed = 12;

// “Only obstacles 17, 20 and barrier”
export function onlyWords(only: readonly (number | string)[]): string {
  if (only.length === 0) return "No obstacle";
  const ids = only.filter((one) => typeof one === "number").length;
  const noun = ids === 0 ? "" : ids === 1 ? "obstacle " : "obstacles ";
  const named = only.slice(0, mostNamed).map(String);
  const others = only.length - named.length;
  const last = others > 0 ? `${others} more` : named.pop()!;
  return `Only ${noun}${named.length > 0 ? `${named.join(", ")} and ` : ""}${last}`;
}

// Why none of those who may open anything opens an obstacle, by its id on the map before anything was drawn; null where one does.
export function whyNobodyOpens(agents: Agents, obstacle: Obstacle, { cell }: Units): string | null {
  const openers = agents.filter(mayBreach);
  if (openers.length === 0 || openers.some((agent) => opens(agent, obstacle, cell))) return null;
  const isTooLarge = openers.every(({ mostArea }) => !opens({ mostArea, only: null }, obstacle, cell));
  return isTooLarge ? "Too large for all who open the way here." : "Not among what anybody here opens.";
}
