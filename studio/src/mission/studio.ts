// The page's state and what people do to it. Panels and map read its signals; the server is asked in the background.
import { batch, computed, effect, signal, untracked } from "@preact/signals";
import type { Cell, MapEntry } from "../api/answers";
import { ServiceError, type Client, type ExportFormat } from "../api/client";
import type { Handle, LayerName, Mark, Run, Tool } from "../map/scene";
import { duration } from "../play/motion";
import { defaultMission } from "./default_mission";
import { begin, endGesture, redo, replace, step, undo, type History } from "./history";
import { decodeLink, encodeLink, mapOfLink } from "./link";
import { Maps, type HeldMap } from "./maps";
import { hasEdits, marked, mostRemovals, withEnoughRemovals, withMark, type Mission } from "./mission";
import { Planner } from "./planner";
import { questionOf } from "./request";
import { drawn, editsOf } from "./edited";
import { PageState } from "./page_state";
import { saveAs } from "./save_as";
import { Translation } from "./translate";

export const firstMap = "berlin-adlershof.tif";

export class Studio extends PageState {
  readonly canUndo = computed(() => (this.history.value?.past.length ?? 0) > 0);
  readonly canRedo = computed(() => (this.history.value?.future.length ?? 0) > 0);
  readonly mapList = signal<MapEntry[]>([]);
  readonly uploads = signal<ReadonlyMap<string, string>>(new Map()); // names of files by map
  readonly tool = signal<Tool>("move");
  readonly gone = signal(false); // nobody answers

  readonly #maps: Maps;
  #opening: AbortController | null = null;
  #again: () => unknown = () => undefined; // what to do when the server is back
  #missing = 0; // how often in a row the service no longer had the map

