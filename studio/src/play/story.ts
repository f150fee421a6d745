// Waits in words: "waits for heli to open 2", "lets truck pass".
import type { CellMap } from "../domain/cell_map";
import { plainName } from "../domain/plain_name";
import type { Agent, Plan } from "../domain/plan";
import { breachOrder, type Wait, waits } from "./motion";
import { Waiting } from "./waiting";

const mostTold = 3;

export class Story {
  readonly #waiting: Waiting;
  readonly #waits: ReadonlyMap<string, Wait[]>; // by agent
  readonly #numbers: ReadonlyMap<number, number>; // by obstacle: those of the breaches

  constructor(
    readonly plan: Plan,
    cells: CellMap,
  ) {
    this.#waiting = new Waiting(plan, cells);
    this.#waits = new Map(plan.agents.map((agent) => [agent.id, waits(agent)]));
    this.#numbers = new Map(breachOrder(plan).map(({ obstacle }, i) => [obstacle, i + 1]));
  }

  nameOf({ id, kind }: Pick<Agent, "id" | "kind">): string {
    return nameOf(id, kind);
  }

  // What an agent that stands on its way at a time does.
  verbAt(id: string, time: number): string {
    const agent = this.plan.agents.find((one) => one.id === id);
    const wait = this.#waits.get(id)?.find(({ from, until }) => from <= time && time < until);
    return agent && wait ? this.#verb(agent, wait) : "waits";
  }

  // Who waits at a time, and what for; null if nobody does.
  at(time: number): string | null {
    const waiting = this.plan.agents.filter(({ id }) =>
      this.#waits.get(id)!.some(({ from, until }) => from <= time && time < until),
    );
    if (waiting.length === 0) return null;
    const told = waiting.slice(0, mostTold).map((agent) => `${this.nameOf(agent)} ${this.verbAt(agent.id, time)}`);
    const more = waiting.length - told.length;
    return [...told, ...(more > 0 ? [more === 1 ? "one more waits" : `${more} more wait`] : [])].join("; ");
  }

  #verb(agent: Agent, wait: Wait): string {
    const cause = this.#waiting.causeOf(agent, wait);
    if (!cause) return "waits";
    if (cause.kind === "vehicle") return `lets ${nameOf(cause.id, "ground")} pass`;
    const number = this.#numbers.get(cause.removed.obstacle);
    if (cause.kind === "breach") return `opens ${number}`;
    const { by } = cause.removed;
    return `waits for ${by === undefined ? "the aircraft" : nameOf(by, "air")} to open ${number}`;
  }
}

// A number alone is no name.
function nameOf(id: string, kind: Agent["kind"]): string {
  return /^\d+$/.test(id) ? `${kind === "ground" ? "vehicle" : "aircraft"} ${id}` : plainName(id);
}
