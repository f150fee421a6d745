// The page's side of a planner in a worker. One call at a time is with the worker, so that a call that is cancelled
// takes only itself along: the worker is ended, a new one is started, and maps are made again there when they are needed.
import type { Mission, Plan, Report, State } from "./documents.js";
import { errorNamed, InputError, InternalError } from "./errors.js";
import { textOf } from "./library.js";
import type { GridOptions, LabelOptions, MapEdit, Obstacle } from "./maps.js";
import type { Continuity, PlanOptions, ReviseOptions } from "./options.js";
import type { Call, FromWorker, MapFacts, MapMaker, Recipe, ToWorker } from "./worker_messages.js";

export interface Cancellable {
  /** Its abort ends the call, which rejects with the signal's reason. */
  signal?: AbortSignal;
}

/** A running worker, whatever the platform calls it. */
export interface Connection {
  post(message: ToWorker): void;
  /** Whether it keeps a program from ending. */
  hold(busy: boolean): void;
  end(): void;
}

export interface Listener {
  answered(message: FromWorker): void;
  failed(error: unknown): void;
}

interface Running {
  connection: Connection;
  /** Maps that are made there. */
  maps: Set<number>;
}

interface Pending {
  id: number;
  resolve(result: unknown): void;
  reject(error: unknown): void;
}

type Ask = (method: Call["method"], ...parameters: unknown[]) => Promise<unknown>;

/** A map of a planner in a worker. It keeps what it was made from, to be made again after a call was cancelled. */
export class WorkerMap {
  readonly width: number;
  readonly height: number;
  readonly obstacleCount: number;
  readonly digest: string;
  readonly #ask: Ask;
  readonly #edited: (edits: readonly MapEdit[]) => Promise<WorkerMap>;
  readonly #free: () => void;

  /** @internal */
  constructor(
    facts: MapFacts,
    /** @internal */ readonly id: number,
    ask: Ask,
    edited: (edits: readonly MapEdit[]) => Promise<WorkerMap>,
    free: () => void,
  ) {
    this.width = facts.width;
    this.height = facts.height;
    this.obstacleCount = facts.obstacleCount;
    this.digest = facts.digest;
    this.#ask = ask;
    this.#edited = edited;
    this.#free = free;
  }

  async labels(): Promise<Uint32Array> {
    return (await this.#ask("labels")) as Uint32Array;
  }
  async obstacle(id: number): Promise<Obstacle | undefined> {
    return (await this.#ask("obstacle", id)) as Obstacle | undefined;
  }
  /** The map with its obstacles changed; this one stays as it is. */
  with(edits: readonly MapEdit[]): Promise<WorkerMap> {
    return this.#edited(edits);
  }
  /** Frees its memory; the map cannot be used afterwards. */
  free(): void {
    this.#free();
  }
}

/** The planner of `waybreaker` in a worker: the same calls, each a promise, and each can be cancelled. */
export class WorkerPlanner {
  readonly #module: WebAssembly.Module;
  readonly #start: (listener: Listener) => Connection;
  #running: Running | undefined;
  #pending: Pending | undefined;
  #last: Promise<void> = Promise.resolve();
  #closed = false;
  #nextId = 1;
  /** What maps were made from, by id. */
  readonly #recipes = new Map<number, Recipe>();
  readonly #forgotten = new FinalizationRegistry<number>((id) => this.#free(id));

  /** @internal */
  constructor(module: WebAssembly.Module, start: (listener: Listener) => Connection) {
    this.#module = module;
    this.#start = start;
  }

  mapFromMovingAI(file: string | Uint8Array, options: GridOptions = {}): Promise<WorkerMap> {
    return this.#map("mapFromMovingAI", file, options);
  }
  mapFromGrid(width: number, height: number, blocked: Uint8Array, options: GridOptions = {}): Promise<WorkerMap> {
    return this.#map("mapFromGrid", width, height, blocked.slice(), options);
  }
  mapFromLabels(width: number, height: number, labels: Uint32Array, options: LabelOptions = {}): Promise<WorkerMap> {
    return this.#map("mapFromLabels", width, height, labels.slice(), options);
  }

  async plan(map: WorkerMap, mission: Mission | string, options?: PlanOptions & Cancellable): Promise<Plan> {
    return JSON.parse(await this.planText(map, mission, options)) as Plan;
  }
  planText(map: WorkerMap, mission: Mission | string, options?: PlanOptions & Cancellable): Promise<string> {
    return this.#planning("planText", map, mission, options);
  }
  async front(map: WorkerMap, mission: Mission | string, options?: PlanOptions & Cancellable): Promise<Plan> {
    return JSON.parse(await this.frontText(map, mission, options)) as Plan;
  }
  frontText(map: WorkerMap, mission: Mission | string, options?: PlanOptions & Cancellable): Promise<string> {
    return this.#planning("frontText", map, mission, options);
  }
  async revise(map: WorkerMap, plan: Plan | string, state: State | string, options?: ReviseOptions & Cancellable): Promise<Plan> {
    return JSON.parse(await this.reviseText(map, plan, state, options)) as Plan;
  }
  reviseText(
    map: WorkerMap,
    plan: Plan | string,
    state: State | string,
    { signal, ...options }: ReviseOptions & Cancellable = {},
  ): Promise<string> {
    return this.#ask(map.id, "reviseText", [textOf(plan), textOf(state), options], signal) as Promise<string>;
  }
  check(map: WorkerMap, plan: Plan | string, options: Cancellable & Partial<Continuity> = {}): Promise<Report> {
    const { signal, ...continuity } = options;
    return this.#ask(map.id, "check", [textOf(plan), continuity], signal) as Promise<Report>;
  }
  svg(map: WorkerMap, plan: Plan | string, options: Cancellable = {}): Promise<string> {
    return this.#ask(map.id, "svg", [textOf(plan)], options.signal) as Promise<string>;
  }

  /** Ends the worker; calls that have no answer yet reject. */
  close(): void {
    this.#closed = true;
    this.#restart(new InputError("the planner has been closed"));
    this.#recipes.clear();
  }

  #planning(
    method: "planText" | "frontText",
    map: WorkerMap,
    mission: Mission | string,
    { signal, ...options }: PlanOptions & Cancellable = {},
  ): Promise<string> {
    return this.#ask(map.id, method, [textOf(mission), options], signal) as Promise<string>;
  }

  #map(maker: MapMaker, ...parameters: unknown[]): Promise<WorkerMap> {
    const recipe = { maker, parameters, edits: [] };
    return this.#made(recipe, (id) => this.#ask(id, "make", [recipe]));
  }

