/** The compiled module, its bytes, or where they are; by default the file beside this one. */
export type WasmSource = WebAssembly.Module | BufferSource | URL | string;

export interface PlannerOptions {
  wasm?: WasmSource;
}

/** @internal */
export async function compile(
  source: WasmSource,
  read: (url: URL | string) => Promise<BufferSource | Response>,
): Promise<WebAssembly.Module> {
  if (source instanceof WebAssembly.Module) return source;
  if (typeof source !== "string" && !(source instanceof URL)) return WebAssembly.compile(source);
  const answer = await read(source);
  if (!(answer instanceof Response)) return WebAssembly.compile(answer);
  if (!answer.ok) throw new Error(`${answer.url}: ${answer.status} ${answer.statusText}`);
  // Browsers compile while it comes, if it comes under its own type.
  const typed = answer.headers.get("content-type")?.startsWith("application/wasm");
  return typed ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}
