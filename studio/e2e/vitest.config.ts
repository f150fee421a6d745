import { defineConfig } from "vitest/config";

// Two files at a time, each with a server and a browser of its own.
export default defineConfig({
  server: { host: "127.0.0.1" }, // a bare machine has no name `localhost`
  test: {
    include: ["e2e/*.test.ts"],
    globalSetup: "e2e/command.ts",
    maxWorkers: 2,
    // Of a machine that does other things, too.
    testTimeout: 240_000,
    hookTimeout: 240_000,
    expect: { poll: { timeout: 60_000 } },
  },
});
