import { readFile } from "node:fs/promises";

export async function read(file: URL | string): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await readFile(file));
}
