import { signal } from "@preact/signals";
import { beforeEach, describe, expect, it } from "vitest";
import { ServiceError } from "../../src/api/client";
import type { RevisionAnswer, RevisionRequest } from "../../src/api/documents";
import type { Plan } from "../../src/domain/plan";
import type { Rehearsed } from "../../src/domain/rehearsed";
import { unitsOf } from "../../src/domain/units";
import { Clock } from "../../src/play/clock";
import { failureOf, type News } from "../../src/rehearse/news";
import { isRehearsable, Rehearsal, whyNotRehearsed } from "../../src/rehearse/rehearsal";
import { stepWords, sumWords } from "../../src/rehearse/words";
import { roundTheWall, yard } from "./yard";

class Reviser {
  readonly asked: { map: string; request: RevisionRequest }[] = [];
  readonly answers: ((request: RevisionRequest) => Promise<RevisionAnswer>)[] = [];

  revise = (map: string, request: RevisionRequest): Promise<RevisionAnswer> => {
    this.asked.push({ map, request });
    const answer = this.answers.shift();
    if (answer) return answer(request);
    const { now, sequence } = request.state;
    const plan = roundTheWall(now, now + 24);
    return Promise.resolve({ status: "revised", halts: [], plan: { ...plan, revision: { ...plan.revision!, sequence } } });
  };
  check = () => Promise.resolve({ valid: true, violations: [] });
}

const fails: News = { kind: "failed", obstacle: 7, at: 10 };
const rubble = (at: number, x = 5): News => ({ kind: "rubble", runs: [[x, 0, 1]], at });
const units = unitsOf({ cell_size: 1, georeference: { crs: "", center: [0, 0], to_lon_lat: [] } });
const telling = { units, obstacle: () => "Town hall" };

let reviser: Reviser;
let clock: Clock;
let plan: ReturnType<typeof signal<Plan | null>>;
let shown: ReturnType<typeof signal<Rehearsed | null>>;
let rehearsal: Rehearsal;

beforeEach(() => {
  reviser = new Reviser();
  clock = new Clock({ request: () => 0, cancel: () => undefined });
  plan = signal<Plan | null>(yard());
  shown = signal<Rehearsed | null>(null);
  rehearsal = new Rehearsal(reviser, { plan, map: () => "yard", clock, shown } as ConstructorParameters<typeof Rehearsal>[1]);
  clock.load(24);
  clock.seek(6);
});

const words = () => rehearsal.steps.value.map((step) => stepWords(step, telling));

