// Who is where when, as a plan file says it. Times are the plan's: cells over speed.
import type { Point } from "../domain/geometry";
import type { Agent, Plan, Removed } from "../domain/plan";

export interface Position {
  x: number;
  y: number;
  heading: number; // radians, 0 to the right, clockwise on the screen
  state: "ready" | "moving" | "waiting" | "arrived";
}

export interface Wait {
  at: Point;
  from: number;
  until: number;
}

// The last point of the path reached by time t; 0 before the first.
function reached(path: Agent["path"], t: number): number {
  let low = 0;
  let high = path.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (path[middle]![2] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}

// The heading of an agent at point i: of its next move, past waits; at the end of its last move.
function headingAt(path: Agent["path"], i: number): number {
  for (let k = i; k + 1 < path.length; ++k) {
    const [ax, ay] = path[k]!;
    const [bx, by] = path[k + 1]!;
    if (ax !== bx || ay !== by) return Math.atan2(by - ay, bx - ax);
  }
  return i > 0 ? headingAt(path, i - 1) : 0;
}

export function positionAt(agent: Pick<Agent, "path">, t: number): Position | null {
  const path = agent.path;
  if (path.length === 0) return null;
  const i = reached(path, t);
  const [x, y, from] = path[i]!;
  const heading = headingAt(path, i);
  const next = path[i + 1];
  if (!next) return { x, y, heading, state: "arrived" };
  if (t < from) return { x, y, heading, state: "ready" };
  if (next[0] === x && next[1] === y) return { x, y, heading, state: "waiting" };
  const share = (t - from) / (next[2] - from);
  return { x: x + share * (next[0] - x), y: y + share * (next[1] - y), heading, state: "moving" };
}

// The way travelled by time t, and the way still to go; both hold the position at t.
export function splitAt(agent: Pick<Agent, "path">, t: number): { travelled: Point[]; ahead: Point[] } {
  const points = agent.path.map(([x, y]): Point => [x, y]);
  const now = positionAt(agent, t);
  if (!now) return { travelled: [], ahead: [] };
  const i = reached(agent.path, t);
  const here: Point = [now.x, now.y];
  return { travelled: [...points.slice(0, i + 1), here], ahead: [here, ...points.slice(i + 1)] };
}

// The way between two times.
export function partOf(agent: Pick<Agent, "path">, from: number, until: number): Point[] {
  const { path } = agent;
  const ends = [positionAt(agent, from), positionAt(agent, until)].map((at): Point[] => (at ? [[at.x, at.y]] : []));
  return [...ends[0]!, ...path.filter(([, , t]) => from < t && t < until).map(([x, y]): Point => [x, y]), ...ends[1]!];
}

// Until it stands for good: who is not reached stays where it is, at its start unless the plan has changed, for as long as
// that counts.
export function wayOf({ path, reached }: Pick<Agent, "path" | "reached">): Agent["path"] {
  if (reached !== false) return path;
  const [x, y] = path.at(-1) ?? [];
  const moved = path.findLastIndex(([px, py]) => px !== x || py !== y);
  return path.slice(0, moved + 2);
}

// Stops on the way, each whole even where the path has points within it.
export function waits(agent: Agent): Wait[] {
  const path = wayOf(agent);
  const found: Wait[] = [];
  for (let i = 0; i + 1 < path.length; ++i) {
    const [x, y, from] = path[i]!;
    const [nx, ny, until] = path[i + 1]!;
    if (x !== nx || y !== ny || until <= from) continue;
    const last = found.at(-1);
    if (last && last.until === from && last.at[0] === x && last.at[1] === y) last.until = until;
    else found.push({ at: [x, y], from, until });
  }
  return found;
}

// When an agent is where it wants to be.
export function arrival(agent: Agent): number {
  return agent.path.at(-1)?.[2] ?? 0;
}

export function duration(plan: Plan): number {
  return Math.max(0, ...plan.agents.map((agent) => wayOf(agent).at(-1)?.[2] ?? 0));
}

export function clearedAt(plan: Plan, t: number): Removed[] {
  return plan.removed.filter((removed) => removed.cleared_at <= t);
}

// What is removed, in the order in which it is breached: the numbers on the map and in the table.
export function breachOrder(plan: Plan): Removed[] {
  return [...plan.removed].sort((a, b) => a.cleared_at - b.cleared_at);
}

export function agentOf(plan: Plan, kind: Agent["kind"]): Agent | undefined {
  return plan.agents.find((agent) => agent.kind === kind);
}
