// The state of a plan at a time (docs/live.md): where each agent is on its path, what it does, and the news.
import type { AgentState, StateDocument } from "../api/documents";
import type { Point } from "../domain/geometry";
import { type Agent, ownBreaches, type Plan, type TimedPoint } from "../domain/plan";
import { cellsOf } from "../domain/rubble";
import { knownAt, type News } from "./news";
import { retimed, type Stop } from "./retimed";

// What is reported when the news is known. Agents are where the plan has them by then, but for whom a delay makes late.
export function stateOf(plan: Plan, news: News): StateDocument {
  const now = knownAt(news);
  const late = news.kind === "delayed" ? retimed(plan, news.agent, news.at, news.by) : null;
  const agents = plan.agents.map((agent): AgentState => {
    const place = placeOn(late?.get(agent.id) ?? stopsOn(agent.path), now);
    const isLost = news.kind === "lost" && news.agent === agent.id;
    return { id: agent.id, passed: place.passed, at: place.at, doing: isLost ? "lost" : doingOf(plan, agent, place, now) };
  });
  return {
    format: "waybreaker-state/1",
    sequence: (plan.revision?.sequence ?? 0) + 1,
    now,
    agents,
    failed: news.kind === "failed" ? [{ obstacle: news.obstacle, at: news.at }] : [],
    found: news.kind === "rubble" ? [{ cells: cellsOf(news.runs), blocked: true }] : [],
  };
}

interface Place {
  passed: number; // the last point of the planned path that it has reached
  at: Point;
  stands: boolean;
}

function placeOn(stops: readonly Stop[], time: number): Place {
  let last = 0;
  while (last + 1 < stops.length && stops[last + 1]!.arrives <= time) ++last;
  const [stop, next] = [stops[last]!, stops[last + 1]];
  const passed = Math.floor(stop.position);
  const stands = !next || time < stop.leaves || (next.x === stop.x && next.y === stop.y);
  if (stands) return { passed, at: [stop.x, stop.y], stands };
  const share = (time - stop.leaves) / (next.arrives - stop.leaves);
  const at: Point = [stop.x + share * (next.x - stop.x), stop.y + share * (next.y - stop.y)];
  return { passed, at, stands };
}

function stopsOn(path: readonly TimedPoint[]): Stop[] {
  return path.map(([x, y, t], position) => ({ position, x, y, arrives: t, leaves: t }));
}

// Less than one can see: an aircraft that is revised while it leaves a breach cell begins beside its centre.
const beside = 1e-6;

// An aircraft that stands is at work on what it clears next, if it does so there.
function doingOf({ removed }: Plan, agent: Agent, { at, stands }: Place, now: number): AgentState["doing"] {
  const { id, kind } = agent;
  if (!stands) return "driving";
  if (kind === "ground") return ownBreaches(agent).some(({ from, until }) => from <= now && now < until) ? "breaching" : "waiting";
  const isAtWork = removed.some(
    ({ by = id, at: [x, y], cleared_at: cleared }) => by === id && cleared > now && Math.hypot(x - at[0], y - at[1]) < beside,
  );
  return isAtWork ? "breaching" : "driving";
}
