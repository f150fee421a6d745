// Keeps the map that is drawn on and the plan up with the mission.
import { batch, effect, type ReadonlySignal } from "@preact/signals";
import type { MapDescription } from "../domain/map";
import { hasEdits, type Mission } from "../domain/mission";
import type { Planner } from "../planning/planner";
import { questionOf } from "../planning/request";
import { agentsOn, editsOf, rulesLeft } from "./edited";
import { type HeldMap, isMissing, type LostMap, type Maps } from "./maps";
import type { PageState } from "./page_state";
import { Translation } from "./translate";

// Says what went wrong with the service; `again` goes on once it is there.
export type Report = (error: unknown, again: () => unknown, prefix?: string) => void;

interface Around {
  lost: ReadonlySignal<LostMap | null>;
  lose: (map: MapDescription) => void; // the map shown is no longer there
  report: Report;
}

export class PlanFollower {
  #redrawn = false; // whether the drawing was sent again since the last response

  constructor(
    private readonly page: PageState,
    private readonly planner: Planner,
    private readonly maps: Maps,
    private readonly around: Around,
  ) {
    effect(() => {
      if (page.results.answered.value) this.#redrawn = false;
    });
  }

  // Shows a map with nothing planned on it yet.
  show(base: HeldMap): void {
    const { page } = this;
    this.planner.clear();
    page.clock.stop();
    page.selected.value = null;
    page.highlighted.value = null;
    page.shown.value = { base, map: base, ids: new Translation(base.cells, base.cells, []) };
  }

  // Shows the map that the mission is about and asks for its plan.
  async follow(): Promise<void> {
    const { page, maps } = this;
    const mission = page.mission.value;
    const base = page.shown.value?.base;
    if (!mission || !base || this.around.lost.value?.id === mission.map) return;
    try {
      const map = hasEdits(mission) ? await maps.edited(base, editsOf(mission, base.cells)) : base;
      if (page.mission.value !== mission) return; // a later call follows the later mission
      if (page.shown.value?.map !== map) this.#redraw(base, map, mission);
      const { ids } = page.shown.value!;
      const rules = rulesLeft(mission, base.cells, map.cells);
      const toShown = (key: number) => ids.toShown(key);
      const agents = agentsOn(mission, base.cells, map.cells, toShown);
      this.planner.ask(questionOf(mission, page.units.value, map.description.id, toShown, page.drawn.value, rules, agents));
    } catch (error) {
      if (isMissing(error)) this.#lose();
      else this.around.report(error, () => this.follow());
    }
  }

  // What was drawn is drawn again, once; if that does not help, the map below is gone.
  mapIsMissing(): void {
    const shown = this.page.shown.value;
    if (!shown || shown.map === shown.base || this.#redrawn) return this.#lose();
    this.#redrawn = true;
    this.maps.forget();
    void this.follow();
  }

  // Nothing is asked until the person has sent the map again.
  #lose(): void {
    const map = this.page.shown.value?.base.description;
    if (!map || this.around.lost.value) return;
    this.planner.stop();
    this.maps.forget();
    this.around.lose(map);
  }

  // What is selected stays so under the id it has now.
  #redraw(base: HeldMap, map: HeldMap, mission: Mission): void {
    const { page } = this;
    const old = page.shown.value?.ids;
    const ids = new Translation(base.cells, map.cells, mission.walls);
    const selected = page.selected.value;
    batch(() => {
      page.selected.value = (selected !== null && old && ids.toShown(old.toBase(selected))) || null;
      page.highlighted.value = null;
      page.shown.value = { base, map, ids };
    });
  }
}
