import type { Cell, Mission, Plan, Report, State } from "./documents.js";
import { InputError } from "./errors.js";
import { Library, type Pointer, textOf, utf8 } from "./library.js";
import type { Attributes, GridOptions, LabelOptions, MapEdit, MapOptions, Obstacle } from "./maps.js";
import type { Continuity, PlanOptions, ReviseOptions } from "./options.js";

interface Held {
  library: Library;
  pointer: Pointer;
}

const forgotten = new FinalizationRegistry<Held>(release);

function release({ library, pointer }: Held): void {
  if (library.failure === undefined) library.call("waybreaker_map_free", pointer);
}

/** A map, which never changes. Its memory is freed when it is garbage, or sooner by `free`. */
export class PlannerMap {
  readonly width: number;
  readonly height: number;
  /** Obstacles have the ids 1, 2, ..., in the order of their first cells, row by row; those that edits add come last. */
  readonly obstacleCount: number;
  /** "sha256:..." of what it was made from, as plans state it. */
  readonly digest: string;
  #held: Held | undefined;

  /** @internal */
  constructor(library: Library, pointer: Pointer) {
    this.#held = { library, pointer };
    this.width = library.call("waybreaker_map_width", pointer);
    this.height = library.call("waybreaker_map_height", pointer);
    this.obstacleCount = library.call("waybreaker_map_obstacle_count", pointer) >>> 0;
    this.digest = library.constantText(library.call("waybreaker_map_digest", pointer));
    forgotten.register(this, this.#held, this);
  }

  /** Row by row, the id of the obstacle at each cell, 0 where it is free: a copy. */
  labels(): Uint32Array {
    const { library, pointer } = this.held();
    const at = library.call("waybreaker_map_labels", pointer) >>> 0;
    return new Uint32Array(library.bytes(at, this.width * this.height * Uint32Array.BYTES_PER_ELEMENT).slice().buffer);
  }

  /** undefined where there is none of that id. */
  obstacle(id: number): Obstacle | undefined {
    const { library, pointer } = this.held();
    return library.with([new Uint8Array(obstacleBytes)], (at) =>
      library.call("waybreaker_map_obstacle", pointer, id, at) === 0 ? undefined : readObstacle(library.view(), at),
    );
  }

  /**
   * The map with its obstacles changed, one edit after the other; this one stays as it is. All other obstacles keep
   * their ids, and it costs a small part of a new map. An obstacle that is gone has no cells.
   */
  with(edits: readonly MapEdit[]): PlannerMap {
    const { library, pointer } = this.held();
    const listed = edits.map(listedEdit);
    const cells = Int32Array.from(listed.flatMap((edit) => edit.cells.flat()));
    const table = new Uint8Array(listed.length * editBytes);
    return library.with([cells, table], (cellsAt, tableAt) => {
      writeEdits(library.view(), tableAt!, listed, cellsAt!);
      return new PlannerMap(library, library.result("waybreaker_map_with", pointer, tableAt!, listed.length));
    });
  }

  /** Frees its memory; the map cannot be used afterwards. */
  free(): void {
    if (this.#held === undefined) return;
    forgotten.unregister(this);
    release(this.#held);
    this.#held = undefined;
  }

  /** @internal */
  held(): Held {
    if (this.#held === undefined) throw new InputError("the map has been freed");
    return this.#held;
  }
}

// The layout of waybreaker_attributes and waybreaker_obstacle.
const attributeBytes = 32;
const obstacleBytes = 24 + attributeBytes;

function writeAttributes(view: DataView, at: number, attributes: Attributes): void {
  view.setBigInt64(at, bigInteger(attributes.sourceId ?? 0), true);
  view.setFloat64(at + 8, attributes.weight ?? 1, true);
  view.setFloat64(at + 16, attributes.breachTime ?? 0, true);
  view.setUint8(at + 24, (attributes.destructible ?? true) ? 1 : 0);
}

function bigInteger(value: number | bigint): bigint {
  if (typeof value === "number" && !Number.isSafeInteger(value)) {
    throw new InputError(`the sourceId ${value} is no whole number that is exact: give a bigint`);
  }
  return BigInt(value);
}

// Of waybreaker_edit and waybreaker_cell.
const editBytes = 16 + attributeBytes;
const cellBytes = 8;

interface ListedEdit {
  kind: number; // waybreaker_edit_kind
  obstacle: number;
  cells: readonly Cell[];
  attributes: Attributes;
}

function listedEdit(edit: MapEdit): ListedEdit {
  const listed = { kind: 0, obstacle: 0, cells: [], attributes: {} };
  if ("remove" in edit) return { ...listed, obstacle: id(edit.remove) };
  if ("add" in edit) return { ...listed, kind: 1, cells: cellsOf(edit.add), attributes: edit.attributes ?? {} };
  if ("extend" in edit) return { ...listed, kind: 2, obstacle: id(edit.extend), cells: cellsOf(edit.cells) };
  if ("free" in edit) return { ...listed, kind: 3, cells: cellsOf(edit.free) };
  throw new InputError("an edit has remove, add, extend or free");
}

function id(obstacle: number): number {
  if (Number.isInteger(obstacle) && obstacle >= 0 && obstacle < 2 ** 32) return obstacle;
  throw new InputError(`${obstacle} is no id of an obstacle`);
}

function cellsOf(cells: readonly Cell[]): readonly Cell[] {
  const isWhole = (side: unknown): boolean => Number.isInteger(side) && Math.abs(side as number) < 2 ** 31;
  if (!Array.isArray(cells)) throw new InputError("the cells of an edit are a list of [x, y]");
  for (const cell of cells) {
    if (Array.isArray(cell) && cell.length === 2 && cell.every(isWhole)) continue;
    throw new InputError(`${JSON.stringify(cell)} is no cell [x, y]`);
  }
  return cells;
}

function writeEdits(view: DataView, at: Pointer, edits: readonly ListedEdit[], cellsAt: Pointer): void {
  for (const { kind, obstacle, cells, attributes } of edits) {
    view.setInt32(at, kind, true);
    view.setUint32(at + 4, obstacle, true);
    view.setUint32(at + 8, cellsAt, true);
    view.setUint32(at + 12, cells.length, true);
    writeAttributes(view, at + 16, attributes);
    cellsAt += cells.length * cellBytes;
    at += editBytes;
  }
}

function readObstacle(view: DataView, at: Pointer): Obstacle {
  const cell = (offset: number): Cell => [view.getInt32(at + offset, true), view.getInt32(at + offset + 4, true)];
  const source = view.getBigInt64(at + 24, true);
  const number = Number(source);
  return {
    id: view.getUint32(at, true),
    cells: view.getUint32(at + 4, true),
    min: cell(8),
    max: cell(16),
    sourceId: Number.isSafeInteger(number) ? number : source,
    weight: view.getFloat64(at + 32, true),
    breachTime: view.getFloat64(at + 40, true),
    destructible: view.getUint8(at + 48) !== 0,
  };
}

const usualSeconds = 10; // as the command has it

function text(document: unknown): Uint8Array {
  return utf8(textOf(document));
}

/** Wholly on the thread that calls. Documents that are passed in may be objects or JSON texts. */
export class Planner {
  readonly version: string;
  readonly #module: WebAssembly.Module;
  #library: Library;
  #planner: Pointer = 0;

  /** `createPlanner` makes one. */
  constructor(module: WebAssembly.Module) {
    this.#module = module;
    this.#library = new Library(module);
    this.version = this.#library.constantText(this.#library.call("waybreaker_version"));
  }

  /** From a MovingAI map file. Its plans equal those of the command for the file of that name. */
  mapFromMovingAI(file: string | Uint8Array, options: GridOptions = {}): PlannerMap {
    const library = this.#live();
    const bytes = utf8(file);
    return this.#map(library, options, [bytes], (name, at) =>
      library.result(
        "waybreaker_map_from_movingai",
        name,
        at!,
        bytes.length,
        options.connectivity ?? 4,
        options.cellSize ?? 0,
      ),
    );
  }

  /** From width * height bytes, row by row, 0 where a cell is free. */
  mapFromGrid(width: number, height: number, blocked: Uint8Array, options: GridOptions = {}): PlannerMap {
    requireCells(width, height, blocked.length, "bytes");
    const library = this.#live();
    return this.#map(library, options, [blocked], (name, at) =>
      library.result(
        "waybreaker_map_from_grid",
        name,
        at!,
        width,
        height,
        options.connectivity ?? 4,
        options.cellSize ?? 0,
      ),
    );
  }

  /** From width * height labels, row by row: 0 where a cell is free; cells of one number are one obstacle. */
  mapFromLabels(width: number, height: number, labels: Uint32Array, options: LabelOptions = {}): PlannerMap {
    requireCells(width, height, labels.length, "labels");
    const library = this.#live();
    const attributes = options.attributes ?? [];
    const table = new Uint8Array(attributes.length * attributeBytes);
    const view = new DataView(table.buffer);
    for (let label = 0; label < attributes.length; ++label) {
      writeAttributes(view, label * attributeBytes, attributes[label] ?? {});
    }
    return this.#map(library, options, [labels, table], (name, at, tableAt) =>
      library.result(
        "waybreaker_map_from_labels",
        name,
        at!,
        width,
        height,
        tableAt!,
        attributes.length,
        options.cellSize ?? 0,
      ),
    );
  }

  /** The plan, the same that the command `waybreaker plan` makes. No plan is no error: `status` says so. */
  plan(map: PlannerMap, mission: Mission | string, options?: PlanOptions): Plan {
    return JSON.parse(this.planText(map, mission, options)) as Plan;
  }
  /** The same as a text, which equals what the command writes to the byte (without `timing`, with `--no-timing`). */
  planText(map: PlannerMap, mission: Mission | string, options: PlanOptions = {}): string {
    return this.#planning("waybreaker_plan", map, mission, options);
  }

  /** What each removal gains: the plan of the most that are worth it; its `front` says what 0, 1, 2, ... reach. */
  front(map: PlannerMap, mission: Mission | string, options?: PlanOptions): Plan {
    return JSON.parse(this.frontText(map, mission, options)) as Plan;
  }
  frontText(map: PlannerMap, mission: Mission | string, options: PlanOptions = {}): string {
    return this.#planning("waybreaker_front", map, mission, options);
  }

  /**
   * The rest of a mission planned anew, from what has happened: the plan that takes over. The map is the one that the
   * mission began on. No plan is no error: `status` says so, and `revision` what has become of the plan before. A state
   * that the plan knows already gives it again.
   */
  revise(map: PlannerMap, plan: Plan | string, state: State | string, options?: ReviseOptions): Plan {
    return JSON.parse(this.reviseText(map, plan, state, options)) as Plan;
  }
  /** The same as a text, which equals what `waybreaker revise` writes to the byte, if `plan` is a text that equals its file. */
  reviseText(map: PlannerMap, plan: Plan | string, state: State | string, options: ReviseOptions = {}): string {
    const { library, planner, pointer } = this.#with(map);
    const { reaction = 0, seconds = usualSeconds, timing } = options;
    const [before, report] = [text(plan), text(state)];
    return library.with([before, report], (at, stateAt) =>
      library.textResult(
        "waybreaker_revise",
        planner,
        pointer,
        at!,
        before.length,
        stateAt!,
        report.length,
        reaction,
        seconds ?? Infinity,
        timing === true ? 1 : 0,
      ),
    );
  }

  /** Judges a plan from the map alone; with `after` and `state`, also whether it goes on from the plan before. */
  check(map: PlannerMap, plan: Plan | string, continuity: Partial<Continuity> = {}): Report {
    const { library, pointer } = map.held();
    const { after, state } = continuity;
    if ((after === undefined) !== (state === undefined)) throw new InputError("after and state belong together");
    const documents = (after === undefined ? [plan] : [plan, after, state]).map(text);
    const call = after === undefined ? "waybreaker_check" : "waybreaker_check_after";
    const answer = library.with(documents, (...at) =>
      library.textResult(call, pointer, ...documents.flatMap((bytes, i) => [at[i]!, bytes.length]), 0),
    );
    return JSON.parse(answer) as Report;
  }

  /** The picture of a plan. */
  svg(map: PlannerMap, plan: Plan | string): string {
    const { library, pointer } = map.held();
    const bytes = text(plan);
    return library.with([bytes], (at) => library.textResult("waybreaker_plan_svg", pointer, at!, bytes.length));
  }

  /** How much memory the planner and its maps have taken. It does not shrink; what is freed is used again. */
  get memoryBytes(): number {
    return this.#library.memoryBytes;
  }

  #planning(call: string, map: PlannerMap, mission: Mission | string, options: PlanOptions): string {
    const { library, planner, pointer } = this.#with(map);
    const bytes = text(mission);
    return library.with([bytes], (at) =>
      library.textResult(call, planner, pointer, at!, bytes.length, options.timing === true ? 1 : 0),
    );
  }

