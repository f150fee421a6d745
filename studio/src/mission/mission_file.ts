// A mission as a file: what a link says, a line each.
import { holdsMission } from "./address";

const format = "waybreaker-mission/1";

export function missionFile(query: string): string {
  return `${JSON.stringify({ format, ...Object.fromEntries(new URLSearchParams(query)) }, null, 2)}\n`;
}

// The query of what JSON.parse gave; null if that is no such file.
export function queryOfFile(value: unknown): string | null {
  if (!isObject(value) || value.format !== format) return null;
  const said = Object.entries(value).filter(
    ([name, one]) => name !== "format" && ["string", "number"].includes(typeof one),
  );
  const query = new URLSearchParams(said.map(([name, one]) => [name, String(one)])).toString();
  return holdsMission(query) ? query : null;
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
