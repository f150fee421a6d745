import service from "../vitest.config";

// The page without a server. The command needs its planner: built in, or WAYBREAKER_WASM names it.
export default { ...service, test: { ...service.test, include: ["e2e/site/*.test.ts"] } };
