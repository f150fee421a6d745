// Maps as the page holds them: the one that was chosen, and it as drawn on.
import { type Client, type Edits, ServiceError } from "../api/client";
import { CellMap } from "../domain/cell_map";
import type { Background, MapDescription } from "../domain/map";
import type { KeptFile } from "./kept_file";
import type { Translation } from "./translate";

export interface HeldMap {
  description: MapDescription;
  cells: CellMap;
  background: Background;
}

// A map with everything drawn on it, and how to find obstacles of the base map there.
export interface ShownMap {
  base: HeldMap;
  map: HeldMap;
  ids: Translation;
}

// A map that the service does not have, and what to do once it has it, under whatever name.
export interface LostMap {
  id: string;
  name: string; // as the person knows it
  file: KeptFile | null; // what was sent
  digest: string | null; // of the file, where it is known
  resume(id: string): void;
}

export function isMissing(error: unknown): boolean {
  return error instanceof ServiceError && error.trouble === "missing";
}

// Whether a map was sent to the service. Its name is made of its bytes.
export function isUpload(id: string): boolean {
  return id.startsWith("upload-");
}

export class Maps {
  #edited: { key: string; map: HeldMap } | null = null;

  constructor(private readonly client: Client) {}

  async load(id: string, signal?: AbortSignal): Promise<HeldMap> {
    const [description, obstacles, background] = await Promise.all([
      this.client.map(id, signal),
      this.client.obstacles(id, signal),
      this.background(id, signal),
    ]);
    return { description, cells: new CellMap(obstacles), background };
  }

  async edited(base: HeldMap, edits: Edits, signal?: AbortSignal): Promise<HeldMap> {
    const key = `${base.description.id} ${JSON.stringify(edits)}`;
    if (this.#edited?.key === key) return this.#edited.map;
    const description = await this.client.edit(base.description.id, edits, signal);
    const obstacles = await this.client.obstacles(description.id, signal);
    const map = { description, cells: new CellMap(obstacles), background: base.background };
    this.#edited = { key, map };
    return map;
  }

  // The service keeps only so many maps that nobody asks for.
  forget(): void {
    this.#edited = null;
  }

  // A picture below the obstacles is not worth a failure.
  private async background(id: string, signal?: AbortSignal): Promise<Background> {
    try {
      return await this.client.background(id, signal);
    } catch (error) {
      if (error instanceof ServiceError && error.trouble !== "missing" && error.trouble !== "refused") throw error;
      return { features: [] };
    }
  }
}
