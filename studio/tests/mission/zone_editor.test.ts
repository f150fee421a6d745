import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Client } from "../../src/api/client";
import type { Point } from "../../src/domain/geometry";
import { decodeLink } from "../../src/mission/link";
import { Studio } from "../../src/mission/studio";
import { FakeClient } from "./fake_client";

let client: FakeClient;
let studio: Studio;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
const triangle: Point[] = [[1, 1], [2.5, 1], [1, 3]];
const zones = () => studio.page.mission.value!.zones;

beforeEach(async () => {
  vi.useFakeTimers();
  client = new FakeClient();
  studio = new Studio(client as unknown as Client);
  await studio.maps.start("?map=yard.map&start=0,2&goal=3,0&removals=1");
  await settle();
});
afterEach(() => vi.useRealTimers());

it("plans with what is drawn, and undoes it", async () => {
  studio.zones.outline(triangle.slice(0, 2), false);
  expect(studio.zones.corners.value).toBe(2);
  studio.zones.kind.value = "keep_out";
  studio.zones.outline(triangle, true);
  await settle();
  expect(studio.zones.corners.value).toBe(0);
  expect(zones()).toEqual([{ kind: "keep_out", name: "", agents: [], rings: [triangle] }]);
  const rules = client.planned.at(-1)!.request.mission.rules;
  expect(rules.zones!.features[0]!.geometry.coordinates).toEqual([[...triangle, [1, 1]]]);
  studio.undo();
  await settle();
  expect(zones()).toEqual([]);
  expect(client.planned.at(-1)!.request.mission.rules).not.toHaveProperty("zones");
});

it("refuses an outline that crosses itself, and says why", () => {
  studio.zones.outline([[0, 0], [2, 2], [2, 0], [0, 2]], true);
  expect(zones()).toEqual([]);
  expect(studio.page.notice.value).toMatchObject({ tone: "bad", text: expect.stringContaining("cross") });
});

it("is renamed in one step, changes its kind, and goes", async () => {
  studio.zones.outline(triangle, true);
  studio.zones.rename(0, "h");
  studio.zones.rename(0, "helipad");
  studio.zones.endGesture();
  studio.zones.setKind(0, "keep_out");
  expect(zones()[0]).toMatchObject({ kind: "keep_out", name: "helipad" });
  studio.undo();
  studio.undo();
  expect(zones()[0]).toMatchObject({ kind: "no_fly", name: "" });
  studio.zones.setTime(0, "from", 10);
  studio.zones.setTime(0, "until", 20);
  expect(zones()[0]).toMatchObject({ from: 10, until: 20 });
  studio.zones.setTime(0, "from", undefined);
  expect(zones()[0]).not.toHaveProperty("from");
  studio.zones.remove(0);
  expect(zones()).toEqual([]);
  await settle();
});

it("stands in the link and in the file, which the page opens again", async () => {
  studio.zones.outline(triangle, true);
  studio.zones.rename(0, "helipad");
  await settle();
  const { mission } = decodeLink(studio.query(), "yard.map", { start: [0, 2], goal: [3, 0] }, 4, 4);
  expect(mission.zones).toEqual(zones());
  const file = JSON.parse(studio.missionFile()!) as { rules: { zones: unknown }; page: object };
  expect(file.rules.zones).toMatchObject({ crs: "cells", features: [{ properties: { zone: "no_fly", name: "helipad" } }] });
  expect(file.page).not.toHaveProperty("zones");
});

it("follows the names of its agents", async () => {
  studio.zones.outline(triangle, true);
  const agents = studio.page.mission.value!.agents;
  const air = agents.findIndex(({ kind }) => kind === "air");
  studio.editor.change((mission) => ({ ...mission, zones: [{ ...mission.zones[0]!, agents: [agents[air]!.id] }] }));
  studio.editor.renameAgent(air, "hawk");
  expect(zones()[0]!.agents).toEqual(["hawk"]);
  studio.editor.removeAgent(air);
  expect(zones()).toEqual([]);
  await settle();
});
