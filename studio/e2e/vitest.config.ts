import { defineConfig } from "vitest/config";

// One file after the other: they share a processor with the server and the browser.
export default defineConfig({
  test: {
    include: ["e2e/*.test.ts"],
    globalSetup: "e2e/command.ts",
    fileParallelism: false,
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
