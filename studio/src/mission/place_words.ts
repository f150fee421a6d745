// Places that are reached, sooner or not at all, in words.
import { plainName } from "../domain/plain_name";
import type { Agent, Plan } from "../domain/plan";
import type { PlaceState, Reach } from "../domain/reach";
import { arrival } from "../play/motion";

export const worthSaying = 1e-3; // of a time: paths bend at cell centres here or there

// `closed`: the plan with nothing removed, where it is known. Null where vehicles collide.
export function reachOf(plan: Plan, closed: Plan | null): Reach | null {
  if (plan.mission?.rules?.collisions !== false || plan.agents.length === 0) return null;
  const vehicles = plan.agents.filter(({ kind }) => kind === "ground");
  const before = new Map(closed?.agents.map((agent) => [agent.id, agent]));
  const count = (end: Reach["end"]) => new Set(vehicles.map((agent) => agent[end].join())).size;
  const end = count("goal") < count("start") ? "start" : "goal"; // many come to one place
  const states = new Map(vehicles.map((agent) => [agent.id, stateOf(agent, before.get(agent.id))]));
  return { end, states };
}

function stateOf(now: Agent, then: Agent | undefined): PlaceState {
  if (now.reached === false) return "not reached";
  if (then?.reached === false) return "only now";
  return then && arrival(now) < arrival(then) * (1 - worthSaying) ? "sooner" : "as before";
}

const mostNamed = 4;

// “28 of 30 places are reached, 12 of them sooner, 2 only now. Not reached: school, mill.”
export function reachWords({ states }: Reach): string {
  const withState = (wanted: PlaceState) => [...states].flatMap(([id, state]) => (state === wanted ? [id] : []));
  const missed = withState("not reached");
  const [all, reached] = [states.size, states.size - missed.length];
  const [sooner, only] = [withState("sooner").length, withState("only now").length];
  const who = missed.length === 0 ? (all === 1 ? "The place is" : `All ${all} places are`) : `${reached} of ${all} places are`;
  const gains = [...(sooner > 0 ? [`${sooner} of them sooner`] : []), ...(only > 0 ? [`${only} only now`] : [])];
  const named = missed.slice(0, mostNamed).map(plainName).join(", ");
  const others = missed.length > mostNamed ? ` and ${missed.length - mostNamed} more` : "";
  const not = missed.length > 0 ? ` Not reached: ${named}${others}.` : "";
  return `${[`${who} reached`, ...gains].join(", ")}.${not}`;
}
