import { defineConfig } from "vitest/config";

// Files with fixed names, which CMake builds into the command. `npm run dev` asks a running `waybreaker serve`, as
// though the page came from there: other sites' pages are refused. Addresses, for a bare machine has no name `localhost`.
const service = { target: "http://127.0.0.1:8080", changeOrigin: false };

export default defineConfig({
  base: "./", // a site may lie in any folder
  esbuild: { jsx: "automatic", jsxImportSource: "preact" },
  build: {
    target: "es2022",
    modulePreload: false,
    assetsInlineLimit: Number.POSITIVE_INFINITY,
    rollupOptions: {
      output: { entryFileNames: "studio.js", assetFileNames: "studio.[ext]", inlineDynamicImports: true },
    },
  },
  worker: {
    format: "es",
    rollupOptions: { output: { entryFileNames: "worker.js", inlineDynamicImports: true } },
  },
  server: { host: "127.0.0.1", proxy: { "/api": service } },
  test: {
    include: ["tests/**/*.test.ts", "tests/**/*.test.tsx"],
    setupFiles: "tests/browser_globals.ts",
    testTimeout: 60_000, // ms: on a busy machine no test is to fail
  },
});
