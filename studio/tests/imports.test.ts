// The README's table says which folder may use which; that is the rule, and it stands nowhere else.
import { dirname, join } from "node:path/posix";
import { describe, expect, it } from "vitest";
import readme from "../README.md?raw";

type Rules = ReadonlyMap<string, ReadonlySet<string>>; // by folder: all that it may use, itself included
type Imports = ReadonlyMap<string, readonly string[]>; // by file, without its ending

// Rows stand below those they use, so what a used folder may use in turn is known.
function rulesIn(page: string): Rules {
  const rules = new Map<string, Set<string>>();
  for (const [, folder, used] of page.matchAll(/^\| `src\/([\w/]+)(?:\.tsx)?` \|[^|]*\|([^|]*)\|$/gm)) {
    const may = new Set([folder!]);
    for (const name of used!.split(" ").filter(Boolean)) {
      if (!rules.has(name)) throw new Error(`${folder} uses ${name}, which has no row above it`);
      for (const one of rules.get(name)!) may.add(one);
    }
    rules.set(folder!, may);
  }
  return rules;
}

function importsIn(sources: Record<string, string>): Imports {
  const entries = Object.entries(sources).map(([path, text]): [string, string[]] => {
    const named = [...text.matchAll(/\b(?:from|import)\s*\(?\s*"(\.[^"]+)"/g)].map(([, name]) => name!);
    const files = named.filter((name) => !name.endsWith(".css")).map((name) => join(dirname(path), name));
    return [path.replace(/\.tsx?$/, ""), files];
  });
  return new Map(entries);
}

// The folder of a file; of one that lies in none, the file itself.
function folderOf(file: string): string {
  return file.includes("/") ? dirname(file) : file;
}

function forbidden(imports: Imports, rules: Rules): string[] {
  return [...imports].flatMap(([file, used]) => {
    const may = rules.get(folderOf(file));
    if (!may) return [`${file} is in a folder that has no row`];
    return used.filter((other) => !may.has(folderOf(other))).map((other) => `${file} uses ${other}`);
  });
}

function circle(imports: Imports): string[] | null {
  const seen = new Set<string>();
  const walk = (file: string, way: readonly string[]): string[] | null => {
    if (way.includes(file)) return [...way.slice(way.indexOf(file)), file];
    if (seen.has(file)) return null;
    seen.add(file);
    return first(imports.get(file) ?? [], (other) => walk(other, [...way, file]));
  };
  return first([...imports.keys()], (file) => walk(file, []));
}

function first<T, R>(all: readonly T[], find: (one: T) => R | null): R | null {
  for (const one of all) {
    const found = find(one);
    if (found !== null) return found;
  }
  return null;
}

const files = import.meta.glob<string>("../src/**/*.{ts,tsx}", { query: "?raw", import: "default", eager: true });
const page = importsIn(
  Object.fromEntries(Object.entries(files).map(([path, text]) => [path.replace("../src/", ""), text])),
);

describe("the page", () => {
  it("has folders that use only what they may", () => {
    expect(forbidden(page, rulesIn(readme))).toEqual([]);
  });

  it("has no circle of imports", () => {
    expect(page.get("main")).toContain("panel/app");
    expect(circle(page)).toBeNull();
  });
});

describe("these checks", () => {
  const rules = rulesIn(`
| \`src/low\` | | |
| \`src/low/deep\` | | low |
| \`src/high\` | | low/deep |
| \`src/main.tsx\` | | high |
`);

  it("let a folder use what is below it, down to the bottom", () => {
    const a = 'import "../low/b";\nimport { c } from "../low/deep/c";';
    const sources = { "high/a.ts": a, "main.tsx": 'import "./high/a";' };
    expect(forbidden(importsIn(sources), rules)).toEqual([]);
  });

  it("find what is not allowed, however it is imported", () => {
    const statements = [
      'import { a } from "../high/a";',
      'import type { A } from "../high/a";',
      'export * from "../high/a";',
      'import "../high/a";',
      'const a = import("../high/a");',
      'import {\n  a,\n} from "../high/a";',
    ];
    for (const statement of statements) {
      expect(forbidden(importsIn({ "low/b.ts": statement }), rules), statement).toEqual(["low/b uses high/a"]);
    }
    expect(forbidden(importsIn({ "utils/a.ts": "" }), rules)).toHaveLength(1);
    expect(() => rulesIn("| `src/low` | | high |\n| `src/high` | | |")).toThrow("no row above");
  });

  it("find circles, of types too", () => {
    const a = 'import type { B } from "./b";';
    const sources = { "a.ts": a, "b.ts": 'import { c } from "./c";', "c.ts": 'import "./b";' };
    expect(circle(importsIn(sources))).toEqual(["b", "c", "b"]);
    expect(circle(importsIn({ ...sources, "c.ts": "" }))).toBeNull();
  });
});
