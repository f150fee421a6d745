// The client of a service over HTTP. Requests to a busy server are retried.
import type { ReachDocument } from "../domain/bands";
import type { ImportRequest, Source } from "../domain/extract";
import type { Background, MapDescription, Obstacles } from "../domain/map";
import type { Plan } from "../domain/plan";
import {
  type CheckReport,
  type Client,
  type Edits,
  type ExportFormat,
  mostObstacles,
  type OverlayFile,
  pause,
  type Progress,
  sentence,
  ServiceError,
  stopped,
  tooMany,
} from "./client";
import type { MapEntry, PlanRequest, ProblemDocument, RevisionAnswer, RevisionRequest } from "./documents";
import { readEvents } from "./events";

interface Ask {
  method?: "GET" | "POST" | "DELETE";
  json?: unknown;
  bytes?: Blob;
  accept?: string;
  signal?: AbortSignal | undefined;
}

// Where a token comes from; `ask` asks the person, who may have been asked already.
export interface TokenSource {
  current(): string;
  ask(): Promise<string>;
}

const mostTries = 6;
const longestWait = 5; // seconds

export class HttpClient implements Client {
  readonly imports = true;

  constructor(
    private readonly token: TokenSource,
    private readonly base = "/api/v1",
  ) {}

  async maps(signal?: AbortSignal): Promise<MapEntry[]> {
    return (await this.json<{ maps: MapEntry[] }>("/maps", { signal })).maps;
  }

  async map(id: string, signal?: AbortSignal): Promise<MapDescription> {
    return this.described(mapPath(id), { signal });
  }

  // The service gives those of large maps in parts.
  async obstacles(id: string, signal?: AbortSignal): Promise<Obstacles> {
    const path = mapPath(id, "obstacles");
    const whole = await this.json<Obstacles>(path, { signal });
    for (let next = whole.next; typeof next === "number"; ) {
      if (whole.obstacles.length > mostObstacles) throw tooMany();
      const part = await this.json<Obstacles>(`${path}?after=${next}`, { signal });
      whole.obstacles = whole.obstacles.concat(part.obstacles);
      whole.runs = whole.runs.concat(part.runs);
      next = part.next;
    }
    return whole;
  }

  async background(id: string, signal?: AbortSignal): Promise<Background> {
    return this.json(mapPath(id, "background"), { signal });
  }

  upload(file: Blob, signal?: AbortSignal): Promise<MapDescription> {
    return this.described("/maps", { method: "POST", bytes: file, signal });
  }

  // Map data, to import maps from.
  sendSource(file: Blob, name: string, signal?: AbortSignal): Promise<Source> {
    return this.json(`/sources?name=${harmless(name, "source")}`, { method: "POST", bytes: file, signal });
  }

  importMap(request: ImportRequest, signal?: AbortSignal): Promise<MapDescription> {
    return this.described("/imports", { method: "POST", json: request, signal });
  }

  // Map data, laid over a map; `width` of its lines in metres.
  overlay(id: string, { file, use, width }: OverlayFile, signal?: AbortSignal): Promise<MapDescription> {
    const query = `as=${use}&width=${width}&name=${harmless(file.name, "overlay")}`;
    return this.described(`${mapPath(id, "overlays")}?${query}`, { method: "POST", bytes: file.bytes, signal });
  }

  edit(id: string, edits: Edits, signal?: AbortSignal): Promise<MapDescription> {
    return this.described(mapPath(id, "edits"), { method: "POST", json: edits, signal });
  }

