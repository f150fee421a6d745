// Workers that plan: calls go to one that is free. A Worker at work hears nothing, so that a call which is stopped ends
// with its Worker, unless it is soon done; another is started in its place, and is given the maps that it needs.
import { type Call, type FromWorker, idOfDocument, type ToWorker } from "../worker/messages";
import { type Progress, sentence, ServiceError, stopped } from "./client";

const count = 2; // a plan and the way without removals come together
const grace = 250; // ms that a stopped call has to end by itself: about what a new Worker and its map take
const mostMaps = 4; // in one Worker

// Of `Worker`.
export interface Port {
  postMessage(message: ToWorker): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

interface Job {
  needs: string | null; // a map
  call: Call;
  onProgress: ((best: number, bound: number) => void) | undefined;
  resolve(text: string): void;
  reject(error: unknown): void;
}

interface Slot {
  port: Port | null;
  maps: string[]; // that it holds, the one used last at the end
  job: Job | null;
  isStopping: boolean;
  answered: ((message: FromWorker) => void) | null;
}

export class PlannerWorkers {
  readonly #slots: Slot[] = Array.from({ length: count }, () => newSlot());
  #queue: Job[] = [];

  // `documentOf` a map that calls name.
  constructor(
    private readonly start: () => Port,
    private readonly module: Promise<WebAssembly.Module>,
    private readonly documentOf: (map: string) => string,
  ) {}

  // The text that the planner answers.
  ask(
    call: Call,
    { needs = null, signal, onProgress }: { needs?: string | null; signal?: AbortSignal | undefined; onProgress?: ((progress: Progress) => void) | undefined } = {},
  ): Promise<string> {
    const began = performance.now();
    const report = (best: number, bound: number) =>
      onProgress?.({ state: "planning", seconds: (performance.now() - began) / 1000, best: finite(best), bound: finite(bound) });
    return new Promise((resolve, reject) => {
      if (signal?.aborted) return reject(stopped());
      const job: Job = { needs, call, onProgress: onProgress && report, resolve, reject };
      signal?.addEventListener("abort", () => this.#stop(job), { once: true });
      this.#queue.push(job);
      this.#next();
    });
  }

  #next(): void {
    for (const job of [...this.#queue]) {
      const slot = this.#freeSlot(job);
      if (!slot) return;
      this.#queue = this.#queue.filter((other) => other !== job);
      slot.job = job;
      void this.#work(slot, job);
    }
  }

  // One that has the map comes first, then one that need not be started.
  #freeSlot({ needs }: Job): Slot | undefined {
    const free = this.#slots.filter((slot) => !slot.job);
    const having = needs === null ? undefined : free.find((slot) => slot.maps.includes(needs));
    if (this.#slots.every((slot) => slot.isStopping)) {
      const [slot] = this.#slots;
      end(slot!);
      return slot;
    }
    return having ?? free.find((slot) => slot.port) ?? free[0];
  }

  async #work(slot: Slot, job: Job): Promise<void> {
    try {
      const module = await this.module;
      if (slot.job !== job) return; // it was stopped meanwhile
      slot.port ??= this.#started(slot, module);
      const { needs } = job;
      if (needs !== null && !slot.maps.includes(needs)) {
        await this.#send(slot, { what: "open", map: needs, document: this.documentOf(needs) });
        slot.maps.push(needs);
      }
      const text = await this.#send(slot, job.call, job.onProgress);
      await this.#keepFew(slot, job, text);
      job.resolve(text);
    } catch (error) {
      job.reject(error instanceof ServiceError ? error : new ServiceError("gone", "The planner could not be fetched."));
    }
    if (slot.job !== job) return; // it has ended meanwhile
    slot.job = null;
    slot.isStopping = false;
    this.#next();
  }

  async #keepFew(slot: Slot, { needs, call }: Job, text: string): Promise<void> {
    const used = call.what === "read" || call.what === "edit" ? idOfDocument(text) : needs;
    if (used !== null) slot.maps = [...slot.maps.filter((map) => map !== used), used];
    while (slot.maps.length > mostMaps) await this.#send(slot, { what: "close", map: slot.maps.shift()! });
  }

  #started(slot: Slot, module: WebAssembly.Module): Port {
    const port = this.start();
    port.onmessage = ({ data }) => slot.port === port && slot.answered?.(data);
    port.onerror = ({ message }) => slot.port === port && slot.answered?.({ kind: "failed", reason: message });
    port.postMessage(module);
    return port;
  }

  #send(slot: Slot, call: Call, onProgress?: Job["onProgress"]): Promise<string> {
    return new Promise((resolve, reject) => {
      slot.answered = (message) => {
        if (message.kind === "progress") return onProgress?.(message.best, message.bound);
        slot.answered = null;
        if (message.kind === "answer") return resolve(message.text);
        if (message.kind === "failed") end(slot);
        const reason = message.kind === "failed" ? `The planner failed (${message.reason})` : message.reason;
        reject(new ServiceError("refused", sentence(reason)));
      };
      slot.port!.postMessage(call);
    });
  }

  #stop(job: Job): void {
    job.reject(stopped());
    this.#queue = this.#queue.filter((other) => other !== job);
    const slot = this.#slots.find((one) => one.job === job);
    if (!slot) return;
    slot.isStopping = true;
    setTimeout(() => {
      if (slot.job !== job) return;
      end(slot);
      slot.job = null;
      this.#next();
    }, grace);
    queueMicrotask(() => this.#next()); // others are stopped in the same moment
  }
}

function newSlot(): Slot {
  return { port: null, maps: [], job: null, isStopping: false, answered: null };
}

// The next call starts another.
function end(slot: Slot): void {
  slot.port?.terminate();
  Object.assign(slot, { port: null, maps: [], isStopping: false, answered: null });
}

function finite(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}
