// The example and the README's code do what they say.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { it } from "node:test";
import { fileURLToPath } from "node:url";
import { project } from "./native.mjs";

const here = fileURLToPath(new URL("..", import.meta.url));

// In the package's own folder, "waybreaker" is the package.
const run = (script) =>
  execFileSync(process.execPath, ["--input-type=module", "--eval", script], { cwd: here, encoding: "utf8" });

for (const example of ["walls_fall", "frames"]) {
  it(`${example}.mjs prints what stands beside it`, () => {
    const script = readFileSync(join(project, `examples/${example}.mjs`), "utf8");
    assert.equal(run(script), readFileSync(join(project, `examples/${example}.mjs.txt`), "utf8"));
  });
}

for (const example of ["embed", "failed_breach"]) {
  it(`${example}.mjs prints what it does in C++`, () => {
    const script = readFileSync(join(project, `examples/${example}.mjs`), "utf8");
    assert.equal(run(script), readFileSync(join(project, `examples/${example}.txt`), "utf8"));
  });
}

it("the README's first mission breaks the wall", () => {
  const [, script] = /```js\n(import \{ createPlanner \}.*?)```/s.exec(readFileSync(join(here, "README.md"), "utf8"));
  assert.match(run(script), /^solved 1 \[ \[ 0, 1, 0 \], \[ 8, 1, 8 \] \]/);
});
