// What people change about a mission: each change is a step that can be undone, and the plan follows it.
import { computed, signal } from "@preact/signals";
import {
  type Aircraft,
  changed,
  type Handle,
  isPair,
  joined,
  left,
  type MissionAgent,
  onItsOwn,
  type Vehicle,
  vehiclesOf,
} from "../domain/agents";
import type { Cell, Run } from "../domain/geometry";
import {
  type Choice,
  type LayerName,
  type Mark,
  marked,
  type Mission,
  mostRemovals,
  withEnoughRemovals,
  withMark,
} from "../domain/mission";
import type { Tool } from "../domain/scene";
import { filterText, ruledObstacles, type TagFilter } from "../domain/tag_filter";
import { renamedIn } from "../domain/zone";
import { drawn } from "./edited";
import { endGesture, type History, redo, step, undo } from "./history";
import type { PageState } from "./page_state";
import { oneAircraftMore, oneVehicleMore } from "./placing";

interface Around {
  follow: () => Promise<void>; // brings what is shown up with the mission
  travel: (how: (history: History<Mission>) => History<Mission>) => void; // goes to another step of the history
}

export class Editor {
  readonly canUndo = computed(() => (this.page.history.value?.past.length ?? 0) > 0);
  readonly canRedo = computed(() => (this.page.history.value?.future.length ?? 0) > 0);
  readonly tool = signal<Tool>("move");

  constructor(
    private readonly page: PageState,
    private readonly around: Around,
  ) {}

  // A step that can be undone; steps of one gesture are undone together.
  change(how: (mission: Mission) => Mission, gesture: string | null = null): void {
    const history = this.page.history.value;
    if (!history) return;
    this.page.history.value = step(history, how(history.present), gesture);
    void this.around.follow();
  }

  endGesture(): void {
    if (this.page.history.value) this.page.history.value = endGesture(this.page.history.value);
  }

  undo(): void {
    this.around.travel(undo);
  }

  redo(): void {
    this.around.travel(redo);
  }

  // A layer that is shown is planned as well.
  toggleLayer(layer: LayerName): void {
    this.page.toggleLayer(layer);
    void this.around.follow();
  }

  // The map sees to it that the vehicles' markers stand on free cells.
  drag({ agent, end }: Handle, cell: Cell, done: boolean): void {
    const old = this.page.mission.value?.agents[agent]?.[end];
    if (old?.[0] !== cell[0] || old?.[1] !== cell[1]) this.changeAgent(agent, { [end]: cell }, `drag ${agent} ${end}`);
    if (done) this.endGesture();
  }

  bringAircraftBack(agent: number): void {
    this.changeAgent(agent, { start: null, goal: null });
  }

  changeAgent(agent: number, part: Partial<Vehicle> | Partial<Aircraft>, gesture: string | null = null): void {
    this.change((mission) => ({ ...mission, agents: changed(mission.agents, agent, part) }), gesture);
  }

  // Names are those of plans: no two are the same.
  renameAgent(agent: number, name: string): void {
    const [id, agents] = [name.trim(), this.page.mission.value?.agents ?? []];
    if (id === "" || id === agents[agent]?.id) return;
    if (agents.some((one) => one.id === id)) return this.page.notify("bad", `Another agent is called “${id}”.`);
    const zones = (mission: Mission) => renamedIn(mission.zones, agents[agent]!.id, id);
    this.change((mission) => ({ ...mission, agents: changed(mission.agents, agent, { id }), zones: zones(mission) }));
  }

  addVehicle(): void {
    const [mission, shown] = [this.page.mission.value, this.page.shown.value];
    if (!mission || !shown) return;
    const one = oneVehicleMore(mission.agents, shown.map.cells, mission.separation);
    if (!one) return this.page.notify("bad", "There is no room for another vehicle beside the last one.");
    this.#join(one);
  }

  addAircraft(): void {
    const mission = this.page.mission.value;
    if (mission) this.#join(oneAircraftMore(mission.agents));
  }

  // The vehicle of a pair breaks its own way from now on.
  leaveItAlone(): void {
    this.change((mission) => ({ ...mission, agents: onItsOwn(mission.agents, mostRemovals) }));
    this.page.chooseAgent(0);
  }

  // The last vehicle stays: a mission is about somebody who drives.
  removeAgent(agent: number): void {
    const agents = this.page.mission.value?.agents ?? [];
    if (agents[agent]?.kind === "ground" && vehiclesOf(agents).length === 1) return;
    this.page.chosenAgent.value = null;
    const zones = (mission: Mission) => renamedIn(mission.zones, agents[agent]!.id, null);
    this.change((mission) => ({ ...mission, agents: left(mission.agents, agent), zones: zones(mission) }));
  }

  #join(one: MissionAgent): void {
    const before = new Set(this.page.mission.value!.agents.map(({ id }) => id));
    this.change((mission) => ({ ...mission, agents: joined(mission.agents, one) }));
    const { agents } = this.page.mission.value!;
    const isNew = ({ id, kind }: MissionAgent) => kind === one.kind && !before.has(id);
    this.page.chooseAgent(isPair(agents) ? null : agents.findLastIndex(isNew));
  }

  draw(tool: "wall" | "erase", runs: readonly Run[]): void {
    const shown = this.page.shown.value;
    if (shown) this.change((mission) => drawn(mission, tool, runs, shown));
  }

  // `id` is an obstacle of the map shown. What has been drawn is not excluded but erased.
  mark(id: number, mark: Mark | null): void {
    const shown = this.page.shown.value;
    if (!shown) return;
    const key = this.page.keyOf(id);
    if (key === 0) return;
    const isDrawn = this.page.drawn.value.has(id);
    if (key < 0 && mark === "exclude") this.draw("erase", shown.map.cells.runsOf(id));
    else if (isDrawn && mark === "protect") this.markKey(key, null);
    else this.markKey(key, mark ?? (isDrawn ? "allow" : null));
    if (mark === "exclude") this.page.selected.value = null;
  }

  // From now on what is protected stays, even if it was forced before.
  protectAll(rules: readonly TagFilter[]): void {
    const { base } = this.page.shown.value!;
    const stays = ruledObstacles(rules, base.cells);
    this.change((mission) => {
      const had = new Set(mission.protectAll.map(filterText));
      const fresh = rules.filter((rule) => !had.has(filterText(rule)));
      const marks = new Map([...mission.marks].filter(([key, mark]) => mark !== "force" || !stays.has(key)));
      return { ...mission, marks, protectAll: [...mission.protectAll, ...fresh] };
    });
  }

  allowAll(rule: TagFilter): void {
    const others = (mission: Mission) => mission.protectAll.filter((one) => filterText(one) !== filterText(rule));
    this.change((mission) => ({ ...mission, protectAll: others(mission) }));
  }

  markKey(key: number, mark: Choice | null): void {
    const next = withMark(this.page.mission.value!, key, mark);
    if (marked(next, "force").length > mostRemovals) {
      return this.page.notify("bad", `No more than ${mostRemovals} obstacles can be removed.`);
    }
    this.change(() => withEnoughRemovals(next));
  }
}
