// Makes dist/ of src/ and of the WebAssembly module: node build.mjs [WASM]. scripts/build-npm makes both.
import { execFileSync } from "node:child_process";
import { copyFileSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { buildSync } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
process.chdir(here);
const wasm = process.argv[2] ?? "../build/wasm/src/wasm/waybreaker.wasm";

rmSync("dist", { recursive: true, force: true });
execFileSync(process.execPath, [join("node_modules", "typescript", "bin", "tsc")], { stdio: "inherit" });
writeFileSync(join("dist", "waybreaker.wasm"), readFileSync(wasm)); // without its mode
copyFileSync("../LICENSE", "LICENSE");

const common = { bundle: true, minify: true, target: "es2022", legalComments: "none" };
const worker = buildSync({ ...common, entryPoints: ["dist/worker_thread.js"], format: "iife", write: false });
buildSync({
  ...common,
  entryPoints: ["dist/inline.js"],
  outfile: "dist/inline.js",
  allowOverwrite: true,
  format: "esm",
  define: {
    WASM_BASE64: JSON.stringify(readFileSync(wasm).toString("base64")),
    WORKER_SCRIPT: JSON.stringify(worker.outputFiles[0].text),
  },
});
