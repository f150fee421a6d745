import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { ServiceError } from "../../src/api/client";
import { parseEvent } from "../../src/api/events";
import { HttpClient } from "../../src/api/http_client";
import { planOf } from "../domain/plans";
import { missionFrom } from "../planning/fake_service";

const asked: { url: string; init: RequestInit }[] = [];
let answers: (() => Response | Promise<Response>)[] = [];
const token = {
  value: "",
  asks: 0,
  current: () => token.value,
  ask: async () => (token.asks++, (token.value = "secret")),
};
const json =
  (value: unknown, status = 200, headers = {}) =>
  () =>
    new Response(JSON.stringify(value), { status, headers: { "Content-Type": "application/json", ...headers } });
const problem = (status: number, detail: string, headers = {}, type = "about:blank") =>
  json({ type, title: "T", status, detail }, status, {
    "Content-Type": "application/problem+json",
    ...headers,
  });
const stream =
  (...parts: string[]) =>
  () => {
    const bytes = parts.map((part) => new TextEncoder().encode(part));
    const body = new ReadableStream({
      pull: (to) => {
        const next = bytes.shift();
        if (next) to.enqueue(next);
        else to.close();
      },
    });
    return new Response(body, { headers: { "Content-Type": "text/event-stream" } });
  };
const trouble = async (asking: Promise<unknown>) => {
  const error = await asking.then(
    () => null,
    (reason: unknown) => reason,
  );
  expect(error).toBeInstanceOf(ServiceError);
  return error as ServiceError;
};
const request = { mission: missionFrom(0) };

