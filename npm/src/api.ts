export type * from "./documents.js";
export type * from "./maps.js";
export type * from "./options.js";
export { InputError, InternalError, OutOfMemoryError } from "./errors.js";
export type { PlannerOptions, WasmSource } from "./load.js";