  constructor(
    readonly client: Client,
    readonly planner = new Planner(client),
  ) {
    super(planner);
    this.#maps = new Maps(client);
    effect(() => {
      const failure = this.planner.failure.value;
      if (failure?.trouble === "gone") untracked(() => this.#awaitServer());
      if (failure?.trouble === "missing") untracked(() => this.#mapIsMissing());
    });
  }

  // What the address says, or the first map with its mission.
  async start(query: string): Promise<void> {
    try {
      this.mapList.value = await this.client.maps();
    } catch (error) {
      return this.#failed(error, () => this.start(query));
    }
    const asked = mapOfLink(query);
    const ids = this.mapList.value.map((entry) => entry.id);
    const usual = ids.includes(firstMap) ? firstMap : ids[0];
    if (asked !== null && (await this.open(asked, query))) return;
    if (usual !== undefined && usual !== asked) await this.open(usual, asked === null ? query : "");
    else this.loading.value = false;
  }

  // Shows a map with the mission of a query, or the map's own. Whether that went well.
  async open(id: string, query = ""): Promise<boolean> {
    this.#opening?.abort();
    const control = (this.#opening = new AbortController());
    this.loading.value = true;
    try {
      const base = await this.#maps.load(id, control.signal);
      const usual = defaultMission(base.description, base.cells);
      const { width, height } = base.cells;
      const { mission, complaints } = decodeLink(query, id, usual.markers, width, height);
      if (complaints.length > 0) this.tell("bad", `${complaints.join("; ")}. The rest of the link is shown.`);
      batch(() => {
        this.#show(base);
        const history = this.history.value;
        const enough = withEnoughRemovals(mission);
        this.history.value = history ? step(history, enough) : begin(enough);
      });
      await this.#follow();
      if (mission.time !== null) this.#seekWhenPlanned(mission.time);
      return true;
    } catch (error) {
      if (this.#opening === control)
        this.#failed(error, () => this.open(id, query), `The map “${id}” cannot be shown: `);
      return false;
    } finally {
      if (this.#opening === control) this.loading.value = false;
    }
  }

  choose(id: string): void {
    this.notice.value = null;
    void this.open(id);
  }

  async upload(file: File): Promise<void> {
    this.loading.value = true;
    this.notice.value = null;
    try {
      const { id } = await this.client.upload(file);
      this.uploads.value = new Map(this.uploads.value).set(id, file.name);
      await this.open(id);
    } catch (error) {
      this.loading.value = false;
      this.#failed(error, () => this.upload(file), `“${file.name}” cannot be used as a map: `);
    }
  }

  // A step that can be undone; steps of one gesture are undone together.
  change(how: (mission: Mission) => Mission, gesture: string | null = null): void {
    const history = this.history.value;
    if (!history) return;
    this.history.value = step(history, how(history.present), gesture);
    void this.#follow();
  }

  endGesture(): void {
    if (this.history.value) this.history.value = endGesture(this.history.value);
  }

  undo(): void {
    this.#travel(undo);
  }

  redo(): void {
    this.#travel(redo);
  }

  // After a plan was stopped.
  planAgain(): void {
    void this.#follow();
  }

  override toggleLayer(layer: LayerName): void {
    super.toggleLayer(layer);
    void this.#follow();
  }

  // The map sees to it that the ground robot's markers stand on free cells.
  drag(handle: Handle, cell: Cell, done: boolean): void {
    const old = this.mission.value?.markers[handle];
    if (old?.[0] !== cell[0] || old?.[1] !== cell[1]) {
      this.change((mission) => ({ ...mission, markers: { ...mission.markers, [handle]: cell } }), `drag ${handle}`);
    }
    if (done) this.endGesture();
  }

  bringAircraftBack(): void {
    this.change((mission) => ({ ...mission, markers: { start: mission.markers.start, goal: mission.markers.goal } }));
  }

  draw(tool: "wall" | "erase", runs: readonly Run[]): void {
    const shown = this.shown.value;
    if (shown) this.change((mission) => drawn(mission, tool, runs, shown));
  }

  // `id` is an obstacle of the map shown. What has been drawn is not excluded but erased.
  mark(id: number, mark: Mark | null): void {
    const shown = this.shown.value;
    if (!shown) return;
    const key = shown.ids.toBase(id);
    if (key === 0) return;
    if (key < 0 && mark === "exclude") this.draw("erase", shown.map.cells.runsOf(id));
    else this.markKey(key, mark);
    if (mark === "exclude") this.selected.value = null;
  }

  markKey(key: number, mark: Mark | null): void {
    const next = withMark(this.mission.value!, key, mark);
    if (marked(next, "force").length > mostRemovals) {
      return this.tell("bad", `No more than ${mostRemovals} obstacles can be removed.`);
    }
    this.change(() => withEnoughRemovals(next));
  }

  async download(format: ExportFormat, ending: string): Promise<void> {
    const plan = this.planner.plans.value.after?.plan;
    const map = this.shown.value?.map.description;
    if (!plan || !map) return;
    await this.#save(async () => ({ bytes: await this.client.exported(map.id, plan, format), name: `plan.${ending}` }));
  }

  async downloadMap(): Promise<void> {
    const map = this.shown.value?.map.description;
    if (map) await this.#save(() => this.client.file(map.id));
  }

  async #save(fetched: () => Promise<{ bytes: Blob; name: string }>): Promise<void> {
    try {
      const { bytes, name } = await fetched();
      saveAs(bytes, name);
    } catch (error) {
      this.#failed(error, () => undefined);
    }
  }

  // The query under which this page can be opened again as it is.
  link(): string {
    const mission = this.mission.value;
    const shown = this.shown.value;
    return mission && shown
      ? `?${encodeLink({ ...mission, time: this.clock.time.value }, shown.base.cells.width)}`
      : "";
  }

  #travel(how: (history: History<Mission>) => History<Mission>): void {
    const history = this.history.value;
    if (!history) return;
    const next = how(history);
    // Undo takes back what is asked, not how one looks at it.
    this.history.value = replace(next, { ...next.present, layers: history.present.layers });
    void this.#follow();
  }

  // Shows the map that the mission is about and asks for its plan.
  async #follow(): Promise<void> {
    const mission = this.mission.value;
    const base = this.shown.value?.base;
    if (!mission || !base) return;
    try {
      if (base.description.id !== mission.map) {
        const other = await this.#maps.load(mission.map);
        if (this.mission.value?.map !== mission.map) return;
        this.#show(other);
        return await this.#follow();
      }
      const map = hasEdits(mission) ? await this.#maps.edited(base, editsOf(mission, base.cells)) : base;
      const now = this.mission.value;
      if (now !== mission) return; // a later call follows the later mission
      if (this.shown.value?.map !== map) this.#redraw(base, map, mission);
      const { ids } = this.shown.value!;
      this.planner.ask(questionOf(mission, this.units.value, map.description.id, (key) => ids.toShown(key)));
    } catch (error) {
      this.#failed(error, () => this.#follow());
    }
  }

  #show(base: HeldMap): void {
    this.planner.clear();
    this.clock.stop();
    this.selected.value = null;
    this.highlighted.value = null;
    this.shown.value = { base, map: base, ids: new Translation(base.cells, base.cells, []) };
  }

  // What is selected stays so under the id it has now.
  #redraw(base: HeldMap, map: HeldMap, mission: Mission): void {
    const old = this.shown.value?.ids;
    const ids = new Translation(base.cells, map.cells, mission.walls);
    const selected = this.selected.value;
    batch(() => {
      this.selected.value = (selected !== null && old && ids.toShown(old.toBase(selected))) || null;
      this.highlighted.value = null;
      this.shown.value = { base, map, ids };
    });
  }

  #seekWhenPlanned(time: number): void {
    const stop = effect(() => {
      const plan = this.planner.plans.value.after?.plan;
      if (!plan) return;
      this.clock.load(duration(plan));
      this.clock.seek(time);
      queueMicrotask(() => stop());
    });
  }

  #failed(error: unknown, again: () => unknown, prefix = ""): void {
    if (!(error instanceof ServiceError)) throw error;
    if (error.trouble === "gone") void this.#awaitServer(again);
    else if (error.trouble === "missing" && prefix) this.tell("bad", `${prefix}the server has no such map.`);
    else if (error.trouble !== "stopped") this.tell("bad", `${prefix}${error.message}`);
  }

  #mapIsMissing(): void {
    this.#maps.forget();
    if (++this.#missing > 1) return this.tell("bad", "The server no longer has this map. Upload it again.");
    void this.#follow().then(() => (this.#missing = 0));
  }

  // Asks until somebody answers, then for what is shown.
  async #awaitServer(again: () => unknown = () => this.#follow()): Promise<void> {
    this.#again = again;
    if (this.gone.value) return;
    this.gone.value = true;
    for (;;) {
      await new Promise((done) => setTimeout(done, 1500));
      try {
        this.mapList.value = await this.client.maps();
        break;
      } catch {
        continue;
      }
    }
    this.gone.value = false;
    this.#maps.forget();
    this.#again();
  }
}
