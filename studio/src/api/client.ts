// What answers the page: the service over HTTP (http_client.ts), or the page itself, by a planner that it brings along
// (local_client.ts). Every failure is a ServiceError with a sentence for people.
import type { ReachDocument } from "../domain/bands";
import type { ImportRequest, Source } from "../domain/extract";
import type { Run } from "../domain/geometry";
import type { Background, MapDescription, Obstacles } from "../domain/map";
import type { Plan } from "../domain/plan";
import type { MapEntry, PlanRequest, RevisionAnswer, RevisionRequest } from "./documents";

export interface Client {
  readonly imports: boolean; // whether it makes maps of map data, and lays data over maps

  maps(signal?: AbortSignal): Promise<MapEntry[]>;
  map(id: string, signal?: AbortSignal): Promise<MapDescription>;
  obstacles(id: string, signal?: AbortSignal): Promise<Obstacles>;
  background(id: string, signal?: AbortSignal): Promise<Background>;
  upload(file: Blob, signal?: AbortSignal): Promise<MapDescription>;
  edit(id: string, edits: Edits, signal?: AbortSignal): Promise<MapDescription>;
  plan(
    id: string,
    request: PlanRequest,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<Plan>;
  check(id: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport>;
  exported(id: string, plan: Plan, format: ExportFormat): Promise<Blob>;
  reach(id: string, plan: Plan, signal?: AbortSignal): Promise<ReachDocument>;
  hasFile(id: string): boolean;
  file(id: string): Promise<{ bytes: Blob; name: string }>;

  revise(id: string, request: RevisionRequest, signal?: AbortSignal): Promise<RevisionAnswer>;

  // Where `imports` says so.
  sendSource(file: Blob, name: string, signal?: AbortSignal): Promise<Source>;
  importMap(request: ImportRequest, signal?: AbortSignal): Promise<MapDescription>;
  overlay(id: string, overlay: OverlayFile, signal?: AbortSignal): Promise<MapDescription>;
}

export type Trouble =
  | "refused" // by the service, which says why
  | "missing" // there is no such map, or map data (any more)
  | "gone" // no response
  | "stopped"; // cancelled by the page

export class ServiceError extends Error {
  constructor(
    readonly trouble: Trouble,
    message: string,
  ) {
    super(message);
  }
}

export function stopped(): ServiceError {
  return new ServiceError("stopped", "Stopped.");
}

export interface CheckReport {
  valid: boolean;
  violations: { rule: string; message: string }[];
}

export interface Edits {
  block: Run[];
  free: Run[];
}

// `width` of its lines in metres.
export interface OverlayFile {
  file: { name: string; bytes: Blob };
  use: string;
  width: number;
}

export interface Progress {
  state: "queued" | "planning";
  seconds: number;
  best?: number | null; // the objective of the best plan so far
  bound?: number | null; // a lower bound of it
}

export type ExportFormat = "html" | "png" | "svg" | "geojson" | "csv" | "json";

export const mostObstacles = 500_000; // more would take gigabytes in the browser

export function tooMany(count?: number): ServiceError {
  const [has, most] = [count?.toLocaleString("en"), mostObstacles.toLocaleString("en")];
  const words = `The map has ${has ? `${has} obstacles, more` : "more obstacles"} than a page can show (${most}).`;
  return new ServiceError("refused", `${words} “waybreaker plan” takes it.`);
}

export function sentence(text: string): string {
  const full = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(full) ? full : `${full}.`;
}

export function pause(milliseconds: number, signal?: AbortSignal): Promise<void> {
  return new Promise((done, fail) => {
    const stop = () => {
      clearTimeout(timer);
      fail(stopped());
    };
    const timer = setTimeout(() => {
      signal?.removeEventListener("abort", stop);
      done();
    }, milliseconds);
    if (signal?.aborted) stop();
    else signal?.addEventListener("abort", stop, { once: true });
  });
}
