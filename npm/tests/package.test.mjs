// What npm would publish, installed where nothing else is.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, symlinkSync } from "node:fs";
import { join } from "node:path";
import { after, before, it } from "node:test";
import { fileURLToPath } from "node:url";
import { Scratch } from "./native.mjs";

const here = fileURLToPath(new URL("..", import.meta.url));
const scratch = new Scratch();
after(() => scratch.remove());

const run = (program, ...parameters) => execFileSync(program, parameters, { cwd: scratch.folder, encoding: "utf8" });

let packed;
before(() => {
  [packed] = JSON.parse(
    execFileSync("npm", ["pack", "--json", "--pack-destination", scratch.folder], { cwd: here, encoding: "utf8" }),
  );
  scratch.file("package.json", JSON.stringify({ name: "game", type: "module" }));
  run("npm", "install", "--offline", "--no-audit", "--no-fund", join(scratch.folder, packed.filename));
});

it("holds what it needs, and nothing else", () => {
  const files = packed.files.map(({ path }) => path).sort();
  const scripts = files.filter((path) => /^dist\/[\w.]+\.js$/.test(path));
  assert.deepEqual(
    files.filter((path) => !scripts.includes(path) && !/^dist\/[\w.]+\.d\.ts$/.test(path)),
    ["LICENSE", "NOTICES.md", "README.md", "dist/waybreaker.wasm", "package.json"],
  );
  for (const name of ["index", "index.node", "worker", "worker.node", "inline"]) {
    assert.ok(scripts.includes(`dist/${name}.js`) && files.includes(`dist/${name}.d.ts`), name);
  }
  assert.deepEqual(Object.keys(JSON.parse(run("npm", "ls", "--json", "--all")).dependencies), ["waybreaker"]);
});

for (const [module, create] of [
  ["waybreaker", "createPlanner"],
  ["waybreaker/worker", "createWorkerPlanner"],
  ["waybreaker/inline", "createPlanner"],
]) {
  it(`${module} plans`, () => {
    const script = scratch.file(
      "plan.js",
      `import { ${create} } from ${JSON.stringify(module)};
       const wb = await ${create}();
       const map = await wb.mapFromMovingAI("type octile\\nheight 3\\nwidth 9\\nmap\\n....@....\\n....@....\\n....@....\\n");
       const agents = [{ id: "rover", kind: "ground", start: [0, 1], goal: [8, 1] },
                       { id: "drone", kind: "air", start: [0, 1], goal: [8, 1] }];
       const plan = await wb.plan(map, { format: "waybreaker-mission/1", agents });
       console.log(plan.status, plan.removed.length);`, // and ends, its worker too
    );
    assert.equal(run(process.execPath, script), "solved 1\n");
  });
}

it("has types for every way of finding modules", () => {
  mkdirSync(join(scratch.folder, "node_modules/@types"), { recursive: true });
  symlinkSync(join(here, "node_modules/@types/node"), join(scratch.folder, "node_modules/@types/node"));
  symlinkSync(join(here, "node_modules/undici-types"), join(scratch.folder, "node_modules/undici-types"));
  const file = scratch.file(
    "typed.ts",
    `import { createPlanner, type Mission, type Plan } from "waybreaker";
     import { createWorkerPlanner } from "waybreaker/worker";
     import { createPlanner as inline } from "waybreaker/inline";
     const wb = await createPlanner();
     const mission: Mission = { format: "waybreaker-mission/1", agents: [{ id: "a", kind: "air", start: [0, 0], goal: [1, 1] }] };
     const plan: Plan = wb.plan(wb.mapFromGrid(2, 1, new Uint8Array(2)), mission);
     const worker = await createWorkerPlanner();
     const map = await worker.mapFromGrid(2, 1, new Uint8Array(2), { connectivity: 8 });
     const other: Plan = await worker.plan(map, mission, { signal: AbortSignal.timeout(100) });
     // @ts-expect-error: a mission needs its format
     wb.plan(wb.mapFromGrid(2, 1, new Uint8Array(2)), { agents: [] });
     console.log(plan.removed[0]?.cleared_at, other.agents[0]?.path, inline);`,
  );
  const tsc = join(here, "node_modules/typescript/bin/tsc");
  for (const modules of ["NodeNext", "ESNext"]) {
    const resolution = modules === "ESNext" ? "Bundler" : "NodeNext";
    const options = ["--noEmit", "--strict", "--target", "ES2022", "--module", modules, "--moduleResolution", resolution];
    run(process.execPath, tsc, ...options, "--skipLibCheck", "false", "--lib", "ES2023,DOM", "--types", "node", file);
  }
});
