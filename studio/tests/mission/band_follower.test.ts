// Bands of time are those of the plan that is shown, once it rests.
import { type Signal, signal } from "@preact/signals";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { ReachDocument } from "../../src/domain/bands";
import { freshMission } from "../../src/domain/mission";
import type { Plan } from "../../src/domain/plan";
import { BandFollower } from "../../src/mission/band_follower";
import { begin } from "../../src/mission/history";
import type { ShownMap } from "../../src/mission/maps";
import { PageState } from "../../src/mission/page_state";
import { sceneOf } from "../../src/mission/scene_of";
import type { Plans, Results } from "../../src/planning/results";
import { reach } from "../domain/reach_document";
import { mapOf } from "../domain/picture";
import { planOf } from "../domain/plans";

const ofPlaces = (removed: number[], collisions = false): Plan => ({ ...planOf({ removed }), mission: { agents: [], rules: { collisions } } });
const after = (plan: Plan, rough?: "draft" | "quick"): Plans => ({ after: { plan, verdict: null, ...(rough && { rough }) } });

let asked: number[][];
let answer: (stop: AbortSignal) => Promise<ReachDocument>;
let plans: Signal<Plans>;
let page: PageState;

beforeEach(() => {
  vi.useFakeTimers();
  [asked, plans] = [[], signal<Plans>({})];
  answer = async () => reach;
  const nothing = { front: signal(null), answered: signal(null), working: signal(false), progress: signal(null), failure: signal(null) };
  page = new PageState({ plans, ...nothing } as Results);
  page.history.value = begin(freshMission("m", { start: [0, 0], goal: [1, 0] }));
  const map = { description: { id: "m", cell_size: 1, georeference: null }, cells: mapOf(".....", "..a.."), background: { features: [] } };
  page.shown.value = { base: map, map, ids: { toShown: () => 0, toBase: () => 0 } } as unknown as ShownMap;
  new BandFollower(page, {
    reach: (_map, { removed }, stop) => {
      asked.push(removed.map(({ obstacle }) => obstacle));
      return answer(stop!);
    },
  });
});
afterEach(() => {
  vi.useRealTimers();
});

const settle = () => vi.advanceTimersByTimeAsync(1000);
const ends = () => sceneOf(page, null)?.bands?.ends;

it("come once the plan rests, not with drafts", async () => {
  plans.value = after(ofPlaces([1]), "draft");
  await settle();
  expect([asked, ends()]).toEqual([[], undefined]);
  plans.value = after(ofPlaces([1]), "quick");
  plans.value = after(ofPlaces([2]));
  await settle();
  expect([asked, ends()]).toEqual([[[2]], [100, 200]]);
});

it("are asked for once, though the same plan comes again", async () => {
  plans.value = after(ofPlaces([1]), "quick");
  await settle();
  plans.value = after(ofPlaces([1]));
  await settle();
  expect([asked, page.bandsAreOld.value]).toEqual([[[1]], false]);
});

it("stay, marked as old, until those of the next plan are there", async () => {
  plans.value = after(ofPlaces([1]));
  await settle();
  plans.value = after(ofPlaces([2]), "draft");
  expect([ends(), page.bandsAreOld.value]).toEqual([[100, 200], true]);
  answer = async () => ({ ...reach, bands: [300] });
  plans.value = after(ofPlaces([2]));
  expect([ends(), page.bandsAreOld.value]).toEqual([[100, 200], true]);
  await settle();
  expect([ends(), page.bandsAreOld.value]).toEqual([[300], false]);
});

it("are dropped where another plan is there before they are", async () => {
  const stopped: boolean[] = [];
  answer = (stop) => new Promise(() => stop.addEventListener("abort", () => stopped.push(true)));
  plans.value = after(ofPlaces([1]));
  await settle();
  answer = async () => reach;
  plans.value = after(ofPlaces([2]));
  await settle();
  expect([asked, stopped, ends()]).toEqual([[[1], [2]], [true], [100, 200]]);
});

it("are not asked for while they are hidden, or where vehicles collide", async () => {
  page.toggleBands();
  plans.value = after(ofPlaces([1]));
  await settle();
  expect(asked).toEqual([]);
  page.toggleBands();
  await settle();
  expect([asked, ends()]).toEqual([[[1]], [100, 200]]);
  page.toggleBands();
  expect(ends()).toBeUndefined();
  page.toggleBands();
  await settle();
  expect([asked, ends()]).toEqual([[[1]], [100, 200]]);
  plans.value = after(ofPlaces([3], true));
  await settle();
  expect([asked, page.bands.value, page.bandsAreOld.value]).toEqual([[[1]], null, false]);
});

it("may be none, or fail", async () => {
  answer = async () => ({ ...reach, bands: [] });
  plans.value = after(ofPlaces([1]));
  await settle();
  expect([page.bands.value, page.bandsAreOld.value]).toEqual([null, false]);
  answer = async () => {
    throw new Error("no");
  };
  plans.value = after(ofPlaces([2]));
  await settle();
  expect([asked, page.bands.value]).toEqual([[[1], [2]], null]);
});
