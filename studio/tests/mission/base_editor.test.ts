import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Client } from "../../src/api/client";
import { type Aircraft, mostBases } from "../../src/domain/agents";
import type { Cell } from "../../src/domain/geometry";
import { Studio } from "../../src/mission/studio";
import { FakeClient } from "./fake_client";

let client: FakeClient;
let studio: Studio;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
const aircraft = (index = 1) => studio.page.mission.value!.agents[index] as Aircraft;

beforeEach(async () => {
  vi.useFakeTimers();
  client = new FakeClient();
  studio = new Studio(client as unknown as Client);
  await studio.maps.start("?map=yard.map&start=0,2&goal=3,0&removals=1");
  await settle();
  studio.editor.changeAgent(1, { endurance: 60, recharge: 30 });
});
afterEach(() => vi.useRealTimers());

it("sets bases until it is ended, plans with them, and undoes each", async () => {
  studio.bases.begin(1);
  expect([studio.editor.tool.value, studio.bases.aircraft.value?.id]).toEqual(["base", "air"]);
  studio.bases.set([1, 1]);
  studio.bases.set([2, 0]);
  studio.bases.set([1, 1]); // is one
  expect(studio.editor.tool.value).toBe("base");
  studio.bases.set(null);
  expect(studio.editor.tool.value).toBe("move");
  await settle();
  expect(client.planned.at(-1)!.request.mission.agents[1]).toMatchObject({ endurance: 60, recharge: 30, bases: [[1, 1], [2, 0]] });
  studio.undo();
  expect(aircraft().bases).toEqual([[1, 1]]);
  studio.bases.remove(1, 0);
  expect(aircraft().bases).toEqual([]);
  await settle();
  expect(client.planned.at(-1)!.request.mission.agents[1]).not.toHaveProperty("bases");
});

it("sets those of the aircraft that was chosen, and none once it does not recharge", async () => {
  studio.editor.addAircraft();
  expect(aircraft(2)).toMatchObject({ endurance: 60, recharge: 30 });
  studio.bases.begin(2);
  studio.editor.removeAgent(1); // the other one is second now, and called as of a pair
  studio.bases.set([1, 1]);
  expect([aircraft().bases, studio.editor.tool.value]).toEqual([[], "move"]);
  studio.bases.begin(1);
  studio.editor.changeAgent(1, { recharge: null });
  expect(studio.bases.aircraft.value).toBeNull();
  studio.bases.set([1, 1]);
  expect([aircraft().bases, studio.editor.tool.value]).toEqual([[], "move"]);
  await settle();
});

it("takes no more than planners do", async () => {
  const all = Array.from({ length: mostBases }, (_, i): Cell => [i % 4, Math.floor(i / 4)]);
  studio.editor.changeAgent(1, { bases: all });
  studio.bases.begin(1);
  studio.bases.set([3, 99]);
  expect(aircraft().bases).toHaveLength(mostBases);
  expect(studio.page.notice.value).toMatchObject({ tone: "bad", text: "An aircraft has no more than 100 bases." });
  await settle();
});
