export type * from "./documents.js";
export { InputError, InternalError, OutOfMemoryError } from "./errors.js";
export type { PlannerOptions, WasmSource } from "./load.js";
