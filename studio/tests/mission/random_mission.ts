// Missions with everything that one can say.
import { type Agents, isPair, type MissionAgent, pair, usualId } from "../../src/domain/agents";
import type { Cell, Run } from "../../src/domain/geometry";
import { type LayerName, type Mark, type Mission, wallKey } from "../../src/domain/mission";
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

function randomPair(random: Random, cell: () => Cell): Agents {
  const [ground, air] = pair(cell(), cell());
  const ofGround = { speed: random.oneOf([1, 2.5, 0.1 + 0.2]), radius: random.oneOf([0.5, 0, 1.5]) };
  const places = { ...(random.chance(0.3) && { start: cell() }), ...(random.chance(0.3) && { goal: cell() }) };
  return [{ ...ground!, ...ofGround }, { ...air!, ...places, speed: random.oneOf([1, 10, 1 / 3]) }] as Agents;
}

function randomTeam(random: Random, cell: () => Cell): Agents {
  const named = (usual: string) => (random.chance(0.3) ? random.oneOf([`${usual},~%é& `, "truck " + usual]) : usual);
  const vehicles = Array.from({ length: 2 + random.below(4) }, (_, i): MissionAgent => ({
    kind: "ground",
    id: named(usualId("ground", i)),
    start: cell(),
    goal: cell(),
    speed: random.oneOf([1, 2.5, 0.1 + 0.2]),
    radius: random.oneOf([0.5, 0, 1.5]),
    readyAt: random.oneOf([0, 0, 12.5]),
  }));
  const aircraft = Array.from({ length: random.below(3) }, (_, i): MissionAgent => ({
    kind: "air",
    id: named(usualId("air", i)),
    start: random.chance(0.5) ? cell() : null,
    goal: random.chance(0.5) ? cell() : null,
    speed: random.oneOf([1, 10, 1 / 3]),
    breaches: random.oneOf([null, 0, 3]),
  }));
  return [...vehicles, ...aircraft];
}

export function randomMission(random: Random): Mission {
  const cell = (): Cell => [random.below(width), random.below(height)];
  const key = () => (random.chance(0.8) ? 1 + random.below(5000) : wallKey(cell(), width));
  const marks = Array.from({ length: random.below(6) }, (): [number, Mark] => [
    key(),
    random.oneOf(["protect", "force", "exclude"] as const),
  ]);
  const layers: LayerName[] = (["before", "after", "paper"] as const).filter(() => random.chance(0.6));
  const agents = random.chance(0.5) ? randomPair(random, cell) : randomTeam(random, cell);
  const isTeam = !isPair(agents);
  return {
    map: random.oneOf(["berlin-mitte.tif", "a b&c=d.map", "Größe-1.map"]),
    agents,
    removals: random.oneOf([0, 1, 2, 8, "auto"] as const),
    price: random.oneOf([10, 0, 0.5]),
    method: isTeam ? "exact" : random.oneOf(["exact", "paper"] as const),
    objective: random.oneOf(["makespan", "ground-makespan", "flowtime"] as const),
    breachTime: random.oneOf([0, 12.5]),
    breachTimePerCell: random.oneOf([0, 0.0144]),
    separation: isTeam ? random.oneOf([0, 0.25]) : 0,
    atGoal: isTeam ? random.oneOf(["stay", "leave"] as const) : "stay",
    marks: new Map(marks),
    protectAll: random.chance(0.3) ? [{ key: "*", values: [] }, { key: "name", values: ["b=%c", "St. Mary’s & Co*"] }] : [],
    walls: randomRuns(random),
    also: random.oneOf([{}, {}, { budget_m2: 300.5, moves: 4 }, { minimise_demolition: 0.05, corners: "cut" }]),
    erased: randomRuns(random),
    layers,
    time: random.oneOf([null, 0, 12.34]),
  };
}

export const sorted = (mission: Mission) => ({ ...mission, marks: [...mission.marks].sort((a, b) => a[0] - b[0]) });