beforeEach(() => {
  asked.length = 0;
  token.value = "";
  token.asks = 0;
  vi.stubGlobal("fetch", async (url: string, init: RequestInit) => {
    asked.push({ url, init });
    if (init.signal?.aborted) throw new DOMException("", "AbortError");
    return answers.shift()!();
  });
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

const client = new HttpClient(token);

it("joins the parts of a large map, and says when there are too many", async () => {
  const part = (ids: number[], next: number | null) =>
    json({ width: 9, height: 1, obstacles: ids.map((id) => ({ id })), runs: ids.flatMap((id) => [id, 1]), next });
  answers = [part([1, 2], 2), part([3], 3), part([], null)];
  const whole = await client.obstacles("m");
  expect(whole.obstacles.map((one) => one.id)).toEqual([1, 2, 3]);
  expect(whole.runs).toEqual([1, 1, 2, 1, 3, 1]);
  expect(asked.map((one) => one.url)).toEqual(["", "?after=2", "?after=3"].map((q) => `/api/v1/maps/m/obstacles${q}`));
  answers = [json({ obstacles: new Array<number>(500_001).fill(0), runs: [], next: 7 })];
  expect((await trouble(client.obstacles("m"))).message).toContain("more obstacles than a page can show (500,000)");
});

it("says in words what the service refuses", async () => {
  answers = [problem(422, "the start lies inside obstacle 1")];
  const error = await trouble(client.map("m.tif"));
  expect(asked[0]!.url).toBe("/api/v1/maps/m.tif");
  expect([error.trouble, error.message]).toEqual(["refused", "The start lies inside obstacle 1."]);
});

it("refuses a map with too many obstacles by its description, before they are fetched", async () => {
  answers = [json({ obstacles: { count: 500_000 } }), json({ obstacles: { count: 1_234_567 } })];
  await client.map("m");
  const error = await trouble(client.upload(new Blob(["map"])));
  expect([error.trouble, error.message]).toEqual([
    "refused",
    "The map has 1,234,567 obstacles, more than a page can show (500,000). “waybreaker plan” takes it.",
  ]);
  expect(asked).toHaveLength(2);
});

it("does not ask for what no map can be called", async () => {
  for (const id of ["../x", ".hidden", "a b", "", "a/b", "x".repeat(101), "m\u202e"]) {
    expect((await trouble(client.map(id))).trouble).toBe("missing");
    expect((await trouble(client.obstacles(id))).trouble).toBe("missing");
    expect((await trouble(client.background(id))).trouble).toBe("missing");
  }
  expect(asked).toEqual([]);
});

it("knows a map that is not there by the type of the problem, not by its status", async () => {
  answers = [
    problem(404, "no such map", {}, "/problems/map-not-found"),
    problem(404, "no such map", {}, "https://maps.example/problems/map-not-found"),
    stream('event: problem\ndata: {"type":"/problems/map-not-found","title":"T","status":404,"detail":"no"}\n\n'),
    problem(404, "no such path", {}, "/problems/path-not-found"),
    problem(404, "no such thing"),
    json({ title: "T", status: 404, detail: "no type" }, 404, { "Content-Type": "application/problem+json" }),
    () => new Response("", { status: 404 }),
  ];
  expect((await trouble(client.map("m"))).trouble).toBe("missing");
  expect((await trouble(client.map("m"))).trouble).toBe("missing");
  expect((await trouble(client.plan("m", request))).trouble).toBe("missing");
  while (answers.length > 0) expect((await trouble(client.map("m"))).trouble).toBe("refused");
});

it("knows a server that is gone", async () => {
  answers = [() => Promise.reject(new TypeError("fetch failed")), () => new Response("", { status: 502 })];
  expect((await trouble(client.map("m"))).trouble).toBe("gone");
  expect((await trouble(client.map("m"))).trouble).toBe("gone");
});

it("asks for a token and again with it", async () => {
  answers = [problem(401, "a token is needed"), json({ maps: [] })];
  expect(await client.maps()).toEqual([]);
  expect(token.asks).toBe(1);
  const sent = asked.map(({ init }) => (init.headers as Headers).get("Authorization"));
  expect(sent).toEqual([null, "Bearer secret"]);
});

it("waits as long as a busy server says, then asks again, but not for ever", async () => {
  vi.useFakeTimers();
  answers = [problem(503, "too many", { "Retry-After": "2" }), json({ maps: [] })];
  const maps = client.maps();
  await vi.advanceTimersByTimeAsync(1900);
  expect(asked).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(200);
  expect(await maps).toEqual([]);

  answers = Array.from({ length: 20 }, () => problem(503, "too many", { "Retry-After": "1" }));
  const refused = trouble(client.maps());
  await vi.advanceTimersByTimeAsync(60_000);
  expect((await refused).trouble).toBe("refused");
  expect(answers.length).toBeGreaterThan(10);
});

it("stops waiting when it is told to", async () => {
  vi.useFakeTimers();
  answers = [problem(503, "too many", { "Retry-After": "5" })];
  const control = new AbortController();
  const stopped = trouble(client.maps(control.signal));
  await vi.advanceTimersByTimeAsync(100);
  control.abort();
  expect((await stopped).trouble).toBe("stopped");
});

it("reads a plan from a stream, however it is cut", async () => {
  const text =
    'event: progress\ndata: {"state":"planning","seconds":0.7}\n\nevent: plan\ndata: {"status":\ndata: "solved"}\n\n';
  for (const cut of [1, 7, text.length]) {
    answers = [stream(...(text.match(new RegExp(`[^]{1,${cut}}`, "g")) ?? []))];
    const seen: number[] = [];
    const plan = await client.plan("m", request, undefined, ({ seconds }) => seen.push(seconds));
    expect(plan).toEqual({ status: "solved" });
    expect(seen).toEqual([0.7]);
  }
});

it("takes a problem at the end of a stream, or none, for what it is", async () => {
  answers = [
    stream('event: problem\ndata: {"type":"about:blank","title":"T","status":422,"detail":"no"}\n\n'),
    stream("event: progress\ndata: {}\n\n"),
  ];
  expect((await trouble(client.plan("m", request))).message).toBe("No.");
  expect((await trouble(client.plan("m", request))).trouble).toBe("gone");
});

it("puts the lines of an event together", () => {
  expect(parseEvent("event: plan\ndata: a\ndata: b\n: comment")).toEqual({ name: "plan", data: "a\nb" });
});

it("asks for a revision of a plan, and is answered with what came of it", async () => {
  const answer = { status: "no_plan", reason: "no_plan", halts: [], plan: null };
  answers = [json(answer), problem(422, "the plan was made for another map")];
  const wanted = { plan: planOf({}), state: { format: "waybreaker-state/1" as const, sequence: 1, now: 2, agents: [], failed: [], found: [] } };
  expect(await new HttpClient(token).revise("yard.map", wanted)).toEqual(answer);
  expect([asked[0]!.url, asked[0]!.init.method, JSON.parse(String(asked[0]!.init.body))]).toEqual(["/api/v1/maps/yard.map/revise", "POST", wanted]);
  expect((await trouble(new HttpClient(token).revise("yard.map", wanted))).message).toBe("The plan was made for another map.");
});
