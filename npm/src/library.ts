// One instance of the WebAssembly module: its memory, and calls of the C interface (include/waybreaker.h).
import { InputError, InternalError, OutOfMemoryError } from "./errors.js";

/** An address in the instance's memory. */
export type Pointer = number;

type Exports = Record<string, (...parameters: (number | bigint)[]) => number>;

const ok = 0;
const errors = [undefined, InputError, OutOfMemoryError, InternalError]; // by waybreaker_status

// Where calls leave their results, each four bytes.
const resultSlot = 0;
const errorSlot = 4;
const slotBytes = 8;

export class Library {
  /** Why nothing can be called any more. */
  failure: unknown = undefined;

  readonly #exports: Exports;
  readonly #memory: WebAssembly.Memory;
  readonly #slots: Pointer;

  constructor(module: WebAssembly.Module) {
    let memory: WebAssembly.Memory | undefined;
    const instance = new WebAssembly.Instance(module, system(module, () => memory!.buffer));
    memory = instance.exports["memory"] as WebAssembly.Memory;
    this.#memory = memory;
    this.#exports = instance.exports as unknown as Exports;
    this.call("_initialize");
    this.#slots = this.allocate(slotBytes);
  }

  /** What traps in the module leaves its memory as it happens to be: the instance is not used again. */
  call(name: string, ...parameters: (number | bigint)[]): number {
    if (this.failure !== undefined) throw lost(this.failure);
    try {
      return this.#exports[name]!(...parameters);
    } catch (failure) {
      this.failure = failure;
      throw lost(failure);
    }
  }

  /** A call that returns a status; its last two parameters, where result and error go, are added here. */
  result(name: string, ...parameters: (number | bigint)[]): Pointer {
    const status = this.call(name, ...parameters, this.#slots + resultSlot, this.#slots + errorSlot);
    const view = this.view();
    if (status === ok) return view.getUint32(this.#slots + resultSlot, true);
    const message = this.takeText(view.getUint32(this.#slots + errorSlot, true));
    throw new (errors[status] ?? InternalError)(message || "memory has run out");
  }

  textResult(name: string, ...parameters: (number | bigint)[]): string {
    return this.takeText(this.result(name, ...parameters));
  }

  takeText(text: Pointer): string {
    const at = this.call("waybreaker_text_data", text);
    const result = decoder.decode(this.bytes(at >>> 0, this.call("waybreaker_text_size", text) >>> 0));
    this.call("waybreaker_text_free", text);
    return result;
  }

  /** A text that lives as long as what it is about. */
  constantText(at: Pointer): string {
    const rest = new Uint8Array(this.#memory.buffer, at >>> 0);
    return decoder.decode(rest.subarray(0, rest.indexOf(0)));
  }

  /** Calls `use` with the address of each of these arrays in the instance's memory, where they are for that long. */
  with<T>(arrays: readonly ArrayBufferView[], use: (...at: Pointer[]) => T): T {
    const held: Pointer[] = [];
    try {
      for (const array of arrays) {
        const at = this.allocate(Math.max(array.byteLength, 1));
        held.push(at);
        this.bytes(at, array.byteLength).set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
      }
      return use(...held);
    } finally {
      if (this.failure === undefined) for (const at of held) this.call("free", at);
    }
  }

  allocate(bytes: number): Pointer {
    const at = this.call("malloc", bytes) >>> 0;
    if (at === 0) throw new OutOfMemoryError(`memory has run out: ${bytes} bytes were asked for`);
    return at;
  }

  /** Views are for use at once: a call may give the memory another buffer. */
  view(): DataView {
    return new DataView(this.#memory.buffer);
  }
  bytes(at: Pointer, count: number): Uint8Array {
    return new Uint8Array(this.#memory.buffer, at, count);
  }
  /** How much memory the instance has taken. It does not shrink; what is freed is used again. */
  get memoryBytes(): number {
    return this.#memory.buffer.byteLength;
  }
}

const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** Of a document, which may be its text. */
export function textOf(document: unknown): string {
  return typeof document === "string" ? document : `${JSON.stringify(document)}`;
}

export function utf8(text: string | Uint8Array): Uint8Array {
  return typeof text === "string" ? encoder.encode(text) : text;
}

function lost(failure: unknown): InternalError {
  const error = new InternalError(`the planner failed and starts anew; make its maps again (${failure})`);
  error.cause = failure;
  return error;
}

// What the C library imports of a system (WASI): clocks. All else, such as files, is not supported, and says so.
function system(module: WebAssembly.Module, buffer: () => ArrayBuffer): WebAssembly.Imports {
  const done = 0;
  const unsupported = 52; // ENOSYS
  const realTime = 0;
  const functions: Record<string, (...parameters: never[]) => number> = {
    clock_time_get(clock: number, _precision: bigint, at: Pointer): number {
      const milliseconds = clock === realTime ? Date.now() : performance.now();
      new DataView(buffer()).setBigUint64(at >>> 0, BigInt(Math.round(milliseconds * 1e6)), true);
      return done;
    },
    proc_exit(status: number): never {
      throw new Error(`the module ended with status ${status}`);
    },
  };
  const imports: WebAssembly.Imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = functions[name] ?? (() => unsupported);
  }
  return imports;
}
