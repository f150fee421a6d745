// What happens when, as spans and moments of a timeline.
import type { Agent, Plan } from "../domain/plan";
import { agentOf, arrival, breachOrder, positionAt, waits } from "./motion";

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
  kind: Agent["kind"];
  spans: Span[];
  moments: Moment[]; // ground: entered; air: breached
}

export function lanes(plan: Plan): Lane[] {
  const order = breachOrder(plan);
  return (["ground", "air"] as const).flatMap((kind): Lane[] => {
    const agent = agentOf(plan, kind);
    if (!agent) return [];
    const moments = order.flatMap(({ obstacle, cleared_at, entered_at }, i): Moment[] => {
      const time = kind === "air" ? cleared_at : entered_at;
      return time === null ? [] : [{ number: i + 1, obstacle, time }];
    });
    return [{ kind, spans: spans(agent), moments }];
  });
}

function spans(agent: Agent): Span[] {
  const found: Span[] = [];
  let at = agent.path[0]?.[2] ?? 0;
  const move = (until: number): void => {
    if (until > at) found.push({ kind: "move", from: at, until });
  };
  for (const { from, until } of waits(agent)) {
    move(from);
    found.push({ kind: "wait", from, until });
    at = until;
  }
  move(arrival(agent));
  return found;
}

// What goes on at a time, in words: for those who do not see the map.
export function activityAt(plan: Plan, time: number): string {
  const verbs = { ready: "is ready", moving: "moves", waiting: "waits", arrived: "has arrived" };
  const parts = plan.agents.flatMap((agent) => {
    const now = positionAt(agent, time);
    return now ? [`${agent.kind} ${verbs[now.state]}`] : [];
  });
  const cleared = plan.removed.filter((removed) => removed.cleared_at <= time).length;
  if (plan.removed.length > 0) parts.push(`${cleared} of ${plan.removed.length} removed`);
  return parts.join(", ");
}
