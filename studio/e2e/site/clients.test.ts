// Both clients answer the same: the service over HTTP, and the planner in the page on the files of a site.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import type { Client, ServiceError } from "../../src/api/client";
import type { MissionDocument, PlanRequest, RevisionRequest } from "../../src/api/documents";
import { HttpClient } from "../../src/api/http_client";
import { LocalClient } from "../../src/api/local_client";
import type { Port } from "../../src/api/planner_workers";
import type { FromWorker, ToWorker } from "../../src/worker/messages";
import { Planner, Refused } from "../../src/worker/planner";
import { command, data } from "../command";
import { Server } from "../server";
import { siteIn } from "./site";

const scratch = mkdtempSync(join(tmpdir(), "clients-"));
const city = "berlin-mitte.tif";
const mission: MissionDocument = {
  format: "waybreaker-mission/1",
  agents: [
    { id: "ground", kind: "ground", start: [485, 101], goal: [425, 488] },
    { id: "air", kind: "air", start: [485, 101], goal: [425, 488] },
  ],
  rules: { separation: 0, at_goal: "stay" },
} as MissionDocument;
const request = { mission, options: { removals: 2 }, no_timing: true } as PlanRequest;

// The planner without a Worker around it.
class Here implements Port {
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null = null;
  onerror = null;
  #planner: Planner | null = null;