  // What plans on a map.
  #with(map: PlannerMap): Held & { planner: Pointer } {
    this.#live();
    const { library, pointer } = map.held();
    if (library === this.#library) return { library, pointer, planner: this.#kept() };
    throw new InputError("the map is another planner's, or from before it failed: make it again");
  }

  #map(
    library: Library,
    options: MapOptions,
    arrays: ArrayBufferView[],
    make: (name: Pointer, ...at: Pointer[]) => Pointer,
  ): PlannerMap {
    const name = utf8(`${options.name ?? "map"}\0`);
    return new PlannerMap(library, library.with([name, ...arrays], make));
  }

  // A failed instance makes way for a new one.
  #live(): Library {
    if (this.#library.failure !== undefined) {
      this.#library = new Library(this.#module);
      this.#planner = 0;
    }
    return this.#library;
  }

  #kept(): Pointer {
    if (this.#planner === 0) this.#planner = this.#library.call("waybreaker_planner_new");
    return this.#planner;
  }
}

// A check of what the C interface cannot see.
function requireCells(width: number, height: number, count: number, what: string): void {
  for (const side of [width, height]) {
    if (!Number.isInteger(side)) throw new InputError(`the side of a map, ${side}, is no whole number`);
  }
  if (width * height !== count) {
    throw new InputError(`a map of ${width} x ${height} cells has ${width * height} ${what}, not ${count}`);
  }
}
