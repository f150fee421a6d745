// What happens when, as spans and moments of a timeline.
import type { Agent, Plan } from "../domain/plan";
import { breachOrder, positionAt, waits, wayOf } from "./motion";
import { nameOf, type Story } from "./story";

export interface Span {
  kind: "move" | "wait";
  from: number;
  until: number;
}

export interface Moment {
  number: number; // in the order of the breaches
  obstacle: number;
  time: number;
}

export interface Lane {
  id: string;
  kind: Agent["kind"];
  spans: Span[];
  opens: boolean; // obstacles, else what it enters
  moments: Moment[]; // breached by it; of a pair's ground agent: entered
}

// One for each agent, vehicles first.
export function lanes(plan: Plan): Lane[] {
  const order = breachOrder(plan);
  const vehicles = plan.agents.filter((agent) => agent.kind === "ground");
  const aircraft = plan.agents.filter((agent) => agent.kind === "air");
  return [...vehicles, ...aircraft].map(({ id, kind, ...agent }): Lane => {
    const opens = kind === "air" || plan.removed.some(({ by }) => by === id);
    const moments = order.flatMap(({ obstacle, by, cleared_at, entered_at }, i): Moment[] => {
      const time = opens ? cleared_at : entered_at;
      const isOthers = by !== undefined && by !== id; // who enters is not said of a team
      return time === null || isOthers ? [] : [{ number: i + 1, obstacle, time }];
    });
    return { id, kind, opens, spans: spans({ id, kind, ...agent }), moments };
  });
}

function spans(agent: Agent): Span[] {
  const found: Span[] = [];
  let at = agent.path[0]?.[2] ?? 0;
  const move = (until: number): void => {
    if (until > at) found.push({ kind: "move", from: at, until });
  };
  for (const { from, until } of agent.waits ?? waits(agent)) {
    move(from);
    found.push({ kind: "wait", from, until });
    at = until;
  }
  move(wayOf(agent).at(-1)?.[2] ?? 0);
  return found;
}

const mostTold = 6; // agents that are told of one by one

// What goes on at a time, in words: for those who do not see the map.
export function activityAt(story: Story, time: number): string {
  const { plan } = story;
  const parts = plan.agents.length > mostTold ? summed(plan, time) : each(story, time);
  const cleared = plan.removed.filter((removed) => removed.cleared_at <= time).length;
  if (plan.removed.length > 0) parts.push(`${cleared} of ${plan.removed.length} removed`);
  return parts.join(", ");
}

function each(story: Story, time: number): string[] {
  const { agents } = story.plan;
  const verbs = { ready: "is ready", moving: "moves", arrived: "has arrived" };
  return agents.flatMap((agent) => {
    const now = positionAt(agent, time);
    if (!now) return [];
    if (agent.lost && now.state === "arrived") return [`${nameOf(agent)} is lost`];
    const verb = now.state === "waiting" ? story.verbAt(agent.id, time) : verbs[now.state];
    return [`${nameOf(agent)} ${verb}`];
  });
}

function summed(plan: Plan, time: number): string[] {
  const states = plan.agents.map((agent) => positionAt(agent, time)?.state);
  const count = (wanted: string) => states.filter((state) => state === wanted).length;
  return [`${count("moving")} move`, `${count("waiting")} wait`, `${count("arrived")} have arrived`];
}
