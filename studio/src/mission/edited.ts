// The edits of a map that are sent to the service.
import type { Edits } from "../api/client";
import type { Agents } from "../domain/agents";
import type { CellMap } from "../domain/cell_map";
import type { Run } from "../domain/geometry";
import { marked, type Mission } from "../domain/mission";
import { matches, parseTagFilters, type TagFilter } from "../domain/tag_filter";
import type { ShownMap } from "./maps";
import { clipped, difference, union } from "./run_set";

// First the free cells hold, then the blocked ones: what is drawn over something that stands or was erased is a wall.
export function editsOf(mission: Mission, base: CellMap): Edits {
  const excluded = marked(mission, "exclude").flatMap((id) => base.runsOf(id));
  const beneath = blockedOf(base, mission.walls);
  return { block: [...mission.walls], free: union(mission.erased, union(excluded, beneath)) };
}

// The mission after a stroke. A wall goes through what stands there, so that a stroke is one wall and nothing passes it; the
// eraser takes drawn walls first, and what is beneath stands again.
export function drawn(
  mission: Mission,
  tool: "wall" | "erase",
  runs: readonly Run[],
  { base, map }: Pick<ShownMap, "base" | "map">,
): Mission {
  const stroke = clipped(runs, map.cells.width, map.cells.height);
  if (tool === "wall") {
    return { ...mission, walls: union(mission.walls, stroke) };
  }
  return {
    ...mission,
    walls: difference(mission.walls, stroke),
    erased: union(mission.erased, blockedOf(base.cells, difference(stroke, mission.walls))),
  };
}

// The obstacles of the map shown that are drawn, in part at least.
export function drawnObstacles(mission: Mission, { map }: ShownMap): ReadonlySet<number> {
  const ids = new Set<number>();
  for (const [x, y, length] of mission.walls) {
    for (let i = x; i < x + length; ++i) ids.add(map.cells.at(i, y));
  }
  ids.delete(0);
  return ids;
}

// The rules to plan by. Where everything that a rule means was erased or excluded, there is nothing left to protect; what the
// map never had is for the service to refuse.
export function rulesLeft({ protectAll }: Mission, base: CellMap, map: CellMap): TagFilter[] {
  return protectAll.filter((rule) => isLeft(rule, base, map));
}

function isLeft(rule: TagFilter, base: CellMap, map: CellMap): boolean {
  const means = ({ obstacles }: CellMap) => obstacles.some((one) => matches(one, rule));
  return base === map || means(map) || !means(base);
}

// The agents to plan with: what each opens, by its ids on the map that is planned on. Of what was erased the same holds.
export function agentsOn({ agents }: Mission, base: CellMap, map: CellMap, toShown: (id: number) => number): Agents {
  const left = (one: number | string): (number | string)[] => {
    if (typeof one === "string") return parseTagFilters(one)!.some((rule) => isLeft(rule, base, map)) ? [one] : [];
    return one > base.obstacles.length ? [one] : [toShown(one)].filter((id) => id !== 0);
  };
  return agents.map((agent) => (agent.only === null ? agent : { ...agent, only: agent.only.flatMap(left) }));
}

function blockedOf(cells: CellMap, stroke: readonly Run[]): Run[] {
  const blocked: Run[] = [];
  for (const [x, y, length] of stroke) {
    for (let i = x; i < x + length; ++i) if (cells.at(i, y) !== 0) blocked.push([i, y, 1]);
  }
  return union(blocked, []);
}