  plan(
    id: string,
    request: PlanRequest,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<Plan> {
    return this.stream(mapPath(id, "plan"), request, signal, onProgress);
  }

  check(id: string, plan: Plan, signal?: AbortSignal): Promise<CheckReport> {
    return this.json(mapPath(id, "check"), { method: "POST", json: plan, signal });
  }

  revise(id: string, request: RevisionRequest, signal?: AbortSignal): Promise<RevisionAnswer> {
    return this.json(mapPath(id, "revise"), { method: "POST", json: request, signal });
  }

  async exported(id: string, plan: Plan, format: ExportFormat): Promise<Blob> {
    const answer = await this.ask(`${mapPath(id, "export")}?format=${format}`, { method: "POST", json: plan });
    return answer.blob();
  }

  reach(id: string, plan: Plan, signal?: AbortSignal): Promise<ReachDocument> {
    return this.json(`${mapPath(id, "export")}?format=reach`, { method: "POST", json: plan, signal });
  }

  hasFile(): boolean {
    return true;
  }

  async file(id: string): Promise<{ bytes: Blob; name: string }> {
    const answer = await this.ask(mapPath(id, "file"), {});
    const name = /filename="([^"]+)"/.exec(answer.headers.get("Content-Disposition") ?? "")?.[1] ?? id;
    return { bytes: await answer.blob(), name };
  }

  // A map that the page cannot show is refused before its obstacles are fetched.
  private async described(path: string, ask: Ask): Promise<MapDescription> {
    const map = await this.json<MapDescription>(path, ask);
    if (map.obstacles.count > mostObstacles) throw tooMany(map.obstacles.count);
    return map;
  }

  private async json<T>(path: string, ask: Ask): Promise<T> {
    const answer = await this.ask(path, ask);
    try {
      return (await answer.json()) as T;
    } catch (error) {
      throw understood(error);
    }
  }

  // The planner stops when the page disconnects, so all plans are streamed.
  private async stream<T>(
    path: string,
    json: unknown,
    signal?: AbortSignal,
    onProgress?: (progress: Progress) => void,
  ): Promise<T> {
    const answer = await this.ask(path, { method: "POST", json, signal, accept: "text/event-stream" });
    let result: T | null = null;
    try {
      // Read to the end, so that the connection can be reused.
      for await (const { name, data } of readEvents(answer)) {
        if (name === "progress") onProgress?.(JSON.parse(data) as Progress);
        if (name === "plan") result = JSON.parse(data) as T;
        if (name === "problem") throw refusal(JSON.parse(data) as ProblemDocument);
      }
    } catch (error) {
      throw understood(error);
    }
    if (result) return result;
    throw new ServiceError("gone", "The server hung up before the plan was ready.");
  }

  private async ask(path: string, ask: Ask): Promise<Response> {
    for (let tries = 1; ; ++tries) {
      const answer = await this.send(path, ask);
      if (answer.ok) return answer;
      if (answer.status === 401) {
        await this.token.ask();
        continue;
      }
      if (answer.status !== 503 || tries === mostTries) throw await failure(answer);
      const seconds = Number(answer.headers.get("Retry-After")) || 1;
      await pause(1000 * Math.min(seconds, longestWait), ask.signal);
    }
  }

  private async send(path: string, { method = "GET", json, bytes, accept, signal }: Ask): Promise<Response> {
    const headers = new Headers({ Accept: accept ?? "application/json" });
    const token = this.token.current();
    if (token) headers.set("Authorization", `Bearer ${token}`);
    if (json !== undefined) headers.set("Content-Type", "application/json");
    if (bytes) headers.set("Content-Type", "application/octet-stream");
    const body = bytes ?? (json === undefined ? null : JSON.stringify(json));
    try {
      return await fetch(this.base + path, { method, headers, body, signal: signal ?? null });
    } catch (error) {
      throw understood(error);
    }
  }
}

// As files may be called in queries.
function harmless(name: string, otherwise: string): string {
  return name.replaceAll(/[^A-Za-z0-9._-]+/g, "_").replace(/^\.+/, "").slice(-100) || otherwise;
}

// No map can have another name; links may hold anything.
const mapName = /^[\w-][\w.-]{0,99}$/;

function mapPath(id: string, what = ""): string {
  if (!mapName.test(id)) throw new ServiceError("missing", "No map can have this name.");
  return `/maps/${encodeURIComponent(id)}${what && `/${what}`}`;
}

function refusal(problem: ProblemDocument): ServiceError {
  const isLost = /\/(map|source)-not-found$/.test(problem.type ?? "");
  return new ServiceError(isLost ? "missing" : "refused", sentence(problem.detail || problem.title));
}

// What answers without a problem document is not the service, but a proxy that does not find it.
async function failure(answer: Response): Promise<ServiceError> {
  const type = answer.headers.get("Content-Type") ?? "";
  if (type.includes("problem+json")) {
    try {
      return refusal((await answer.json()) as ProblemDocument);
    } catch (error) {
      return understood(error);
    }
  }
  if (answer.status >= 500) return new ServiceError("gone", "The server does not answer.");
  return new ServiceError("refused", `The server answers with error ${answer.status}.`);
}

function understood(error: unknown): ServiceError {
  if (error instanceof ServiceError) return error;
  if (error instanceof DOMException && error.name === "AbortError") return stopped();
  return new ServiceError("gone", "The server does not answer.");
}
