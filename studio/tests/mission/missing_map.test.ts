// A map that the service does not have any more: what the page says, and how it is sent again.
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Client } from "../../src/api/client";
import { Studio } from "../../src/mission/studio";
import { FakeClient } from "./fake_client";

let client: FakeClient;
let studio: Studio;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
// The way without removals is asked for beside each plan.
const last = () => client.planned.filter(({ request }) => request.options?.removals !== 0).at(-1)!;
const yard = { name: "yard.map", bytes: new Blob(["upload-1"]) };
const slide = async (removals: number) => {
  studio.editor.change((mission) => ({ ...mission, removals }));
  await settle(1000);
};

beforeEach(async () => {
  vi.useFakeTimers();
  client = new FakeClient();
  studio = new Studio(client as unknown as Client);
  await studio.maps.start("");
  await studio.maps.upload(yard);
  await settle(1000);
});

afterEach(() => vi.useRealTimers());

it("a missing map is asked for once, said, and what is shown is said to be old", async () => {
  client.missing.add("upload-1");
  const before = client.asks;
  await slide(3);
  expect(client.asks - before).toBeLessThanOrEqual(2); // the plan, and the way without removals beside it
  const after = client.asks;
  for (const removals of [4, 5, 6]) await slide(removals);
  await settle(60_000);
  expect(client.asks).toBe(after);
  expect(studio.maps.lost.value).toMatchObject({ id: "upload-1", name: "yard.map", file: yard });
  expect(studio.page.results.plans.value.after).toBeDefined();
  expect(studio.page.old.value).toBe(true);
});

it("a missing map is sent again on request, and the mission goes on", async () => {
  client.missing.add("upload-1");
  await slide(3);
  await slide(5);
  await studio.maps.restore(studio.maps.lost.value!.file!);
  await settle(1000);
  expect(studio.maps.lost.value).toBeNull();
  expect(last()).toMatchObject({ map: "upload-1", request: { options: { removals: 5 } } });
  expect(studio.page.old.value).toBe(false);
});

it("a missing map is not any other map", async () => {
  client.missing.add("upload-1");
  await slide(3);
  await studio.maps.restore({ name: "city.map", bytes: new Blob(["city.map"]) });
  expect(studio.page.notice.value?.text).toContain("“city.map” is not the map");
  expect(studio.maps.lost.value?.id).toBe("upload-1");
});

it("a missing map is drawn on anew where only the drawing is gone", async () => {
  studio.editor.mark(1, "exclude");
  await settle(1000);
  expect(last().map).toBe("edited");
  client.missing.add("edited");
  client.edit = async () => (client.missing.clear(), client.map("edited"));
  await slide(3);
  expect(last()).toMatchObject({ map: "edited", request: { options: { removals: 3 } } });
  expect(studio.maps.lost.value).toBeNull();
});

it("a missing map is asked for when a step back leads to it, and the page stays where it is until it is there", async () => {
  studio.maps.choose("city.map");
  await settle(1000);
  client.missing.add("upload-1");
  studio.editor.undo();
  await settle(1000);
  expect(studio.page.mission.value?.map).toBe("city.map");
  expect(studio.maps.lost.value?.name).toBe("yard.map");
  await studio.maps.restore(studio.maps.lost.value!.file!);
  await settle(1000);
  expect(studio.page.mission.value?.map).toBe("upload-1");
  expect(last().map).toBe("upload-1");
});

it("a missing map of a link is known by the name of its file", async () => {
  const query = studio.query();
  expect(query).toContain("&file=yard.map");
  client.missing.add("upload-1");
  studio = new Studio(client as unknown as Client);
  await studio.maps.start(query.replace("removals=2", "removals=7"));
  await settle(1000);
  expect(studio.page.mission.value?.map).toBe("city.map");
  expect(studio.maps.lost.value).toMatchObject({ name: "yard.map", file: null });
  await studio.maps.restore(yard);
  await settle(1000);
  expect(last()).toMatchObject({ map: "upload-1", request: { options: { removals: 7 } } });
});
