// Waits in words, as the plan explains them: "waits for heli to open 2", "lets truck pass".
import { plainName } from "../domain/plain_name";
import type { Agent, ExplainedWait, Plan, Recharge } from "../domain/plan";
import { zoneName } from "../domain/zone";
import { breachOrder, positionAt } from "./motion";

const mostTold = 3;

export class Story {
  readonly #numbers: ReadonlyMap<number, number>; // by obstacle: those of the breaches

  constructor(readonly plan: Plan) {
    this.#numbers = new Map(breachOrder(plan).map(({ obstacle }, i) => [obstacle, i + 1]));
  }

  // What an agent that stands on its way at a time does.
  verbAt(id: string, time: number): string {
    const agent = this.plan.agents.find((one) => one.id === id);
    if (!agent) return "waits";
    if (agent.kind === "air") return this.#flownVerb(agent, time);
    const wait = agent.waits?.find(({ from, until }) => from <= time && time < until);
    return wait ? this.#drivenVerb(id, wait) : "waits";
  }

  // Who waits at a time, and what for; null if nobody does.
  at(time: number): string | null {
    const waiting = this.plan.agents.filter((agent) => positionAt(agent, time)?.state === "waiting");
    if (waiting.length === 0) return null;
    const told = waiting.slice(0, mostTold).map((agent) => `${nameOf(agent)} ${this.verbAt(agent.id, time)}`);
    const more = waiting.length - told.length;
    return [...told, ...(more > 0 ? [more === 1 ? "one more waits" : `${more} more wait`] : [])].join("; ");
  }

  #drivenVerb(id: string, { reason, obstacle, agent, zone }: ExplainedWait): string {
    if (reason === "readiness") return "is not ready yet";
    if (reason === "agent") return `lets ${nameOf({ id: agent!, kind: "ground" })} pass`;
    if (reason === "rubble") return `gets over ${this.#numbers.has(obstacle!) ? `the rubble of ${this.#numbers.get(obstacle!)}` : "rubble"}`;
    if (reason === "opening" && agent === undefined) return "waits for what opens by itself";
    if (reason === "opening" && agent === id) return `opens ${this.#numbers.get(obstacle!)}`;
    if (reason === "opening") return `waits for ${nameOf({ id: agent!, kind: "air" })} to open ${this.#numbers.get(obstacle!)}`;
    if (reason === "zone") return `waits until ${zoneName(this.plan.mission, zone!)} is over`;
    return "waits";
  }

  // Where it hovers it opens what is cleared next.
  #flownVerb({ id, path, recharges }: Agent, time: number): string {
    const recharge = recharges?.find(({ from, until }) => from <= time && time < until);
    if (recharge) return rechargeWords(recharge);
    const isIts = ({ by = id, at, cleared_at: cleared }: Plan["removed"][number]) =>
      by === id && cleared > time && path.some(([x, y, t]) => x === at[0] && y === at[1] && t <= time);
    const opened = breachOrder(this.plan).find(isIts);
    return opened ? `opens ${this.#numbers.get(opened.obstacle)}` : "waits";
  }
}

// "recharges at 120,45".
export function rechargeWords({ at }: Recharge): string {
  return `recharges at ${at.join()}`;
}

// An agent as a sentence names it: neither a number nor a kind alone is a name.
export function nameOf({ id, kind }: Pick<Agent, "id" | "kind">): string {
  if (id === kind) return kind === "ground" ? "the ground robot" : "the aircraft";
  return /^\d+$/.test(id) ? `${kind === "ground" ? "vehicle" : "aircraft"} ${id}` : plainName(id);
}
