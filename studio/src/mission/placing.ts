// Where one more agent starts and ends: near those that are there, with room for each.
import { abilitiesOnly, usualAbilities } from "../domain/abilities";
import {
  type Agents,
  type Aircraft,
  aircraftOf,
  type End,
  freshId,
  usualAircraft,
  usualVehicle,
  type Vehicle,
  vehiclesOf,
} from "../domain/agents";
import type { CellMap } from "../domain/cell_map";
import type { Cell } from "../domain/geometry";

const share = 0.05; // of the map's longer side: as far apart markers can be told from each other

// As the last vehicle, but that it clears nothing; null where there is no room.
export function oneVehicleMore(agents: Agents, cells: CellMap, separation: number): Vehicle | null {
  const vehicles = vehiclesOf(agents);
  const last = vehicles.at(-1)!;
  const place = (end: End) => freeNear(cells, last, last[end], vehicles.map((one) => discAt(one, end)), separation);
  const [start, goal] = [place("start"), place("goal")];
  const { readyAt, breaches, reach } = usualVehicle;
  return start && goal && { ...last, id: freshId(agents, "ground"), readyAt, breaches, reach, ...usualAbilities, start, goal };
}

// From and to where the first vehicle is, as fast as the last one, with such a battery and the same bases. It opens the same.
export function oneAircraftMore(agents: Agents): Aircraft {
  const last = aircraftOf(agents).at(-1) ?? usualAircraft;
  const { speed, range, endurance, reserve, recharge, bases } = last;
  const battery = { range, endurance, reserve, recharge, bases };
  return { kind: "air", id: freshId(agents, "air"), ...usualAircraft, speed, ...battery, ...abilitiesOnly(last) };
}

interface Disc {
  at: Cell;
  radius: number;
}

function discAt(vehicle: Vehicle, end: End): Disc {
  return { at: vehicle[end], radius: vehicle.radius };
}

// The nearest place, by way of free cells, that markers can be told apart at; or else the one with most room.
function freeNear(cells: CellMap, { radius }: Vehicle, from: Cell, others: Disc[], separation: number): Cell | null {
  const wished = share * Math.max(cells.width, cells.height);
  let best: Cell | null = null;
  let most = 0;
  for (const cell of reachable(cells, from)) {
    const room = Math.min(...others.map(({ at, radius: other }) => roomLeft(cell, at, radius + other + separation)));
    if (room <= most || !isClear(cells, cell, radius)) continue;
    [best, most] = [cell, room];
    if (room >= wished) break;
  }
  return best;
}

// How far two places are apart; 0 if that is too near.
function roomLeft([x, y]: Cell, [ox, oy]: Cell, needed: number): number {
  const apart = Math.hypot(x - ox, y - oy);
  return apart >= Math.max(needed, 1) ? apart : 0;
}

const most = 40_000; // cells that are looked at

// Cells that hang together with one by their sides, the nearest first.
function* reachable(cells: CellMap, from: Cell): Generator<Cell> {
  const seen = new Set([from[1] * cells.width + from[0]]);
  const open: Cell[] = [from];
  for (let i = 0; i < open.length && i < most; ++i) {
    const [x, y] = open[i]!;
    yield open[i]!;
    for (const [nx, ny] of [[x + 1, y], [x, y + 1], [x - 1, y], [x, y - 1]] as const) {
      const key = ny * cells.width + nx;
      const isInside = nx >= 0 && ny >= 0 && nx < cells.width && ny < cells.height;
      if (!isInside || seen.has(key) || cells.at(nx, ny) !== 0) continue;
      seen.add(key);
      open.push([nx, ny]);
    }
  }
}

// Whether a disc at a cell touches no blocked cell; beyond the map nothing stands.
function isClear(cells: CellMap, [x, y]: Cell, radius: number): boolean {
  const reach = Math.ceil(radius);
  for (let dy = -reach; dy <= reach; ++dy) {
    for (let dx = -reach; dx <= reach; ++dx) {
      const away = Math.hypot(Math.max(Math.abs(dx) - 0.5, 0), Math.max(Math.abs(dy) - 0.5, 0));
      if ((away < radius || (dx === 0 && dy === 0)) && cells.at(x + dx, y + dy) !== 0) return false;
    }
  }
  return true;
}
