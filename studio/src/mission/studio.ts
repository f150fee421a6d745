// The page that plans: its state, what people change about the mission, the maps there are, and a plan that follows.
import { computed, effect, signal, untracked } from "@preact/signals";
import { type Client, ServiceError } from "../api/client";
import { usualVehicle } from "../domain/agents";
import { asksTheSame, defaults } from "../domain/mission";
import type { Plan } from "../domain/plan";
import { Planner } from "../planning/planner";
import type { Judged } from "../planning/results";
import { Rehearsal } from "../rehearse/rehearsal";
import { BandFollower } from "./band_follower";
import { BaseEditor } from "./base_editor";
import { Editor } from "./editor";
import { Importer } from "./importer";
import { encodeLink } from "./link";
import { MapDesk } from "./map_desk";
import { type LostMap, Maps } from "./maps";
import { missionFile } from "./mission_file";
import { Overlays } from "./overlays";
import { PageState } from "./page_state";
import { PlanFollower } from "./plan_follower";
import { ServerWatch } from "./server_watch";
import { ZoneEditor } from "./zone_editor";

export class Studio {
  readonly page: PageState;
  readonly editor: Editor;
  readonly zones: ZoneEditor;
  readonly bases: BaseEditor;
  readonly maps: MapDesk;
  readonly importer: Importer;
  readonly overlays: Overlays;
  readonly rehearsal: Rehearsal;
  // The plan that exports give: in a rehearsal the one that holds; null where none does.
  readonly held = computed<Plan | null>(() =>
    this.page.rehearsed.value ? this.rehearsal.held.value : (this.page.results.plans.value.after?.plan ?? null),
  );
  // What is rehearsed is taken back first.
  readonly canUndo = computed(() => this.rehearsal.steps.value.length > 0 || this.editor.canUndo.value);

  readonly #follower: PlanFollower;
  readonly #watch = new ServerWatch(() => this.maps.refreshList());

  constructor(
    readonly client: Client,
    readonly planner = new Planner(client),
  ) {
    const { results } = planner;
    const [held, lost] = [new Maps(client), signal<LostMap | null>(null)];
    const report = this.failed.bind(this);
    this.page = new PageState(results);
    this.#follower = new PlanFollower(this.page, planner, held, { lost, lose: (map) => this.maps.lose(map), report });
    this.maps = new MapDesk(client, this.page, held, this.#follower, lost, report);
    this.editor = new Editor(this.page, {
      follow: () => this.#follower.follow(),
      travel: (how) => this.maps.travel(how),
    });
    this.zones = new ZoneEditor(this.page, this.editor);
    this.bases = new BaseEditor(this.page, this.editor);
    this.importer = new Importer(client, (map, file) => this.maps.openMade(map, file));
    this.overlays = new Overlays(client, (map, file) => this.maps.openOverlaid(map, file));
    this.rehearsal = new Rehearsal(client, {
      plan: computed(() => rehearsable(results.plans.value.after)),
      map: () => this.page.shown.value!.map.description.id,
      clock: this.page.clock,
      shown: this.page.rehearsed,
    });
    new BandFollower(this.page, client);
    this.#endRehearsals();
    effect(() => {
      const failure = results.failure.value;
      if (failure?.trouble === "gone") untracked(() => void this.#watch.await(() => this.#follower.follow()));
      if (failure?.trouble === "missing") untracked(() => this.#follower.mapIsMissing());
    });
    effect(() => {
      if (results.answered.value) this.#watch.isWell();
    });
  }

  // Whether the service does not respond.
  get gone() {
    return this.#watch.gone;
  }

  undo(): void {
    if (this.rehearsal.steps.value.length > 0) this.rehearsal.undo();
    else this.editor.undo();
  }

  // One is of the mission as it is.
  #endRehearsals(): void {
    let before = this.page.mission.value;
    effect(() => {
      const mission = this.page.mission.value;
      if (before && mission && !asksTheSame(before, mission)) untracked(() => this.rehearsal.reset());
      before = mission;
    });
    // What is to fall is chosen only while there is something to rehearse.
    effect(() => {
      if (this.rehearsal.available.value || this.editor.tool.peek() !== "rubble") return;
      this.editor.tool.value = "move";
    });
  }

  // After a plan was stopped.
  planAgain(): void {
    void this.#follower.follow();
  }

  // The mission as text, under which this page can be opened again as it is.
  query(): string {
    const mission = this.page.mission.value;
    const shown = this.page.shown.value;
    if (!mission || !shown) return "";
    const file = this.maps.uploads.value.get(mission.map)?.name;
    const query = encodeLink(
      { ...mission, time: this.page.clock.time.value },
      shown.base.cells.width,
      shown.base.description.usual_radius ?? usualVehicle.radius,
    );
    return file ? `${query}&file=${encodeURIComponent(file)}` : query;
  }

  // The same as a file, for the command line as well.
  missionFile(): string | null {
    const { mission: { value: mission }, shown: { value: shown }, units: { value: units }, results, clock } = this.page;
    if (!mission || !shown) return null;
    const removals = results.plans.value.after?.plan.removed.length ?? defaults.removals;
    const file = this.maps.uploads.value.get(mission.map)?.name;
    const map = { width: shown.base.cells.width, cell: units.cell, metric: units.metric, file };
    return missionFile({ ...mission, time: clock.time.value }, map, removals);
  }

  // Reports what went wrong; if the service did not respond, retries once it does.
  failed(error: unknown, again: () => unknown, prefix = ""): void {
    if (!(error instanceof ServiceError)) throw error;
    if (error.trouble === "gone") void this.#watch.await(again);
    else if (error.trouble === "missing") this.#follower.mapIsMissing();
    else if (error.trouble !== "stopped") this.page.notify("bad", `${prefix}${error.message}`);
  }
}

// A draft only follows the mouse.
function rehearsable(judged: Judged | undefined): Plan | null {
  return judged && judged.rough !== "draft" ? judged.plan : null;
}
