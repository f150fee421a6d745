// Importing a map from map data: a file is sent, a window chosen, and the map opened.
import { signal } from "@preact/signals";
import { type Client, ServiceError } from "../api/client";
import { type ImportRequest, isWhole, type Source, usualImport } from "../domain/extract";
import type { MapDescription } from "../domain/map";
import type { KeptFile } from "./kept_file";

// How far an import has come.
export interface ImportState {
  name: string; // of the file
  stage: "sending" | "choosing" | "importing" | "failed"; // failed: there is nothing to choose from
  source: Source | null;
  request: ImportRequest | null;
  failure: string | null;
}

const usualLimit = 32; // MB that a service takes unless it is told otherwise
const notShown = "What the server says of this file cannot be shown.";

export class Importer {
  readonly state = signal<ImportState | null>(null);
  #control = new AbortController();
  #file: KeptFile | null = null;

  constructor(
    private readonly client: Client,
    private readonly done: (map: MapDescription, file: KeptFile) => Promise<unknown>,
  ) {}

  async begin(file: KeptFile): Promise<void> {
    this.cancel();
    this.#file = file;
    const { signal } = (this.#control = new AbortController());
    this.state.value = { name: file.name, stage: "sending", source: null, request: null, failure: null };
    try {
      const source = await this.client.sendSource(file.bytes, file.name, signal);
      if (!isWhole(source)) return this.fail();
      this.#set({ stage: "choosing", source, request: usualImport(source) });
    } catch (error) {
      if (!signal.aborted) this.#set({ stage: "failed", failure: this.#said(error) });
    }
  }

  choose(part: Partial<ImportRequest>): void {
    const { request } = this.state.peek() ?? {};
    if (request) this.#set({ request: { ...request, ...part }, failure: null });
  }

  async finish(): Promise<void> {
    const state = this.state.peek();
    if (state?.stage !== "choosing" || !state.request) return;
    const { signal } = (this.#control = new AbortController());
    this.#set({ stage: "importing", failure: null });
    try {
      const map = await this.#imported(state.request, signal);
      // The map's own file, to send it again if the service has lost it.
      const { bytes } = await this.client.file(map.id);
      if (signal.aborted) return;
      this.state.value = null;
      await this.done(map, { name: `${state.name.replace(/\..*$/, "") || "map"}.tif`, bytes });
    } catch (error) {
      if (!signal.aborted) this.#set({ stage: "choosing", failure: this.#said(error) });
    }
  }

  // What the service says of the file cannot be shown. The next file is another matter.
  fail(): void {
    this.#set({ stage: "failed", source: null, request: null, failure: notShown });
  }

  cancel(): void {
    this.#control.abort();
    this.state.value = null;
  }

  // The service forgets map data after a while: then it is sent once more.
  async #imported(request: ImportRequest, signal: AbortSignal): Promise<MapDescription> {
    try {
      return await this.client.importMap(request, signal);
    } catch (error) {
      if (!(error instanceof ServiceError && error.trouble === "missing") || !this.#file) throw error;
      const source = await this.client.sendSource(this.#file.bytes, this.#file.name, signal);
      return this.client.importMap({ ...request, source: source.id }, signal);
    }
  }

  #set(part: Partial<ImportState>): void {
    const state = this.state.peek();
    if (state) this.state.value = { ...state, ...part };
  }

  #said(error: unknown): string {
    if (!(error instanceof ServiceError)) {
      console.error(error);
      return notShown;
    }
    const megabytes = (this.#file?.bytes.size ?? 0) / 2 ** 20;
    if (error.trouble === "gone" && megabytes > usualLimit) {
      return `The file has ${Math.round(megabytes)} MB, probably more than the server takes (--max-upload). Cut a piece out of it.`;
    }
    return aboutTheFile(error.message);
  }
}

// The service begins with the name of the file: "town.osm: has no buildings." Here it stands above.
function aboutTheFile(message: string): string {
  return message.replace(/^[\w.-]+: its /, "Its ").replace(/^[\w.-]+: (?=(has|is|cannot|does) )/, "The file ");
}
