// What the map is given to draw.
import type { Point } from "../domain/geometry";
import type { Mark } from "../domain/mission";
import type { Layer, Scene } from "../domain/scene";
import { duration } from "../domain/units";
import { positionAt } from "../play/motion";
import type { PageState } from "./page_state";
import type { Studio } from "./studio";

export function sceneOf(page: PageState, studio: Studio | null): Scene | null {
  const shown = page.shown.value;
  const mission = page.mission.value;
  if (!shown || !mission) return null;
  const rehearsed = page.rehearsed.value;
  const plans = page.results.plans.value;
  const units = page.units.value;
  // The plan itself is drawn last, on top, and is what is played.
  const planned = (["before", "paper", "after"] as const).flatMap((name): Layer[] => {
    const judged = plans[name];
    return judged && mission.layers.includes(name) ? [{ name, plan: judged.plan }] : [];
  });
  const layers = rehearsed ? [{ name: "after" as const, plan: rehearsed.plan }] : planned;
  const marks = new Map<number, Mark>();
  for (const [key, mark] of mission.marks) {
    const id = shown.ids.toShown(key);
    if (id !== 0 && mark !== "allow") marks.set(id, mark);
  }
  for (const id of page.drawn.value) {
    if (page.markOf(id) === "protect") marks.set(id, "protect");
  }
  return {
    map: shown.map.description,
    cells: shown.map.cells,
    background: shown.map.background,
    agents: mission.agents,
    looks: page.looks.value,
    chosen: page.chosenAgent.value,
    bands: mission.bands && !rehearsed ? page.bands.value : null,
    layers,
    marks,
    ruled: page.ruled.value,
    zones: mission.zones,
    pointedZone: page.pointedZone.value,
    highlighted: page.highlighted.value,
    selected: page.selected.value,
    old: page.old.value,
    rehearsed,
    reach: page.reach.value,
    time: page.clock.time.value,
    followed: followed(page),
    tool: studio?.editor.tool.value ?? "move",
    editable: studio !== null,
    formatTime: (time) => duration(time, units, true),
  };
}

// In playback the chosen agent, or the first that drives.
function followed(page: PageState): Point | null {
  const [plan, time] = [page.played.value, page.clock.time.value];
  if (!plan || time === null || !page.clock.follows.value) return null;
  const chosen = page.mission.value?.agents[page.chosenAgent.value ?? -1]?.id;
  const agent = plan.agents.find(({ id }) => id === chosen) ?? plan.agents.find(({ kind }) => kind === "ground");
  const at = agent && positionAt(agent, time);
  return at ? [at.x, at.y] : null;
}
