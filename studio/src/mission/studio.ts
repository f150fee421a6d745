// The page's state and what people do to it. Panels and map read its signals; the server is asked in the background.
import { batch, effect, signal, untracked } from "@preact/signals";
import { type Client, ServiceError } from "../api/client";
import type { MapEntry } from "../api/documents";
import { vehiclesOf } from "../domain/agents";
import { defaults, hasEdits, type Mission, withEnoughRemovals } from "../domain/mission";
import { Planner } from "../planning/planner";
import { questionOf } from "../planning/request";
import { duration } from "../play/motion";
import { defaultMission } from "./default_mission";
import { editsOf, rulesLeft } from "./edited";
import { Editor } from "./editor";
import { begin, type History, mapped, replace, step } from "./history";
import { Importer } from "./importer";
import type { KeptFile } from "./kept_file";
import { decodeLink, encodeLink, fileOfLink, mapOfLink } from "./link";
import { type HeldMap, isUpload, type LostMap, Maps } from "./maps";
import { missionFile } from "./mission_file";
import { ServerWatch } from "./server_watch";
import { Translation } from "./translate";

export const firstMap = "berlin-adlershof.tif";

export class Studio extends Editor {
  readonly mapList = signal<MapEntry[]>([]);
  readonly uploads = signal<ReadonlyMap<string, KeptFile>>(new Map()); // by map
  readonly lost = signal<LostMap | null>(null); // a map that the service does not have

  readonly importer: Importer;

  readonly #maps: Maps;
  readonly #watch: ServerWatch;
  #opening: AbortController | null = null;
  #redrawn = false; // whether the drawing was sent again since the last response

  constructor(
    readonly client: Client,
    readonly planner = new Planner(client),
  ) {
    super(planner.results);
    this.#maps = new Maps(client);
    this.importer = new Importer(client, (map, file) => {
      this.uploads.value = new Map(this.uploads.value).set(map.id, file);
      return this.open(map.id);
    });
    this.#watch = new ServerWatch(() => this.refreshList());
    effect(() => {
      const failure = this.results.failure.value;
      if (failure?.trouble === "gone") untracked(() => void this.#watch.await(() => this.follow()));
      if (failure?.trouble === "missing") untracked(() => this.#mapIsMissing());
    });
    effect(() => {
      if (!this.results.answered.value) return;
      this.#redrawn = false;
      this.#watch.isWell();
    });
  }

  // Whether the service does not respond.
  get gone() {
    return this.#watch.gone;
  }

  // What the address says, or the first map with its mission.
  async start(query: string): Promise<void> {
    try {
      this.mapList.value = await this.client.maps();
    } catch (error) {
      return this.failed(error, () => this.start(query));
    }
    const asked = mapOfLink(query);
    const ids = this.mapList.value.map((entry) => entry.id);
    const usual = ids.includes(firstMap) ? firstMap : ids[0];
    if (asked !== null && (await this.open(asked, query))) return;
    const { value: lost } = this.lost;
    if (usual !== undefined && usual !== asked) await this.open(usual, asked === null ? query : "");
    else this.loading.value = false;
    this.lost.value = lost;
  }

  // Shows a map with the mission of a query, or the map's own. Whether that went well.
  async open(id: string, query = "", digest: string | null = null): Promise<boolean> {
    const wanted = this.#lostMap(id, (now) => void this.open(now, query));
    const name = wanted.file?.name ?? fileOfLink(query) ?? id;
    return this.#reach({ ...wanted, name, digest }, async (base) => {
        const usual = defaultMission(base.description, base.cells);
        const { width, height } = base.cells;
        const { start, goal } = vehiclesOf(usual.agents)[0]!;
        const { mission, complaints } = decodeLink(query, id, { start, goal }, width, height);
        if (complaints.length > 0) this.notify("bad", `${complaints.join("; ")}. The rest of the link is shown.`);
        batch(() => {
          this.#show(base);
          const history = this.history.value;
          const enough = withEnoughRemovals(mission);
          this.history.value = history ? step(history, enough) : begin(enough);
        });
        await this.follow();
        if (mission.time !== null) this.#seekWhenPlanned(mission.time);
    });
  }

  choose(id: string): void {
    this.notice.value = null;
    void this.open(id);
  }

  async upload(file: KeptFile): Promise<void> {
    const sent = await this.#send(file, () => this.upload(file));
    if (sent) await this.open(sent.id);
  }

  // Sends a map again that the service no longer has, and goes on with what was to be done with it.
  async restore(file: KeptFile): Promise<void> {
    const lost = this.lost.value;
    const sent = lost && (await this.#send(file, () => this.restore(file)));
    if (!sent || this.lost.value !== lost) return;
    const isSame = sent.id === lost.id || (lost.digest === null ? !isUpload(lost.id) : sent.digest === lost.digest);
    if (!isSame) return this.notify("bad", `“${file.name}” is not the map that this mission was made on.`);
    this.lost.value = null;
    lost.resume(sent.id);
  }

  async #send(file: KeptFile, again: () => unknown): Promise<{ id: string; digest: string } | null> {
    this.loading.value = true;
    this.notice.value = null;
    try {
      const map = await this.client.upload(file.bytes);
      this.uploads.value = new Map(this.uploads.value).set(map.id, file);
      return map;
    } catch (error) {
      this.failed(error, again, `“${file.name}” cannot be used as a map: `);
      return null;
    } finally {
      this.loading.value = false;
    }
  }

