// The maps that there are: those of the service, those that people send it, and the one that it has lost. Shows them.
import { batch, type Signal, signal } from "@preact/signals";
import type { Client } from "../api/client";
import type { MapEntry } from "../api/documents";
import { vehiclesOf } from "../domain/agents";
import type { MapDescription } from "../domain/map";
import { type Mission, withEnoughRemovals } from "../domain/mission";
import { defaultMission } from "./default_mission";
import { begin, type History, mapped, replace, step } from "./history";
import type { KeptFile } from "./kept_file";
import { decodeLink, fileOfLink, mapOfLink } from "./link";
import { type HeldMap, isMissing, isUpload, type LostMap, type Maps } from "./maps";
import { moved } from "./overlays";
import type { PageState } from "./page_state";
import type { PlanFollower, Report } from "./plan_follower";

export const firstMap = "berlin-adlershof.tif";

export class MapDesk {
  readonly list = signal<MapEntry[]>([]); // of the service
  readonly uploads = signal<ReadonlyMap<string, KeptFile>>(new Map()); // by map

  #opening: AbortController | null = null;

  constructor(
    private readonly client: Client,
    private readonly page: PageState,
    private readonly maps: Maps,
    private readonly follower: PlanFollower,
    readonly lost: Signal<LostMap | null>, // a map that the service does not have
    private readonly report: Report,
  ) {}

  // What the address says, or the first map with its mission.
  async start(query: string): Promise<void> {
    try {
      this.list.value = await this.client.maps();
    } catch (error) {
      return this.report(error, () => this.start(query));
    }
    const asked = mapOfLink(query);
    const ids = this.list.value.map((entry) => entry.id);
    const usual = ids.includes(firstMap) ? firstMap : ids[0];
    if (asked !== null && (await this.open(asked, query))) return;
    const { value: lost } = this.lost;
    if (usual !== undefined && usual !== asked) await this.open(usual, asked === null ? query : "");
    else this.page.loading.value = false;
    this.lost.value = lost;
  }

  async refreshList(): Promise<boolean> {
    try {
      this.list.value = await this.client.maps();
      return true;
    } catch {
      return false;
    }
  }

  // Shows a map with the mission of a query, or the map's own. Whether that went well.
  async open(id: string, query = "", digest: string | null = null): Promise<boolean> {
    const { page } = this;
    const wanted = this.#lostMap(id, (now) => void this.open(now, query));
    const name = wanted.file?.name ?? fileOfLink(query) ?? id;
    return this.#reach({ ...wanted, name, digest }, async (base) => {
      const usual = defaultMission(base.description, base.cells);
      const { width, height } = base.cells;
      const { start, goal, radius } = vehiclesOf(usual.agents)[0]!;
      const { mission, complaints } = decodeLink(query, id, { start, goal, radius }, width, height);
      if (complaints.length > 0) page.notify("bad", `${complaints.join("; ")}. The rest of the link is shown.`);
      batch(() => {
        this.follower.show(base);
        const history = page.history.value;
        const enough = withEnoughRemovals(mission);
        page.history.value = history ? step(history, enough) : begin(enough);
      });
      await this.follower.follow();
      if (mission.time !== null) page.seekWhenPlanned(mission.time);
    });
  }

  choose(id: string): void {
    this.page.notice.value = null;
    void this.open(id);
  }

  async upload(file: KeptFile): Promise<void> {
    const sent = await this.#send(file, () => this.upload(file));
    if (sent) await this.open(sent.id);
  }

  // Shows a map that the service has made of a file.
  async openMade(map: MapDescription, file: KeptFile): Promise<void> {
    this.#keep(map.id, file);
    await this.open(map.id);
  }

  // Goes on with the mission on a map that the service has made of the one shown, as a step that can be undone.
  async openOverlaid(map: MapDescription, file: KeptFile): Promise<void> {
    this.#keep(map.id, file);
    const again = (now: string) => void this.openOverlaid({ ...map, id: now }, file);
    await this.#reach(this.#lostMap(map.id, again), async (base) => {
      const [history, before] = [this.page.history.value, this.page.shown.value?.base];
      if (!history || !before) return;
      const marks = moved(history.present.marks, before.cells, base.cells);
      batch(() => {
        this.follower.show(base);
        this.page.history.value = step(history, { ...history.present, map: base.description.id, marks });
      });
      await this.follower.follow();
    });
  }

  // Sends a map again that the service no longer has, and goes on with what was to be done with it.
  async restore(file: KeptFile): Promise<void> {
    const lost = this.lost.value;
    const sent = lost && (await this.#send(file, () => this.restore(file)));
    if (!sent || this.lost.value !== lost) return;
    const isSame = sent.id === lost.id || (lost.digest === null ? !isUpload(lost.id) : sent.digest === lost.digest);
    if (!isSame) return this.page.notify("bad", `“${file.name}” is not the map that this mission was made on.`);
    this.lost.value = null;
    lost.resume(sent.id);
  }

  // The service no longer has the map that is shown.
  lose({ id, digest }: MapDescription): void {
    const resume = (now: string) => {
      this.#rename(id, now);
      void this.follower.follow();
    };
    this.lost.value = { ...this.#lostMap(id, resume), digest };
  }

  // Goes to another step of the history: to one on another map once that map is there.
  travel(how: (history: History<Mission>) => History<Mission>): void {
    const { page } = this;
    const history = page.history.value;
    if (!history) return;
    const next = how(history);
    const go = (base: HeldMap | null) => {
      batch(() => {
        if (base) this.follower.show(base);
        // Undo reverts the mission, not how it is displayed.
        const { layers, bands } = history.present;
        page.history.value = replace(next, { ...next.present, layers, bands });
      });
      return this.follower.follow();
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
    const { loading } = this.page;
    this.#opening?.abort();
    const control = (this.#opening = new AbortController());
    loading.value = true;
    try {
      const base = await this.maps.load(wanted.id, control.signal);
      this.lost.value = null;
      await go(base);
      return true;
    } catch (error) {
      if (this.#opening !== control) return false;
      if (isMissing(error)) this.lost.value = wanted;
      else this.report(error, () => this.#reach(wanted, go), `The map “${wanted.name}” cannot be shown: `);
      return false;
    } finally {
      if (this.#opening === control) loading.value = false;
    }
  }

  async #send(file: KeptFile, again: () => unknown): Promise<MapDescription | null> {
    const { page } = this;
    page.loading.value = true;
    page.notice.value = null;
    try {
      const map = await this.client.upload(file.bytes);
      this.#keep(map.id, file);
      return map;
    } catch (error) {
      this.report(error, again, `“${file.name}” cannot be used as a map: `);
      return null;
    } finally {
      page.loading.value = false;
    }
  }

  #keep(id: string, file: KeptFile): void {
    this.uploads.value = new Map(this.uploads.value).set(id, file);
  }

  #lostMap(id: string, resume: LostMap["resume"]): LostMap {
    const file = this.uploads.value.get(id) ?? null;
    return { id, name: file?.name ?? id, file, digest: null, resume };
  }

  // A file of the server's folder that was sent has another name than it had there.
  #rename(from: string, to: string): void {
    const { history, shown } = this.page;
    if (from === to || !history.value || !shown.value) return;
    const { base, map, ids } = shown.value;
    const renamed = { ...base, description: { ...base.description, id: to } };
    batch(() => {
      history.value = mapped(history.peek()!, (old) => (old.map === from ? { ...old, map: to } : old));
      if (base.description.id === from) shown.value = { base: renamed, map: map === base ? renamed : map, ids };
    });
  }
}
