// Missions with everything that one can say.
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

export function randomMission(random: Random): Mission {
  const cell = (): Cell => [random.below(width), random.below(height)];
  const key = () => (random.chance(0.8) ? 1 + random.below(5000) : wallKey(cell(), width));
  const marks = Array.from({ length: random.below(6) }, (): [number, Mark] => [
    key(),
    random.oneOf(["protect", "force", "exclude"] as const),
  ]);
  const layers: LayerName[] = (["before", "after", "paper"] as const).filter(() => random.chance(0.6));
  return {
    map: random.oneOf(["berlin-mitte.tif", "a b&c=d.map", "Größe-1.map"]),
    markers: {
      start: cell(),
      goal: cell(),
      ...(random.chance(0.3) && { air_start: cell() }),
      ...(random.chance(0.3) && { air_goal: cell() }),
    },
    removals: random.oneOf([0, 1, 2, 8, "auto"] as const),
    price: random.oneOf([10, 0, 0.5]),
    method: random.oneOf(["exact", "paper"] as const),
    objective: random.oneOf(["makespan", "ground-makespan", "flowtime"] as const),
    groundSpeed: random.oneOf([1, 2.5, 0.1 + 0.2]),
    airSpeed: random.oneOf([1, 10, 1 / 3]),
    breachTime: random.oneOf([0, 12.5]),
    breachTimePerCell: random.oneOf([0, 0.0144]),
    radius: random.oneOf([0.5, 0, 1.5]),
    marks: new Map(marks),
    walls: randomRuns(random),
    erased: randomRuns(random),
    layers,
    time: random.oneOf([null, 0, 12.34]),
  };
}

export const sorted = (mission: Mission) => ({ ...mission, marks: [...mission.marks].sort((a, b) => a[0] - b[0]) });