  // Of the map that is there; it is made anew from what that one was made from.
  async #edited(before: number, edits: readonly MapEdit[]): Promise<WorkerMap> {
    const recipe = this.#recipe(before);
    const asked = structuredClone(edits);
    return this.#made({ ...recipe, edits: [...recipe.edits, ...asked] }, (id) => this.#ask(before, "edit", [id, asked]));
  }

  async #made(recipe: Recipe, make: (id: number) => Promise<unknown>): Promise<WorkerMap> {
    const id = this.#nextId++;
    this.#recipes.set(id, recipe);
    try {
      const facts = (await make(id)) as MapFacts;
      const map = new WorkerMap(
        facts,
        id,
        (method, ...parameters) => this.#ask(id, method, parameters),
        (edits) => this.#edited(id, edits),
        () => this.#free(id),
      );
      this.#forgotten.register(map, id);
      return map;
    } catch (error) {
      this.#recipes.delete(id);
      throw error;
    }
  }

  #free(id: number): void {
    this.#recipes.delete(id);
    void this.#queue(async () => {
      if (this.#running?.maps.delete(id)) await this.#send(id, "free", []);
    }).catch(() => undefined);
  }

  #ask(map: number, method: Call["method"], parameters: unknown[], signal?: AbortSignal): Promise<unknown> {
    return this.#queue(async () => {
      const recipe = this.#recipe(map);
      if (method !== "make" && !this.#worker().maps.has(map)) await this.#send(map, "make", [recipe]);
      return this.#send(map, method, parameters);
    }, signal);
  }

  #recipe(map: number): Recipe {
    const recipe = this.#recipes.get(map);
    if (recipe === undefined) throw new InputError("the map has been freed");
    return recipe;
  }

  // Runs `work` after all that was asked for before.
  #queue<T>(work: () => Promise<T>, signal?: AbortSignal): Promise<T> {
    return new Promise<T>((resolve, reject) => {
      let running = false;
      const abort = (): void => {
        reject(signal!.reason);
        if (running) this.#restart(signal!.reason);
      };
      if (signal?.aborted) return reject(signal.reason);
      signal?.addEventListener("abort", abort);
      this.#last = this.#last.then(async () => {
        if (signal?.aborted) return;
        running = true;
        try {
          if (this.#closed) throw new InputError("the planner has been closed");
          resolve(await work());
        } catch (error) {
          reject(error);
        }
        signal?.removeEventListener("abort", abort);
      });
    });
  }

  // A message to the worker, and its answer.
  async #send(map: number, method: Call["method"], parameters: unknown[]): Promise<unknown> {
    const { connection, maps } = this.#worker();
    const id = this.#nextId++;
    connection.hold(true);
    try {
      const result = await new Promise((resolve, reject) => {
        this.#pending = { id, resolve, reject };
        connection.post({ id, map, method, parameters });
      });
      if (method === "make") maps.add(map);
      if (method === "edit") maps.add(parameters[0] as number);
      return result;
    } catch (error) {
      if (error instanceof InternalError) this.#restart(error);
      throw error;
    } finally {
      this.#pending = undefined;
      connection.hold(false);
    }
  }

  #worker(): Running {
    if (this.#running === undefined) {
      const connection = this.#start({
        answered: (message) => this.#answered(message),
        failed: (error) => this.#restart(new InternalError(`the worker has failed (${error})`)),
      });
      connection.post(this.#module);
      this.#running = { connection, maps: new Set() };
    }
    return this.#running;
  }

  #answered(message: FromWorker): void {
    if (message.id !== this.#pending?.id) return;
    if ("result" in message) {
      this.#pending.resolve(message.result);
    } else {
      this.#pending.reject(errorNamed(message.error.name, message.error.message));
    }
  }

  // Ends the worker, and the call that is with it. The next call starts another.
  #restart(reason: unknown): void {
    this.#running?.connection.end();
    this.#running = undefined;
    this.#pending?.reject(reason);
  }
}
