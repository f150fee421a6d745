// What is offered to go wrong: delays worth a look, and where rubble falls ahead of a vehicle.
import type { Cell } from "../domain/geometry";
import type { Agent } from "../domain/plan";
import { positionAt } from "../play/motion";

const nice = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600]; // seconds, or steps

// A short delay and a long one: round numbers, near a thirtieth and an eighth of the mission. `unit`: seconds of one of time.
export function usualDelays(mission: number, unit: number): number[] {
  const round = (time: number) => nice.reduce((best, one) => (Math.abs(one - time) < Math.abs(best - time) ? one : best));
  return [...new Set([30, 8].map((part) => round((mission * unit) / part) / unit))];
}

// The cell so far ahead on the way of an agent; null if that is too near to its end.
export function cellAhead(agent: Pick<Agent, "path">, time: number, ahead: number): Cell | null {
  const now = positionAt(agent, time);
  if (!now) return null;
  let [x, y] = [now.x, now.y];
  let left = ahead;
  for (const [px, py, t] of agent.path) {
    if (t <= time) continue;
    const length = Math.hypot(px - x, py - y);
    if (length >= left) return [Math.round(x + (left / length) * (px - x)), Math.round(y + (left / length) * (py - y))];
    left -= length;
    [x, y] = [px, py];
  }
  return null;
}
