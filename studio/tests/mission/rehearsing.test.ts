// A rehearsal in the studio: it is of the mission as it is, and of the map that is planned on.
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Client } from "../../src/api/client";
import type { RevisionAnswer, RevisionRequest } from "../../src/api/documents";
import type { Plan } from "../../src/domain/plan";
import { saveAs } from "../../src/mission/save_as";
import { sceneOf } from "../../src/mission/scene_of";
import { Studio } from "../../src/mission/studio";
import { downloadPlan } from "../../src/mission/taken";
import { planOf } from "../domain/plans";
import { FakeClient } from "./fake_client";

vi.mock("../../src/mission/save_as", () => ({ saveAs: vi.fn() }));

class RevisingClient extends FakeClient {
  readonly taken: { plan: Plan; format: string }[] = [];
  readonly revised: { map: string; request: RevisionRequest }[] = [];

  revise = async (map: string, request: RevisionRequest): Promise<RevisionAnswer> => {
    this.revised.push({ map, request });
    const revision = { number: this.revised.length, sequence: this.revised.length, now: 10, decided: [] };
    return { status: "revised", halts: [], plan: { ...planOf({ after: 120 }), revision } };
  };
  exported = async (_map: string, plan: Plan, format: string) => {
    this.taken.push({ plan, format });
    return new Blob([format]);
  };
}

const fails = { kind: "failed", obstacle: 1, at: 10 } as const;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
let client: RevisingClient;
let studio: Studio;

async function started(made: RevisingClient): Promise<Studio> {
  client = made;
  studio = new Studio(client as unknown as Client);
  await studio.maps.start("");
  await settle(5000);
  return studio;
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

it("plays and shows the story in place of the plan", async () => {
  await started(new RevisingClient());
  expect(studio.page.played.value).toBe(studio.page.results.plans.value.after!.plan);
  await studio.rehearsal.happens(fails);
  expect(client.revised[0]!.map).toBe("city.map");
  expect(studio.page.played.value!.after.makespan).toBe(120);
  const scene = sceneOf(studio.page, studio)!;
  expect(scene.layers.map(({ name, plan }) => [name, plan.after.makespan])).toEqual([["after", 120]]);
  expect(scene.rehearsed!.failed).toEqual([{ obstacle: 1, at: [0, 0] }]);
});

it("gives the plan that holds to take along, until it is taken back", async () => {
  await started(new RevisingClient());
  const plan = studio.page.results.plans.value.after!.plan;
  await downloadPlan(studio, "json");
  await studio.rehearsal.happens(fails);
  const revised = studio.rehearsal.held.value!;
  await downloadPlan(studio, "json");
  await downloadPlan(studio, "html");
  studio.undo();
  await downloadPlan(studio, "svg");
  expect(client.taken).toEqual([
    { plan, format: "json" },
    { plan: revised, format: "json" },
    { plan: revised, format: "html" },
    { plan, format: "svg" },
  ]);
  expect(vi.mocked(saveAs).mock.calls.map(([, name]) => name)).toEqual(["plan.json", "revision-1.json", "revision-1.html", "plan.svg"]);
});

it("has nothing to take along where no plan is left", async () => {
  const lost = new RevisingClient();
  lost.revise = async () => ({ status: "no_plan", halts: [], plan: null });
  await started(lost);
  await studio.rehearsal.happens(fails);
  await downloadPlan(studio, "json");
  expect([studio.held.value, client.taken]).toEqual([null, []]);
});

it("is taken back before the mission's changes are", async () => {
  await started(new RevisingClient());
  studio.editor.change((mission) => ({ ...mission, removals: 3 }));
  await settle(5000);
  await studio.rehearsal.happens(fails);
  studio.undo();
  expect([studio.rehearsal.steps.value.length, studio.page.mission.value!.removals]).toEqual([0, 3]);
  studio.undo();
  await settle();
  expect(studio.page.mission.value!.removals).toBe(2);
});

it("ends when the mission is another, not when it is shown otherwise", async () => {
  await started(new RevisingClient());
  await studio.rehearsal.happens(fails);
  studio.page.toggleLayer("before");
  expect(studio.rehearsal.steps.value).toHaveLength(1);
  studio.editor.change((mission) => ({ ...mission, removals: 1 }));
  await settle();
  expect([studio.rehearsal.steps.value.length, studio.page.rehearsed.value]).toEqual([0, null]);
});
