// The places of a mission that can be dragged. A marker that stands where others do sits beside them as a small handle,
// by which it can be pulled off.
import { type Agents, cellOf, type Handle, handlesOf, isPair, type MissionAgent } from "../../domain/agents";
import type { Point } from "../../domain/geometry";

export interface Spot {
  handle: Handle;
  agent: MissionAgent;
  at: Point; // pixels
  attached: boolean; // beside others
  named: boolean; // of a team: a goal beside its own start needs no name
}

const reach = 24; // pixels around a marker within which a finger meets it
const stacked = 23; // pixels from one marker of a team to the next at one place
const beside = 29; // pixels from the start of an aircraft to its goal at one place

// Where markers are drawn; `toPixels` as the camera has it. Those of a team are stacked, for they have names in them.
export function spots(agents: Agents, toPixels: (point: Point) => Point): Spot[] {
  const two = isPair(agents);
  const taken = new Map<string, number>(); // how many stand on a cell
  return handlesOf(agents).map((handle, i, all) => {
    const agent = agents[handle.agent]!;
    const key = cellOf(agents, handle).join();
    const before = taken.get(key) ?? 0;
    const [x, y] = toPixels(cellOf(agents, handle));
    const isHome = !two && handle.end === "goal" && cellOf(agents, all[i - 1]!).join() === key;
    if (isHome) return { handle, agent, at: [x + beside, y - stacked * (before - 1)], attached: true, named: false };
    taken.set(key, before + 1);
    const at: Point = two && before > 0 ? [x + 17 * before, y - 17 * before] : [x, y - stacked * before];
    return { handle, agent, at, attached: before > 0, named: true };
  });
}

export function spotAt(all: readonly Spot[], [x, y]: Point): Spot | null {
  let best: Spot | null = null;
  let distance = reach;
  for (const spot of all) {
    const away = Math.hypot(spot.at[0] - x, spot.at[1] - y);
    if (away >= distance) continue;
    best = spot;
    distance = away;
  }
  return best;
}
