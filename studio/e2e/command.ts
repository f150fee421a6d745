// The command under test, and the data its server is given: WAYBREAKER_COMMAND and WAYBREAKER_DATA, as CTest sets them.
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(fileURLToPath(import.meta.url), "../../..");

export const command = process.env.WAYBREAKER_COMMAND ?? resolve(root, "build/release/apps/waybreaker");
export const data = process.env.WAYBREAKER_DATA ?? resolve(root, "data");
export const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";

export default function setup(): void {
  for (const [file, remedy] of [
    [command, "build it first, or set WAYBREAKER_COMMAND"],
    [chromium, "install Debian's chromium, or set CHROMIUM"],
  ] as const) {
    if (!existsSync(file)) throw new Error(`there is no ${file}: ${remedy}`);
  }
}
