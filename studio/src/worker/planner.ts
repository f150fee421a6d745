// The planner's WebAssembly module (src/web/web.cpp), and the maps that it holds.
import { type Call, idOfDocument } from "./messages";

export class Refused extends Error {}

export type Report = (best: number, bound: number) => void;

type Place = number; // in the module's memory

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  malloc(bytes: number): Place;
  free(place: Place): void;
  answer_data(): Place;
  answer_size(): number;
  open_map(document: Place, size: number): number;
  read_map(file: Place, size: number): number;
  edit(map: number, edits: Place, size: number): number;
  close_map(map: number): void;
  plan(map: number, request: Place, size: number): number;
  revise(map: number, request: Place, size: number): number;
  check(map: number, plan: Place, size: number): number;
  export_plan(map: number, plan: Place, size: number, format: Place, formatSize: number): number;
}

export class Planner {
  readonly #wasm: Exports;
  readonly #maps = new Map<string, number>();

  constructor(module: WebAssembly.Module, report: Report) {
    const memory = () => this.#wasm.memory.buffer;
    const instance = new WebAssembly.Instance(module, imports(module, memory, report));
    this.#wasm = instance.exports as unknown as Exports;
    this.#wasm._initialize();
  }

  // The text that a call answers. Throws Refused.
  run(call: Call): string {
    const wasm = this.#wasm;
    switch (call.what) {
      case "open":
        this.#maps.set(call.map, Number(this.#answer(call.document, wasm.open_map)));
        return "";
      case "read":
        return this.#newMap(this.#answer(call.file, wasm.read_map));
      case "edit": {
        const before = this.#number(call.of);
        return this.#newMap(this.#answer(call.edits, (place, size) => wasm.edit(before, place, size)));
      }
      case "close":
        wasm.close_map(this.#number(call.map));
        this.#maps.delete(call.map);
        return "";
      case "plan": {
        const map = this.#number(call.map);
        return this.#answer(call.request, (place, size) => wasm.plan(map, place, size));
      }
      case "revise": {
        const map = this.#number(call.map);
        return this.#answer(call.request, (place, size) => wasm.revise(map, place, size));
      }
      case "check": {
        const map = this.#number(call.map);
        return this.#answer(call.plan, (place, size) => wasm.check(map, place, size));
      }
      case "export": {
        const map = this.#number(call.map);
        return this.#with(call.format, (format, formatSize) =>
          this.#answer(call.plan, (place, size) => wasm.export_plan(map, place, size, format, formatSize)),
        );
      }
    }
  }

  #number(map: string): number {
    const number = this.#maps.get(map);
    if (number === undefined) throw new Error(`no map is called ${map}`);
    return number;
  }

  // A map that the module has made: its number, an end of line, its document.
  #newMap(answer: string): string {
    const end = answer.indexOf("\n");
    const document = answer.slice(end + 1);
    this.#maps.set(idOfDocument(document), Number(answer.slice(0, end)));
    return document;
  }

  #answer(input: string | Uint8Array, call: (place: Place, size: number) => number): string {
    const isAnswer = this.#with(input, call) !== 0;
    const at = this.#wasm.answer_data();
    const text = decoder.decode(new Uint8Array(this.#wasm.memory.buffer, at, this.#wasm.answer_size()));
    if (!isAnswer) throw new Refused(text);
    return text;
  }

  // Calls `use` with a place in memory that holds the input, for that long.
  #with<T>(input: string | Uint8Array, use: (place: Place, size: number) => T): T {
    const bytes = typeof input === "string" ? encoder.encode(input) : input;
    const place = this.#wasm.malloc(Math.max(bytes.length, 1));
    if (place === 0) throw new Refused("there is not enough memory");
    try {
      new Uint8Array(this.#wasm.memory.buffer, place, bytes.length).set(bytes);
      return use(place, bytes.length);
    } finally {
      this.#wasm.free(place);
    }
  }
}

const decoder = new TextDecoder();
const encoder = new TextEncoder();

// What the C library wants of a system (WASI): the time. Of files and the like there are none.
function imports(module: WebAssembly.Module, memory: () => ArrayBuffer, report: Report): WebAssembly.Imports {
  const [done, unsupported, realTime] = [0, 52, 0];
  const known: Record<string, (...parameters: never[]) => unknown> = {
    progress: report,
    clock_time_get(clock: number, _precision: bigint, at: Place): number {
      const milliseconds = clock === realTime ? Date.now() : performance.now();
      new DataView(memory()).setBigUint64(at, BigInt(Math.round(milliseconds * 1e6)), true);
      return done;
    },
    proc_exit(status: number): never {
      throw new Error(`the planner ended with status ${status}`);
    },
  };
  const result: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (result[from] ??= {})[name] = known[name] ?? (() => unsupported);
  }
  return result;
}
