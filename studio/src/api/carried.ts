// The client of a page that carries its map and its planner in itself, as `waybreaker plan --html --steerable` writes it.
import type { MapDescription } from "../domain/map";
import type { Plan } from "../domain/plan";
import { LocalClient } from "./local_client";

// What the document carries, each in an element of its own.
export interface Carried {
  map: string; // a map document ("waybreaker-map/1")
  plan: Plan;
  planner: string; // studio.wasm by gzip, in base64
  worker: string; // the script of the Worker
}

// Null where the document carries no planner.
export function carriedBy(document: Document): Carried | null {
  const text = (part: string) => document.getElementById(`waybreaker-${part}`)?.textContent ?? "";
  const [map, plan, planner, worker] = ["map", "plan", "planner", "worker"].map(text) as [string, string, string, string];
  return planner === "" ? null : { map, plan: JSON.parse(plan) as Plan, planner, worker };
}

export function carriedClient({ map, planner, worker }: Carried): LocalClient {
  const { id } = (JSON.parse(map) as { description: MapDescription }).description;
  const files = new Map([["maps.json", JSON.stringify({ maps: [{ id, uploaded: false, loaded: true }] })], [`maps/${id}.json`, map]]);
  const script = URL.createObjectURL(new Blob([worker], { type: "text/javascript" }));
  const start = () => new Worker(script);
  return new LocalClient(start, compiled(planner), { fetched: async (path) => new Response(files.get(path)!), hasFiles: false });
}

async function compiled(planner: string): Promise<WebAssembly.Module> {
  const packed = Uint8Array.from(atob(planner), (letter) => letter.charCodeAt(0));
  const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}
