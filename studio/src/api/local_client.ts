// The client of a page without a service: maps are files beside the page, as `waybreaker site` writes them, or in it
// (carried.ts), and a planner in Workers answers the rest.
import type { ReachDocument } from "../domain/bands";
import type { Background, MapDescription, Obstacles } from "../domain/map";
import type { Plan } from "../domain/plan";
import {
  type CheckReport,
  type Client,
  type Edits,
  type ExportFormat,
  mostObstacles,
  pause,
  type Progress,
  ServiceError,
  stopped,
  tooMany,
} from "./client";
import type { MapEntry, PlanRequest, RevisionAnswer, RevisionRequest } from "./documents";
import { type Port, PlannerWorkers } from "./planner_workers";
import { pngOf } from "./png";

// A map document ("waybreaker-map/1").
interface MapDocument {
  description: MapDescription;
  obstacles: Obstacles;
  background: Background;
}

interface Held extends MapDocument {
  text: string;
  file: Blob | null; // what was opened
}

// Where the maps are.
export interface Folder {
  fetched(path: string, signal?: AbortSignal): Promise<Response>; // a path below the page's own folder
  hasFiles: boolean; // the maps' own, beside their documents
}

const mostHeld = 8; // maps
const needsService = "“waybreaker serve” does this: this page has no server.";

const types: Record<ExportFormat, string> = {
  html: "text/html",
  png: "image/png",
  svg: "image/svg+xml",
  geojson: "application/geo+json",
  csv: "text/csv",
  json: "application/json",
};

export class LocalClient implements Client {
  readonly imports = false;
  readonly #held = new Map<string, Held>(); // the one used last at the end
  readonly #coming = new Map<string, Promise<Held>>(); // by those who asked first, for all who ask meanwhile
  readonly #listed = new Set<string>();
  readonly #workers: PlannerWorkers;

  constructor(start: () => Port, module: Promise<WebAssembly.Module>, private readonly folder: Folder = folderOfPage) {
    this.#workers = new PlannerWorkers(start, module, (map) => this.#known(map).text);
  }

  async maps(signal?: AbortSignal): Promise<MapEntry[]> {
    const { maps } = JSON.parse(await (await this.folder.fetched("maps.json", signal)).text()) as { maps: MapEntry[] };
    for (const { id } of maps) this.#listed.add(id);
    return maps;
  }

