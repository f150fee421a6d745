/** What was passed in is wrong; the message says what, and what to do. */
export class InputError extends Error {
  override name = "InputError";
}

/** Free some maps; all else is as before. */
export class OutOfMemoryError extends Error {
  override name = "OutOfMemoryError";
}

/** A fault of the library: please report it. The planner can be used again; its maps may have to be made anew. */
export class InternalError extends Error {
  override name = "InternalError";
}

/** @internal By name, as they come from another thread. */
export function errorNamed(name: string, message: string): Error {
  for (const kind of [InputError, OutOfMemoryError, InternalError]) {
    if (kind.name === name) return new kind(message);
  }
  return new InternalError(`${name}: ${message}`);
}