describe("a rehearsal", () => {
  it("revises the plan when news is known, and goes on from there", async () => {
    await rehearsal.happens(fails);
    expect(reviser.asked[0]!.map).toBe("yard");
    expect(reviser.asked[0]!.request.plan).toEqual(yard());
    expect([clock.time.value, clock.duration.value]).toEqual([10, 34]);
    expect(shown.value!.plan.agents[0]!.path.at(-1)).toEqual([12, 0, 34]);
    expect(shown.value!.before.agents[0]!.path.at(-1)).toEqual([12, 0, 18]);
    expect(shown.value!.committed.get("truck")).toBe(12);
    expect(shown.value!.failed).toEqual([{ obstacle: 7, at: [6, 2] }]);
    expect(words()).toEqual(["The breach of Town hall failed at 10\u00a0s: the mission ends 10\u00a0s later, at 34\u00a0s."]);
    expect(rehearsal.checked.value!.report.valid).toBe(true);
  });

  it("tells the weighted average of many places, and which are no longer reached", async () => {
    const sums = (of: Plan, flowtime: number): Plan => ({
      ...of,
      options: { ...of.options, objective: "flowtime" },
      after: { ...of.after, flowtime },
      mission: { agents: [{ id: "rover", weight: 3 }, { id: "truck", weight: 2 }, { id: "drone", weight: 0 }], rules: of.mission!.rules! },
    });
    plan.value = sums(yard(), 100);
    reviser.answers.push(() => {
      const next = sums(roundTheWall(10, 34), 150);
      const agents = next.agents.map((agent) => (agent.id === "truck" ? { ...agent, reached: false as const } : agent));
      return Promise.resolve({ status: "revised", halts: [], plan: { ...next, agents } });
    });
    await rehearsal.happens(fails);
    expect(words()[0]).toBe(
      "The breach of Town hall failed at 10\u00a0s: the weighted average arrival is 10\u00a0s later, at 30\u00a0s; truck is no longer reached.",
    );
    expect(shown.value!.plan.agents.map(({ reached }) => reached)).toEqual([undefined, false, undefined]);
    reviser.answers.push(() => Promise.resolve({ status: "revised", halts: [], plan: sums(roundTheWall(14, 34), 150) }));
    await rehearsal.happens(rubble(14));
    expect(words()[1]).toBe("Rubble fell on the street at 14\u00a0s: the weighted average arrival is at 30\u00a0s, no later than before.");
    expect(shown.value!.plan.agents.map(({ reached }) => reached)).toEqual([undefined, undefined, undefined]);
  });

  it("revises revisions, and takes each back", async () => {
    await rehearsal.happens(fails);
    clock.stop(); // the whole plan is shown
    expect(rehearsal.time).toBe(10);
    clock.seek(14);
    await rehearsal.happens(rubble(14));
    expect(reviser.asked[1]!.request.state.sequence).toBe(2);
    expect(reviser.asked[1]!.request.plan.revision!.now).toBe(10);
    expect(shown.value!.moments).toEqual([10, 14]);
    expect(shown.value!.rubble).toEqual([[5, 0, 1]]);
    expect(shown.value!.plan.agents[0]!.path.slice(0, 3)).toEqual([[0, 0, 0], [4, 0, 4], [4, 0, 10]]);
    expect(sumWords(rehearsal.steps.value, units)).toBe("In all 14\u00a0s later than planned.");
    rehearsal.undo();
    expect([rehearsal.steps.value.length, clock.time.value, clock.duration.value]).toEqual([1, 14, 34]);
    rehearsal.undo();
    expect([rehearsal.steps.value.length, clock.time.value, clock.duration.value]).toEqual([0, 6, 24]);
    expect(shown.value).toBeNull();
  });

  it("takes earlier news in place of what came later, and undo brings that back", async () => {
    await rehearsal.happens(fails);
    await rehearsal.happens(rubble(3));
    expect(rehearsal.steps.value.map(({ news }) => news.kind)).toEqual(["rubble"]);
    expect(reviser.asked[1]!.request.plan).toEqual(yard());
    rehearsal.undo();
    expect(rehearsal.steps.value.map(({ news }) => news.kind)).toEqual(["failed"]);
  });

  it("goes back to the plan", async () => {
    await rehearsal.happens(fails);
    await rehearsal.happens(rubble(14));
    rehearsal.reset();
    expect([rehearsal.steps.value.length, shown.value, clock.duration.value]).toEqual([0, null, 24]);
    rehearsal.undo();
    expect(rehearsal.steps.value).toHaveLength(0);
  });

  it("shows rubble where it is held, and keeps where it is dropped", async () => {
    let release = () => {};
    reviser.answers.push((request) => new Promise((resolve) => {
      release = () => resolve({ status: "revised", halts: [], plan: roundTheWall(request.state.now, 30) });
    }));
    const held = rehearsal.happens(rubble(6, 5), false);
    void rehearsal.happens(rubble(6, 6), false);
    void rehearsal.happens(rubble(6, 7), false);
    release();
    await held;
    expect(reviser.asked.map(({ request }) => request.state.found[0]!.cells[0]![0])).toEqual([5, 7]); // those between are dropped
    expect(rehearsal.steps.value).toHaveLength(1);
    rehearsal.abandon();
    expect(rehearsal.steps.value).toHaveLength(0);
    await rehearsal.happens(rubble(6, 8), false);
    await rehearsal.happens(rubble(6, 9), true);
    expect(shown.value!.rubble).toEqual([[9, 0, 1]]);
    rehearsal.undo();
    expect(rehearsal.steps.value).toHaveLength(0);
  });

  it("takes news that comes while another is worked on", async () => {
    const first = rehearsal.happens(fails);
    void rehearsal.happens(rubble(12));
    await first;
    expect(rehearsal.steps.value.map(({ news }) => news.kind)).toEqual(["failed", "rubble"]);
  });

  it("ends where no plan is left, and says why", async () => {
    const none = { plan: null, halts: [] };
    reviser.answers.push(() => Promise.resolve({ ...none, status: "no_plan", reason: "no_plan" }));
    await rehearsal.happens(rubble(3));
    expect(words()[0]).toBe("Rubble fell on the street at 3\u00a0s: no way is left.");
    expect(clock.duration.value).toBe(3);
    expect(rehearsal.held.value).toBeNull();
    rehearsal.undo();
    reviser.answers.push(() => Promise.resolve({ ...none, status: "broken", halts: [{ agent: "rover", point: 1, by: 4 }] }));
    await rehearsal.happens(rubble(3));
    expect(words()[0]).toBe("Rubble fell on the street at 3\u00a0s: rover has to stop by 4\u00a0s.");
  });

  it("stays as it is where the service refuses, and says so", async () => {
    reviser.answers.push(() => Promise.reject(new ServiceError("refused", "No.")));
    await rehearsal.happens(fails);
    expect([rehearsal.steps.value.length, rehearsal.failure.value, rehearsal.working.value]).toEqual([0, "No.", false]);
    await rehearsal.happens(fails);
    expect([rehearsal.steps.value.length, rehearsal.failure.value]).toEqual([1, null]);
  });

  it("says what stands still, is lost, and costs nothing", async () => {
    const kept = (request: RevisionRequest): Promise<RevisionAnswer> =>
      Promise.resolve({ status: "kept", halts: [], plan: { ...yard(), revision: roundTheWall(request.state.now, 24).revision! } });
    reviser.answers.push(kept, kept);
    await rehearsal.happens({ kind: "delayed", agent: "rover", by: 3, at: 5 });
    expect(words()[0]).toBe("Rover stood still for 3\u00a0s from 5\u00a0s on: the plan holds, and the mission ends at 24\u00a0s, no later than before.");
    expect(clock.time.value).toBe(8);
    await rehearsal.happens({ kind: "lost", agent: "drone", at: 12 });
    expect(words()[1]).toMatch(/^Drone was lost at 12.s: /);
    expect(shown.value!.lost).toEqual([{ agent: "drone", at: [8, 2], time: 12 }]);
  });
});

it("is of plans that can be revised", () => {
  expect(isRehearsable(yard())).toBe(true);
  expect(isRehearsable(null)).toBe(false);
  expect(isRehearsable({ ...yard(), status: "no_plan", agents: [] })).toBe(false);
  expect(isRehearsable({ ...yard(), options: { timing: "ignore" } })).toBe(false);
  expect(whyNotRehearsed(yard())).toBeNull();
  const limited = { ...yard(), mission: { agents: [{ id: "ground" }, { id: "air", endurance: 900 }] } };
  expect(isRehearsable(limited)).toBe(true);
  const passing = { ...yard(), mission: { agents: [], rules: { collisions: false } } };
  expect(whyNotRehearsed(passing)).toBeNull();
});

it("lets a breach fail that is still to be made", () => {
  expect(failureOf(yard(), 7, 4)).toEqual(fails);
  expect(failureOf(yard(), 7, 11)).toBeNull();
  expect(failureOf(yard(), 8, 4)).toBeNull();
});
