import { defineConfig } from "vitest/config";

// One file after the other: they share a processor with the server and the browser.
export default defineConfig({
  server: { host: "127.0.0.1" }, // a bare machine has no name `localhost`
  test: {
    include: ["e2e/*.test.ts"],
    globalSetup: "e2e/command.ts",
    fileParallelism: false,
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
