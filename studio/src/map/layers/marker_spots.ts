// The places of a mission that can be dragged. A marker that stands where others do sits beside them, by which it can be
// pulled off: none covers another.
import { type Agents, cellOf, type Handle, handlesOf, isPair, type MissionAgent } from "../../domain/agents";
import type { Box, Point } from "../../domain/geometry";
import { boxAround, Boxes, middleOf, nearby } from "./free_places";

export interface Spot {
  handle: Handle;
  agent: MissionAgent;
  place: Point; // pixels
  at: Point; // where its marker stands: there, or beside others
  box: Box; // what the marker covers
  attached: boolean; // another has the same place
  named: boolean; // of a team: a goal beside its own start needs no name, and in a crowd not all have room
}

interface Look {
  widthOf?: (id: string) => number; // of a team's marker with a name in it
  first?: number | null; // the agent that matters most in a crowd
}

export const markerRadius = 13;
export const smallRadius = 9; // of one that sits with another
export const nameHeight = 20;
export const dotRadius = 5; // of a marker without a name
export const halo = 2; // around each

const reach = 24; // pixels around a marker within which a finger meets it
const crowd = 30; // agents: for the names of more there is no room

// Where markers are drawn; `toPixels` as the camera has it.
export function spots(agents: Agents, toPixels: (point: Point) => Point, look: Look = {}): Spot[] {
  const taken = new Set<number | string>();
  const wanted = handlesOf(agents).map((handle): Spot => {
    const cell = cellOf(agents, handle);
    const place = toPixels(cell);
    const attached = taken.has(cell.join());
    taken.add(cell.join());
    return { handle, agent: agents[handle.agent]!, place, at: place, box: boxAround(place, 0, 0), attached, named: true };
  });
  return isPair(agents) ? ofPair(wanted) : ofTeam(wanted, look);
}

// Discs; the small ones above to the right of what they are attached to, if there is room.
function ofPair(wanted: readonly Spot[]): Spot[] {
  const placed: { at: Point; size: number }[] = [];
  return wanted.map((spot) => {
    const size = spot.attached ? smallRadius : markerRadius;
    const isFree = ([x, y]: Point) =>
      placed.every((other) => Math.hypot(x - other.at[0], y - other.at[1]) >= size + other.size + halo);
    const tried = [...(spot.attached ? [] : [spot.place]), ...around(spot.place)];
    const at = tried.find(isFree) ?? spot.place;
    placed.push({ at, size });
    return { ...spot, at, box: boxAround(at, 2 * (size + halo), 2 * (size + halo)) };
  });
}

// Above to the right first, then the other way round, further and further away.
function around([x, y]: Point): Point[] {
  const turn = (at: number, away: number): Point => {
    const angle = -Math.PI / 4 + (at * Math.PI) / 6;
    return [x + away * Math.cos(angle), y + away * Math.sin(angle)];
  };
  return [25, 40, 55, 70].flatMap((away) => Array.from({ length: 12 }, (_, i) => turn(i, away)));
}

// Whoever has a place of his own keeps it; the others stand around theirs, vehicles first.
function ofTeam(wanted: readonly Spot[], { widthOf = usualWidth, first = null }: Look): Spot[] {
  const crowded = wanted.length > 2 * crowd;
  const rings = crowded ? 1 : 8;
  const boxes = new Boxes();
  const done: Spot[] = [...wanted];
  const isHome = ({ handle, place }: Spot, i: number) => handle.end === "goal" && samePlace(place, wanted[i - 1]!.place);
  const rank = (spot: Spot, i: number) =>
    crowded && spot.handle.agent === first ? 0 : isHome(spot, i) ? 4 : spot.attached ? 2 + Number(spot.agent.kind === "air") : 1;
  const order = wanted.map((spot, i) => ({ spot, i, rank: rank(spot, i) })).sort((a, b) => a.rank - b.rank);
  for (const { spot, i, rank } of order) {
    const dot = 2 * (dotRadius + halo);
    if (rank === 4) {
      const { box: start } = done[i - 1]!;
      const [x, y] = middleOf(start);
      const beside = (start.right - start.left) / 2 + dot / 2 + 2;
      const box = boxes.take([[x + beside, y], [x - beside, y], ...nearby([x, y], dot + 2, dot + 2, 2 * rings)], dot, dot);
      done[i] = settled(spot, box ?? boxAround([x + beside, y], dot, dot), false);
      continue;
    }
    const width = widthOf(spot.agent.id) + 2 * halo;
    const height = nameHeight + 2 * halo;
    const down = height + 0.6;
    const across = crowded ? 0 : 0.7 * width + nameHeight / 2;
    const box = boxes.take(nearby(spot.place, across, down, rings), width, height);
    done[i] = settled(spot, box ?? boxAround(spot.place, dot, dot), box !== null);
  }
  return done;
}

function settled(spot: Spot, box: Box, named: boolean): Spot {
  return { ...spot, box, at: middleOf(box), named };
}

function samePlace(a: Point, b: Point): boolean {
  return a[0] === b[0] && a[1] === b[1];
}

function usualWidth(id: string): number {
  return Math.max(nameHeight, 8 * id.length + 10);
}

export function spotAt(all: readonly Spot[], [x, y]: Point): Spot | null {
  let best: Spot | null = null;
  let distance = reach;
  for (const spot of all) {
    const along = Math.max(0, (spot.box.right - spot.box.left - spot.box.bottom + spot.box.top) / 2); // of a wide one
    const away = Math.hypot(Math.max(0, Math.abs(spot.at[0] - x) - along), spot.at[1] - y);
    if (away >= distance) continue;
    best = spot;
    distance = away;
  }
  return best;
}

// Points that badges keep off, so that they cover no marker.
export function keptClear(all: readonly Spot[]): Point[] {
  return all.flatMap(({ box, at: [, y] }) => {
    const reach = (box.bottom - box.top) / 2;
    const count = Math.max(1, Math.ceil((box.right - box.left - 2 * reach) / 20) + 1);
    const step = count === 1 ? 0 : (box.right - box.left - 2 * reach) / (count - 1);
    return Array.from({ length: count }, (_, i): Point => [box.left + reach + i * step, y]);
  });
}
