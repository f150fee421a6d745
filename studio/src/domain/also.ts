// What a mission asks beside what the page has controls for, in the words of requests and files (docs/contract.md, sections 3
// and 6). It is planned with, and kept in links and files.
import { squareMetres } from "./units";

export type Method = "exact" | "paper";

export type Also = Readonly<Record<string, number | string>>;

// In the order that they are said in: a number, or one of some words.
const kinds: Readonly<Record<string, "number" | readonly string[]>> = {
  budget: "number",
  budget_m2: "number",
  minimise_demolition: "number",
  timing: ["enforce", "ignore"],
  select: ["exact", "hits", "greedy", "none"],
  flight: ["optimal", "nearest"],
  planner: ["theta", "lazy-theta", "astar", "jps", "dijkstra", "bfs", "optimal"],
  heuristic: ["euclidean", "octile", "chebyshev", "manhattan", "zero"],
  weight: "number",
  tie_break: ["g-max", "g-min"],
  moves: "number",
  corners: ["none", "cut", "squeeze"],
};

export const alsoNames = { rules: Object.keys(kinds).slice(0, 4), method: Object.keys(kinds).slice(4, -1) };

// How the command plans where nothing is said.
const usual: Also = { timing: "enforce", select: "exact", flight: "optimal", weight: 1, tie_break: "g-max", moves: 8, corners: "none" };

// What each method of the page stands for: see `waybreaker plan --paper`.
export function methodWords(method: Method, removals: number): Also {
  if (method === "exact") return { timing: "enforce", select: "exact" };
  return { timing: "ignore", select: "hits", planner: "theta", flight: removals === 1 ? "optimal" : "nearest" };
}

// Of what a file says that which the page's method does not stand for.
export function alsoOf(said: Readonly<Record<string, unknown>>, method: Method, removals: number): Also {
  const meant: Also = { ...usual, ...methodWords(method, removals) };
  const all: Record<string, unknown> = { ...usual, ...said };
  if (all.planner === "optimal") delete all.planner; // where another drives, the command takes that one by itself
  const names = Object.keys(kinds).filter((name) => all[name] !== undefined && all[name] !== null && all[name] !== meant[name]);
  return Object.fromEntries(names.map((name) => [name, all[name] as number | string]));
}

// As a link has it: budget_m2:300,moves:4.
export function alsoText(also: Also): string {
  return Object.entries(also).map(([name, value]) => `${name}:${value}`).join();
}

// Null where the text is none.
export function parseAlso(text: string): Also | null {
  const also: Record<string, number | string> = {};
  for (const part of text.split(",")) {
    const [name = "", value = ""] = part.split(":");
    const kind = Object.hasOwn(kinds, name) ? kinds[name]! : [];
    const isRight = kind === "number" ? value.trim() !== "" && Number(value) >= 0 : kind.includes(value);
    if (!isRight) return null;
    also[name] = kind === "number" ? Number(value) : value;
  }
  return also;
}

export function without(also: Also, name: string): Also {
  return Object.fromEntries(Object.entries(also).filter(([one]) => one !== name));
}

// “budget 300 m²”
export function alsoWords(name: string, value: number | string): string {
  if (name === "budget_m2") return `budget ${squareMetres(Number(value))}`;
  if (name === "minimise_demolition") return `the least demolition within ${Number((100 * Number(value)).toPrecision(3))}\u00a0%`;
  return `${name.replaceAll("_", " ")} ${value}`;
}