  // The mission as text, under which this page can be opened again as it is.
  query(): string {
    const mission = this.mission.value;
    const shown = this.shown.value;
    if (!mission || !shown) return "";
    const file = this.uploads.value.get(mission.map)?.name;
    const query = encodeLink({ ...mission, time: this.clock.time.value }, shown.base.cells.width);
    return file ? `${query}&file=${encodeURIComponent(file)}` : query;
  }

  // The same as a file, for the command line as well.
  missionFile(): string | null {
    const [mission, shown] = [this.mission.value, this.shown.value];
    if (!mission || !shown) return null;
    const removals = this.results.plans.value.after?.plan.removed.length ?? defaults.removals;
    const file = this.uploads.value.get(mission.map)?.name;
    const map = { width: shown.base.cells.width, cell: this.units.value.cell, metric: this.units.value.metric, file };
    return missionFile({ ...mission, time: this.clock.time.value }, map, removals);
  }

  // A step to another map is taken once that map is there.
  protected override travel(how: (history: History<Mission>) => History<Mission>): void {
    const history = this.history.value;
    if (!history) return;
    const next = how(history);
    const go = (base: HeldMap | null) => {
      batch(() => {
        if (base) this.#show(base);
        // Undo reverts the mission, not how it is displayed.
        this.history.value = replace(next, { ...next.present, layers: history.present.layers });
      });
      return this.follow();
    };
    const { map } = next.present;
    if (map === history.present.map) return void go(null);
    const resume = (now: string) => {
      this.#rename(map, now);
      this.travel(how);
    };
    void this.#reach(this.#lostMap(map, resume), (base) => go(base));
  }

  // Loads a map and goes on there. Whether that went well.
  async #reach(wanted: LostMap, go: (base: HeldMap) => Promise<void>): Promise<boolean> {
    this.#opening?.abort();
    const control = (this.#opening = new AbortController());
    this.loading.value = true;
    try {
      const base = await this.#maps.load(wanted.id, control.signal);
      this.lost.value = null;
      await go(base);
      return true;
    } catch (error) {
      if (this.#opening !== control) return false;
      if (isMissing(error)) this.lost.value = wanted;
      else this.failed(error, () => this.#reach(wanted, go), `The map “${wanted.name}” cannot be shown: `);
      return false;
    } finally {
      if (this.#opening === control) this.loading.value = false;
    }
  }

  // Shows the map that the mission is about and asks for its plan.
  protected override async follow(): Promise<void> {
    const mission = this.mission.value;
    const base = this.shown.value?.base;
    if (!mission || !base || this.lost.value?.id === mission.map) return;
    try {
      const map = hasEdits(mission) ? await this.#maps.edited(base, editsOf(mission, base.cells)) : base;
      const now = this.mission.value;
      if (now !== mission) return; // a later call follows the later mission
      if (this.shown.value?.map !== map) this.#redraw(base, map, mission);
      const { ids } = this.shown.value!;
      const rules = rulesLeft(mission, base.cells, map.cells);
      const toShown = (key: number) => ids.toShown(key);
      this.planner.ask(questionOf(mission, this.units.value, map.description.id, toShown, this.drawn.value, rules));
    } catch (error) {
      if (isMissing(error)) this.#lose();
      else this.failed(error, () => this.follow());
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
      const plan = this.results.plans.value.after?.plan;
      if (!plan) return;
      this.clock.load(duration(plan));
      this.clock.seek(time);
      queueMicrotask(() => stop());
    });
  }

  // Reports what went wrong; if the service did not respond, retries once it does.
  failed(error: unknown, again: () => unknown, prefix = ""): void {
    if (!(error instanceof ServiceError)) throw error;
    if (error.trouble === "gone") void this.#watch.await(again);
    else if (error.trouble === "missing") this.#mapIsMissing();
    else if (error.trouble !== "stopped") this.notify("bad", `${prefix}${error.message}`);
  }

  // What was drawn is drawn again, once; if that does not help, the map below is gone.
  #mapIsMissing(): void {
    const shown = this.shown.value;
    if (!shown || shown.map === shown.base || this.#redrawn) return this.#lose();
    this.#redrawn = true;
    this.#maps.forget();
    void this.follow();
  }

  // The map shown is no longer there: nothing is asked until the person has sent it again.
  #lose(): void {
    const map = this.shown.value?.base.description;
    if (!map || this.lost.value) return;
    this.planner.stop();
    this.#maps.forget();
    const resume = (now: string) => {
      this.#rename(map.id, now);
      void this.follow();
    };
    this.lost.value = { ...this.#lostMap(map.id, resume), digest: map.digest };
  }

  #lostMap(id: string, resume: LostMap["resume"]): LostMap {
    const file = this.uploads.value.get(id) ?? null;
    return { id, name: file?.name ?? id, file, digest: null, resume };
  }

  // A file of the server's folder that was sent has another name than it had there.
  #rename(from: string, to: string): void {
    const { history, shown } = this;
    if (from === to || !history.value || !shown.value) return;
    const { base, map, ids } = shown.value;
    const renamed = { ...base, description: { ...base.description, id: to } };
    batch(() => {
      history.value = mapped(history.peek()!, (old) => (old.map === from ? { ...old, map: to } : old));
      if (base.description.id === from) shown.value = { base: renamed, map: map === base ? renamed : map, ids };
    });
  }

  async refreshList(): Promise<boolean> {
    try {
      this.mapList.value = await this.client.maps();
      return true;
    } catch {
      return false;
    }
  }
}

function isMissing(error: unknown): boolean {
  return error instanceof ServiceError && error.trouble === "missing";
}