  async map(id: string, signal?: AbortSignal): Promise<MapDescription> {
    return (await this.#load(id, signal)).description;
  }

  async obstacles(id: string, signal?: AbortSignal): Promise<Obstacles> {
    return (await this.#load(id, signal)).obstacles;
  }

  async background(id: string, signal?: AbortSignal): Promise<Background> {
    return (await this.#load(id, signal)).background;
  }

  async upload(file: Blob, signal?: AbortSignal): Promise<MapDescription> {
    if (!(await file.slice(0, 20).text()).startsWith("type ")) {
      throw new ServiceError("refused", `Only maps of MovingAI's format (.map) can be opened here; of other files ${needsService}`);
    }
    const bytes = new Uint8Array(await file.arrayBuffer());
    const text = await this.#workers.ask({ what: "read", file: bytes }, { signal });
    return this.#keep(text, file).description;
  }

  async edit(id: string, edits: Edits, signal?: AbortSignal): Promise<MapDescription> {
    await this.#load(id, signal);
    const call = { what: "edit", of: id, edits: JSON.stringify(edits) } as const;
    return this.#keep(await this.#workers.ask(call, { needs: id, signal }), null).description;
  }

  async plan(
    id: string,
    request: PlanRequest,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<Plan> {
    await this.#load(id, signal);
    const call = { what: "plan", map: id, request: JSON.stringify(request) } as const;
    return JSON.parse(await this.#workers.ask(call, { needs: id, signal, onProgress })) as Plan;
  }

  async revise(id: string, request: RevisionRequest, signal?: AbortSignal): Promise<RevisionAnswer> {
    await this.#load(id, signal);
    const call = { what: "revise", map: id, request: JSON.stringify(request) } as const;
    return JSON.parse(await this.#workers.ask(call, { needs: id, signal })) as RevisionAnswer;
  }

  async check(id: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport> {
    await this.#load(id, signal);
    const call = { what: "check", map: id, plan: JSON.stringify(plan) } as const;
    return JSON.parse(await this.#workers.ask(call, { needs: id, signal })) as CheckReport;
  }

  async exported(id: string, plan: Plan, format: ExportFormat): Promise<Blob> {
    await this.#load(id);
    const drawn = format === "png" ? "svg" : format;
    const call = { what: "export", map: id, plan: JSON.stringify(plan), format: drawn } as const;
    const text = await this.#workers.ask(call, { needs: id });
    return format === "png" ? pngOf(text) : new Blob([text], { type: types[format] });
  }

  async reach(id: string, plan: Plan, signal?: AbortSignal): Promise<ReachDocument> {
    await this.#load(id, signal);
    const call = { what: "export", map: id, plan: JSON.stringify(plan), format: "reach" } as const;
    return JSON.parse(await this.#workers.ask(call, { needs: id, signal })) as ReachDocument;
  }

  hasFile(id: string): boolean {
    return (this.folder.hasFiles && this.#listed.has(id)) || Boolean(this.#held.get(id)?.file);
  }

  async file(id: string): Promise<{ bytes: Blob; name: string }> {
    const own = this.#held.get(id)?.file;
    if (own) return { bytes: own, name: `${id}.map` };
    if (!this.#listed.has(id)) throw new ServiceError("refused", `A map that was drawn on has no file here; ${needsService}`);
    return { bytes: await (await this.folder.fetched(`maps/${id}`)).blob(), name: id };
  }

  sendSource(): Promise<never> {
    return noService();
  }
  importMap(): Promise<never> {
    return noService();
  }
  overlay(): Promise<never> {
    return noService();
  }

  // A map that a Worker has made.
  #keep(text: string, file: Blob | null): Held {
    const document = JSON.parse(text) as MapDocument;
    return this.#hold(document.description.id, { ...document, text, file });
  }

  #hold(id: string, held: Held): Held {
    const { count } = held.description.obstacles;
    if (count > mostObstacles) throw tooMany(count);
    this.#held.delete(id);
    this.#held.set(id, held);
    const dispensable = [...this.#held.keys()].filter((other) => this.#listed.has(other) || other.startsWith("upload-"));
    for (const other of dispensable.slice(0, -mostHeld)) this.#held.delete(other);
    return held;
  }

  async #load(id: string, signal?: AbortSignal): Promise<Held> {
    if (signal?.aborted) throw stopped();
    const known = this.#held.get(id);
    if (known) return this.#hold(id, known);
    if (this.#listed.size === 0) await this.maps(signal);
    if (!this.#listed.has(id)) throw new ServiceError("missing", "There is no such map.");
    let coming = this.#coming.get(id);
    if (!coming) {
      coming = this.#fetchMap(id).finally(() => this.#coming.delete(id));
      this.#coming.set(id, coming);
    }
    const held = await coming;
    if (signal?.aborted) throw stopped();
    return this.#hold(id, held);
  }

  // Nobody's signal ends it: others may wait for it. Parsing is a task by itself, so that the page stays quick to answer.
  async #fetchMap(id: string): Promise<Held> {
    const text = await (await this.folder.fetched(`maps/${id}.json`)).text();
    const held = { ...(JSON.parse(text) as MapDocument), text, file: null };
    await pause(0);
    return held;
  }

  #known(map: string): Held {
    const held = this.#held.get(map);
    if (!held) throw new ServiceError("missing", "There is no such map.");
    return held;
  }
}

function noService(): Promise<never> {
  return Promise.reject(new ServiceError("refused", `Maps are made of map data by the service: ${needsService}`));
}

const folderOfPage: Folder = { fetched: fetchBelow, hasFiles: true };

async function fetchBelow(path: string, signal?: AbortSignal): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(path, { signal: signal ?? null });
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw stopped();
    throw new ServiceError("gone", "The server does not answer.");
  }
  if (answer.ok) return answer;
  if (answer.status === 404) throw new ServiceError("missing", "There is no such map.");
  throw new ServiceError("gone", "The server does not answer.");
}
