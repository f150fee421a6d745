// Missions with everything that one can say.
import { type Abilities, usualAbilities } from "../../src/domain/abilities";
import { changed, type Agents, hasPaperMethod, type MissionAgent, usualId } from "../../src/domain/agents";
import type { Cell, Point, Run } from "../../src/domain/geometry";
import { type LayerName, type Mark, type Mission, wallKey } from "../../src/domain/mission";
import type { Zone } from "../../src/domain/zone";
import { union } from "../../src/mission/run_set";
import { type Random } from "./random";

export const [width, height] = [501, 400];
export const markers = { start: [1, 2] as Cell, goal: [3, 4] as Cell };

function randomRuns(random: Random): Run[] {
  const runs = Array.from({ length: random.below(30) }, (): Run => {
    const x = random.below(width);
    return [x, random.below(height), 1 + random.below(Math.min(40, width - x))];
  });
  return union(runs, []);
}

const noBattery = { range: null, endurance: null, reserve: 0, recharge: null, bases: [] };

function randomAbilities(random: Random): Abilities {
  if (random.chance(0.6)) return usualAbilities;
  return {
    breachTime: random.oneOf([null, 0, 20.5]),
    breachTimePerCell: random.oneOf([null, 0.0144]),
    mostArea: random.oneOf([null, null, 14400]), // whole cells, of any size below
    only: random.oneOf([null, null, [], [17, 4], [20, "barrier", "building=garage,a_b!,~%é& "], ["name=b=%c"]]),
  };
}

function randomAgents(random: Random, cell: () => Cell): Agents {
  const isPair = random.chance(0.5);
  const named = (usual: string) => (random.chance(0.3) ? random.oneOf([`${usual},~%é& `, "truck " + usual]) : usual);
  const idOf = (kind: MissionAgent["kind"], i: number) => named(isPair && random.chance(0.7) ? kind : usualId(kind, i));
  const vehicles = Array.from({ length: isPair ? 1 : 1 + random.below(5) }, (_, i): MissionAgent => ({
    kind: "ground",
    id: idOf("ground", i),
    start: cell(),
    goal: cell(),
    speed: random.oneOf([1, 2.5, 0.1 + 0.2]),
    radius: random.oneOf([0.5, 0, 1.5]),
    readyAt: random.oneOf([0, 0, 12.5]),
    breaches: 0,
    reach: random.oneOf([1, 1, 0, 2.5]),
    ...randomAbilities(random),
    weight: random.oneOf([1, 1, 1, 180.5]),
  }));
  const both = { range: 1e4, endurance: 90, reserve: 0.2, ...random.oneOf([{}, { recharge: 60.5 }, { recharge: 9, bases: [cell(), cell()] }]) };
  const aircraft = Array.from({ length: isPair ? 1 : random.below(3) }, (_, i): MissionAgent => ({
    kind: "air",
    id: idOf("air", i),
    start: random.chance(0.5) ? cell() : null,
    goal: random.chance(0.5) ? cell() : null,
    speed: random.oneOf([1, 10, 1 / 3]),
    breaches: random.oneOf([null, 0, 3]),
    ...random.oneOf([noBattery, noBattery, { ...noBattery, range: 900.5 }, { ...noBattery, ...both }]),
    ...randomAbilities(random),
    weight: random.oneOf([1, 1, 1, 0]),
  }));
  const agents = [...vehicles, ...aircraft];
  return agents.length === 1 ? changed(agents, 0, { breaches: random.below(4) }) : agents;
}

function randomZones(random: Random): Zone[] {
  const point = (): Point => [random.below(2 * width) / 2 - 20, random.below(2 * height) / 2];
  const ring = () => Array.from({ length: 3 + random.below(5) }, point);
  return Array.from({ length: random.below(3) }, (): Zone => ({
    kind: random.oneOf(["no_fly", "keep_out"] as const),
    name: random.oneOf(["", "helipad", "a;b:c/d,e & 100 % ü"]),
    agents: random.oneOf([[], [], ["air"], ["truck,~%é& ", "b:c"]]),
    rings: Array.from({ length: 1 + random.below(2) }, ring),
    ...random.oneOf([{}, {}, { from: 10.5 }, { until: 20 }, { from: 0, until: 1e-3 }]),
  }));
}

export function randomMission(random: Random): Mission {
  const cell = (): Cell => [random.below(width), random.below(height)];
  const key = () => (random.chance(0.8) ? 1 + random.below(5000) : wallKey(cell(), width));
  const marks = Array.from({ length: random.below(6) }, (): [number, Mark] => [
    key(),
    random.oneOf(["protect", "force", "exclude"] as const),
  ]);
  const layers: LayerName[] = (["before", "after", "paper"] as const).filter(() => random.chance(0.6));
  const agents = randomAgents(random, cell);
  const collisions = random.chance(0.7);
  const unreached = collisions ? null : random.oneOf([null, 4809.6]);
  return {
    map: random.oneOf(["berlin-mitte.tif", "a b&c=d.map", "Größe-1.map"]),
    agents,
    removals: random.oneOf([0, 1, 2, 8, "auto"] as const),
    price: random.oneOf([10, 0, 0.5]),
    method: hasPaperMethod({ agents, unreached }) ? random.oneOf(["exact", "paper"] as const) : "exact",
    objective: random.oneOf(["makespan", "ground-makespan", "flowtime"] as const),
    breachTime: random.oneOf([0, 12.5]),
    breachTimePerCell: random.oneOf([0, 0.0144]),
    rubble: random.oneOf([0, 12.5]),
    separation: collisions ? random.oneOf([0, 0.25]) : 0,
    collisions,
    unreached,
    atGoal: random.oneOf(["stay", "leave"] as const),
    marks: new Map(marks),
    protectAll: random.chance(0.3) ? [{ key: "*", values: [] }, { key: "name", values: ["b=%c", "St. Mary’s & Co*"] }] : [],
    walls: randomRuns(random),
    also: random.oneOf([{}, {}, { budget_m2: 300.5, moves: 4 }, { minimise_demolition: 0.05, corners: "cut" }]),
    erased: randomRuns(random),
    zones: randomZones(random),
    layers,
    bands: random.chance(0.7),
    time: random.oneOf([null, 0, 12.34]),
  };
}

export const sorted = (mission: Mission) => ({ ...mission, marks: [...mission.marks].sort((a, b) => a[0] - b[0]) });