  postMessage(message: ToWorker): void {
    if (message instanceof WebAssembly.Module) {
      this.#planner = new Planner(message, () => undefined);
      return;
    }
    let answer: FromWorker;
    try {
      answer = { kind: "answer", text: this.#planner!.run(message) };
    } catch (error) {
      answer = { kind: error instanceof Refused ? "refused" : "failed", reason: (error as Error).message };
    }
    setTimeout(() => this.onmessage?.({ data: answer } as MessageEvent<FromWorker>));
  }
  terminate(): void {
    this.#planner = null;
  }
}

let site: string;
let server: Server;
let wasm: WebAssembly.Module;
const clients: { http: Client; local: Client } = {} as never;

beforeAll(async () => {
  site = siteIn(scratch);
  server = await Server.start();
  wasm = await WebAssembly.compile(readFileSync(join(site, "studio.wasm")));
  clients.http = new HttpClient({ current: () => "", ask: async () => "" }, `${server.url}/api/v1`);
  const fetched = async (path: string) => new Response(readFileSync(join(site, path)));
  clients.local = new LocalClient(() => new Here(), Promise.resolve(wasm), { fetched, hasFiles: true });
});
afterAll(async () => {
  await server.stop();
  rmSync(scratch, { recursive: true });
});

async function both<T>(ask: (client: Client) => Promise<T>): Promise<[http: T, local: T]> {
  return [await ask(clients.http), await ask(clients.local)];
}

describe("the planner in the page", () => {
  it("answers a mission file with the bytes of the command", () => {
    const file = join(scratch, "mission.json");
    writeFileSync(file, JSON.stringify({ ...mission, rules: { ...mission.rules, removals: 2 } }));
    const commands = execFileSync(command, ["plan", join(data, city), "--mission", file, "--no-timing", "--json", "-"], {
      encoding: "utf8",
    });
    const planner = new Planner(wasm, () => undefined);
    planner.run({ what: "open", map: city, document: readFileSync(join(site, `maps/${city}.json`), "utf8") });
    const asked = { mission: JSON.parse(readFileSync(file, "utf8")) as unknown, no_timing: true };
    const plan = planner.run({ what: "plan", map: city, request: JSON.stringify(asked) });
    expect(plan).toBe(commands);
  });
});

describe("both clients", () => {
  it("know the same maps", async () => {
    const [http, local] = await both((client) => client.maps());
    expect(local.map(({ id }) => id)).toEqual(http.map(({ id }) => id));
    expect(local.length).toBeGreaterThan(5);
  });

  it("describe a map alike", async () => {
    for (const id of [city, "turin.tif", "krems-flooded.tif"]) {
      for (const part of ["map", "obstacles", "background"] as const) {
        const [http, local] = await both((client): Promise<unknown> => client[part](id));
        expect(local, `${part} of ${id}`).toEqual(http);
      }
    }
  });

  it("plan alike", async () => {
    const requests: PlanRequest["options"][] = [
      { removals: 2 },
      { removals: 0 },
      { removals: 3, paper: true },
      { removals: 2, explain: true },
      { removals: 2, protect: ["building=church"] },
      { removals: 1, breach_time: 20, objective: "flowtime" },
    ];
    for (const options of requests) {
      const [http, local] = await both((client) => client.plan(city, { ...request, options: options! }));
      expect(local, JSON.stringify(options)).toEqual(http);
    }
  });

  it("revise a plan alike, and refuse what cannot be", async () => {
    const plan = await clients.http.plan(city, request);
    const [first] = plan.removed;
    const state = { format: "waybreaker-state/1", sequence: 1, now: first!.cleared_at } as const;
    const failed = [{ obstacle: first!.obstacle, at: first!.cleared_at }];
    const asked = (more: object) => ({ plan, state: { ...state, ...more }, no_timing: true }) as unknown as RevisionRequest;
    const [http, local] = await both((client) => client.revise(city, asked({ failed })));
    expect(http.status).toBe("revised");
    expect(local).toEqual(http);
    const wrong = asked({ agents: [{ id: "nobody", passed: 0 }] });
    const refusals = await both((client) => client.revise(city, wrong).catch((error: ServiceError) => error.message));
    expect(refusals[0]).toContain("nobody");
    expect(refusals[1]).toBe(refusals[0]);
  });

  it("check a plan alike, a good one and a bad one", async () => {
    const plan = await clients.local.plan(city, request);
    const wrong = { ...plan, orders: [], agents: plan.agents.map((agent) => ({ ...agent, path: agent.path.slice(0, 1) })) };
    for (const one of [plan, wrong]) {
      const [http, local] = await both((client) => client.check(city, one));
      expect(local).toEqual(http);
      expect(local.valid).toBe(one === plan);
    }
  });

  it("draw on a map alike", async () => {
    const edits = { block: [[480, 95, 12] as [number, number, number]], free: [[120, 200, 60] as [number, number, number]] };
    const [http, local] = await both((client) => client.edit(city, edits));
    const known = ({ id, digest, source, format, ...rest }: typeof http) => rest;
    expect(known(local)).toEqual(known(http));
    expect(local.id).toMatch(/^upload-[0-9a-f]{16}$/);
    expect(await clients.local.obstacles(local.id)).toEqual(await clients.http.obstacles(http.id));
    const there = await clients.http.plan(http.id, request);
    const here = await clients.local.plan(local.id, request);
    expect({ ...here, map: null }).toEqual({ ...there, map: null });
  });

  it("take a map of MovingAI's format alike", async () => {
    const rows = ["..@..", "..@..", "..@..", "....."];
    const yard = new Blob([`type octile\nheight 4\nwidth 5\nmap\n${rows.join("\n")}\n`]);
    const [http, local] = await both((client) => client.upload(yard));
    expect(local).toEqual(http);
    expect(await clients.local.obstacles(local.id)).toEqual(await clients.http.obstacles(http.id));
  });

  it("export a plan alike, positions to a cell", async () => {
    const plan = await clients.local.plan(city, request);
    const texts = async (format: "csv" | "geojson" | "svg" | "json") =>
      Promise.all((await both((client) => client.exported(city, plan, format))).map((blob) => blob.text()));
    const [httpJson, localJson] = await texts("json");
    expect(localJson).toBe(httpJson);
    for (const format of ["csv", "geojson"] as const) {
      const [http, local] = await texts(format);
      const numbers = (text: string) => [...text.matchAll(/-?\d+\.\d+/g)].map(([number]) => Number(number));
      expect(local!.replaceAll(/-?\d+(\.\d+)?/g, "#")).toBe(http!.replaceAll(/-?\d+(\.\d+)?/g, "#"));
      const [theirs, ours] = [numbers(http!), numbers(local!)];
      expect(ours.length).toBe(theirs.length);
      ours.forEach((number, i) => expect(Math.abs(number - theirs[i]!)).toBeLessThan(1e-5)); // degrees: a metre
    }
    const [, svg] = await texts("svg");
    expect(svg).toMatch(/^<svg[^]*<\/svg>\s*$/);
  });

  it("refuse alike", async () => {
    const inside = { ...request, mission: { ...mission, agents: mission.agents.map((one) => ({ ...one, goal: [511, 511] })) } };
    const refusals = [
      (client: Client) => client.map("nowhere.tif"),
      (client: Client) => client.plan(city, { ...request, options: { removals: 2, protect: ["building=castle"] } }),
      (client: Client) => client.plan(city, inside as PlanRequest),
      (client: Client) => client.edit(city, { block: [[9999, 0, 1]], free: [] }),
    ];
    for (const ask of refusals) {
      const [http, local] = await both((client) => ask(client).then(() => null, (error: ServiceError) => error));
      expect(local?.trouble).toBe(http?.trouble);
      if (http?.trouble !== "missing") expect(local?.message).toBe(http?.message);
    }
  });
});
