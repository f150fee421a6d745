import { defineConfig } from "vitest/config";

// One file after the other: they share a processor with the server and the browser.
export default defineConfig({
  server: { host: "127.0.0.1" }, // a bare machine has no name `localhost`
  test: {
    include: ["e2e/*.test.ts"],
    globalSetup: "e2e/command.ts",
    fileParallelism: false,
    testTimeout: 240_000, // of a machine that does other things, too
    hookTimeout: 240_000,
  },
});
