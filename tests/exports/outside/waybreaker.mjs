import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const folder = mkdtempSync(join(tmpdir(), "waybreaker-"));
process.on("exit", () => rmSync(folder, { recursive: true }));

export const map = join(process.env.WAYBREAKER_DATA, "berlin-mitte.tif");

export const file = (name) => join(folder, name);
export const json = (name) => JSON.parse(readFileSync(file(name), "utf8"));

// Runs the command in the folder; what it prints.
export const waybreaker = (...words) =>
  execFileSync(process.env.WAYBREAKER_COMMAND, words, { cwd: folder, encoding: "utf8" });

// A mission in seconds across Berlin, as plan.json.
export const plan = (...options) =>
  waybreaker("plan", map, "--start", "256,434", "--goal", "118,55", "--ground-speed", "1.5m/s", "--air-speed", "8m/s",
    "--json", "plan.json", ...options);
