import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { type Client, ServiceError } from "../../src/api/client";
import { without } from "../../src/domain/also";
import { Studio } from "../../src/mission/studio";
import { FakeClient } from "./fake_client";

let client: FakeClient;
let studio: Studio;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
// The way without removals is asked for beside each plan.
const last = () => client.planned.filter(({ request }) => request.options?.removals !== 0).at(-1)!;

beforeEach(async () => {
  vi.useFakeTimers();
  client = new FakeClient();
  studio = new Studio(client as unknown as Client);
});
afterEach(() => vi.useRealTimers());

it("begins with a map and a plan, without being asked anything", async () => {
  await studio.maps.start("");
  await settle();
  expect(studio.page.mission.value?.map).toBe("city.map");
  expect(studio.page.results.plans.value.after?.plan.status).toBe("solved");
  expect(studio.editor.canUndo.value).toBe(false);
  await settle(1000);
  expect(studio.page.results.plans.value.after?.verdict).toEqual({ valid: true });
});

it("opens what a link says, and says itself the same", async () => {
  const link = "?map=yard.map&start=0,2&goal=3,0&removals=1&method=paper&protect=1&ground_speed=2&show=after,paper";
  await studio.maps.start(link);
  await settle();
  expect(last()).toMatchObject({
    map: "yard.map",
    request: {
      mission: { agents: [{ start: [0, 2], goal: [3, 0], speed: 2 }, { kind: "air" }] },
      options: { paper: true, protect: [1], removals: 1 },
    },
  });
  expect(studio.query().split("&").sort()).toEqual(link.slice(1).split("&").sort());
});

it("plans with what it has no control for, and keeps it until it is taken back", async () => {
  const link = "map=yard.map&start=0,2&goal=3,0&removals=1&also=budget_m2:300,timing:ignore,moves:4";
  await studio.maps.start(`?${link}`);
  await settle(5000);
  expect(last().request.options).toMatchObject({ paper: true, budget_m2: 300 });
  expect(last().request.options).not.toHaveProperty("moves"); // the paper's method is another
  for (const { request } of client.planned.filter((one) => !one.request.options?.paper)) {
    expect(request.options).toMatchObject({ budget_m2: 300, timing: "ignore", moves: 4 });
  }
  expect(studio.query()).toContain("&also=budget_m2:300,timing:ignore,moves:4");
  expect(JSON.parse(studio.missionFile()!)).toMatchObject({ rules: { budget_m2: 300, timing: "ignore" }, method: { moves: 4 } });
  studio.editor.change((old) => ({ ...old, also: without(old.also, "budget_m2") }));
  await settle();
  expect(last().request.options).not.toHaveProperty("budget_m2");
});

it("shows another map where the link's is not there, and says so", async () => {
  await studio.maps.start("?map=nowhere.map&removals=7");
  await settle();
  expect(studio.page.mission.value).toMatchObject({ map: "city.map", removals: 2 });
  expect(studio.maps.lost.value?.name).toBe("nowhere.map");
});

it("plans on the map as it is after exclusions, with its ids", async () => {
  await studio.maps.start("");
  studio.editor.mark(2, "protect");
  studio.editor.mark(1, "exclude");
  await settle();
  expect(client.edits).toEqual([
    {
      block: [],
      free: [
        [4, 0, 1],
        [4, 1, 1],
        [4, 2, 1],
      ],
    },
  ]);
  expect(last()).toMatchObject({ map: "edited", request: { options: { protect: [1] } } });
  expect(studio.query()).toContain("protect=2&exclude=1");
  expect(studio.page.markOf(1)).toBe("protect");

  studio.editor.undo();
  await settle();
  expect(last()).toMatchObject({ map: "city.map", request: { options: { protect: [2] } } });
});

it("protects by tag or name what the map has, and tells the service so", async () => {
  await studio.maps.start("?map=town.map&start=0,0&goal=9,3&protect=2&protect_all=amenity%3Dtheatre");
  await settle();
  expect(last().request.options?.protect).toEqual([2, "amenity=theatre"]);
  expect([studio.page.markOf(1), studio.page.ruleOf(1)]).toEqual(["protect", { key: "amenity", values: ["theatre"] }]);
  expect([studio.page.markOf(2), studio.page.ruleOf(2)]).toEqual(["protect", null]);
  expect(studio.query()).toContain("protect_all=amenity%3Dtheatre");
  expect(JSON.parse(studio.missionFile()!)).toMatchObject({ rules: { protect: [2, "amenity=theatre"] } });

  studio.editor.protectAll([{ key: "name", values: ["*Globe"] }]);
  await settle();
  expect(last().request.options?.protect).toEqual([2, "amenity=theatre", "name=*Globe"]);
  studio.editor.allowAll({ key: "amenity", values: ["theatre"] });
  studio.editor.undo();
  studio.editor.undo();
  await settle();
  expect(last().request.options?.protect).toEqual([2, "amenity=theatre"]);

  studio.editor.mark(1, "exclude"); // nothing is left that the rule could mean: no fault of the rule
  await settle();
  expect(last()).toMatchObject({ map: "edited", request: { options: { protect: [1] } } });
  await studio.maps.open("town.map", "protect_all=amenity%3Dzoo"); // what the map never had, the service refuses
  await settle();
  expect(last().request.options?.protect).toEqual(["amenity=zoo"]);
});

it("what rules protect is the same while a marker is dragged, so that the map need not be painted again", async () => {
  for (const rule of ["", "&protect_all=amenity%3Dtheatre"]) {
    await studio.maps.open("town.map", `start=0,0&goal=9,3${rule}`);
    const { value } = studio.page.ruled;
    studio.editor.drag({ agent: 0, end: "start" }, [1, 0], false);
    expect(studio.page.ruled.value).toBe(value);
    expect(value.size).toBe(rule === "" ? 0 : 1);
  }
});

it("what is forced is not among all that is protected later", async () => {
  await studio.maps.start("?map=town.map&start=0,0&goal=9,3&force=1");
  studio.editor.protectAll([{ key: "amenity", values: ["theatre"] }]);
  await settle();
  expect(last().request.options).toMatchObject({ protect: ["amenity=theatre"] });
  expect(last().request.options).not.toHaveProperty("force");
});

it("asks for an edited map once", async () => {
  await studio.maps.start("?map=city.map&exclude=1");
  await settle();
  studio.editor.change((mission) => ({ ...mission, removals: 5 }));
  await settle();
  expect(last().request.options?.removals).toBe(5);
  expect(client.edits).toHaveLength(1);
});

it("says when the service does not edit, and keeps what it shows", async () => {
  await studio.maps.start("");
  await settle();
  client.editable = false;
  studio.editor.mark(1, "exclude");
  await settle();
  expect(studio.page.notice.value).toEqual({ tone: "bad", text: "No.", actions: [] });
  expect(studio.page.results.plans.value.after).toBeDefined();
});

it("takes a drag back as one step", async () => {
  await studio.maps.start("");
  const before = studio.page.mission.value!.agents[0]!;
  for (const x of [1, 2, 3]) studio.editor.drag({ agent: 0, end: "start" }, [x, 0], x === 3);
  await settle();
  expect(last().request.mission.agents[0]).toMatchObject({ start: [3, 0] });
  studio.editor.undo();
  await settle();
  expect(last().request.mission.agents[0]).toMatchObject({ start: before.start });
  expect(studio.editor.canUndo.value).toBe(false);
});

it("plans for a team as soon as somebody joins, and for one and one again when they leave", async () => {
  await studio.maps.start("");
  const pair = studio.page.mission.value!.agents;
  studio.editor.addVehicle();
  await settle();
  const { mission, options } = last().request;
  expect(mission).toMatchObject({
    format: "waybreaker-mission/1",
    agents: [{ id: "1" }, { id: "2", radius: 0.5 }, { id: "air1", kind: "air" }],
  });
  expect(options).toMatchObject({ select: "exact" });
  expect(options).not.toHaveProperty("radius");
  const [one, two] = studio.page.mission.value!.agents;
  expect(two!.start).not.toEqual(one!.start);
  expect(two!.goal).not.toEqual(one!.goal);
  expect(studio.page.chosenAgent.value).toBe(1);
  studio.editor.removeAgent(1);
  await settle();
  expect(studio.page.mission.value!.agents).toEqual(pair);
  expect(last().request.mission.agents).toMatchObject([{ start: pair[0]!.start }, { id: "air" }]);
  studio.editor.undo();
  expect(studio.page.mission.value!.agents).toHaveLength(3);
});

it("keeps when the only vehicle leaves, what the only aircraft may open, and who has a name", async () => {
  await studio.maps.start("");
  studio.editor.changeAgent(0, { readyAt: 5 });
  studio.editor.changeAgent(1, { breaches: 1 });
  await settle();
  const said = [{ id: "ground", ready_at: 5 }, { id: "air", breaches: 1 }];
  expect(last().request.mission.agents).toMatchObject(said);
  expect(JSON.parse(studio.missionFile()!).agents).toMatchObject(said);
  const query = studio.query();
  studio.editor.addAircraft();
  studio.editor.renameAgent(0, "truck");
  studio.editor.removeAgent(2);
  await settle();
  expect(last().request.mission.agents).toMatchObject([{ id: "truck", ready_at: 5 }, { id: "air", breaches: 1 }]);
  await studio.maps.open("city.map", query);
  await settle();
  expect(last().request.mission.agents).toMatchObject(said);
});

it("keeps the names of a team apart, and its last vehicle", async () => {
  await studio.maps.start("");
  studio.editor.addAircraft();
  studio.editor.renameAgent(0, "air2");
  expect(studio.page.notice.value?.text).toContain("air2");
  studio.editor.renameAgent(0, " truck ");
  expect(studio.page.mission.value!.agents.map(({ id }) => id)).toEqual(["truck", "air1", "air2"]);
  studio.editor.removeAgent(0);
  expect(studio.page.mission.value!.agents).toHaveLength(3);
});

it("asks what each removal saves a team, but nothing of the paper's way to plan", async () => {
  await studio.maps.start("?method=paper");
  studio.editor.addVehicle();
  client.planned.length = 0;
  await settle(5000);
  for (const { request } of client.planned) expect(request.options?.paper).toBeUndefined();
  expect(client.planned.at(-1)?.request.options?.explain).toBe(true);
});

it("goes back to the map before, too", async () => {
  await studio.maps.start("");
  studio.maps.choose("yard.map");
  await settle();
  expect(last().map).toBe("yard.map");
  studio.editor.undo();
  await settle();
  expect(last().map).toBe("city.map");
  expect(studio.page.shown.value?.base.description.id).toBe("city.map");
});

it("allows as many removals as have to be", async () => {
  await studio.maps.start("?map=city.map&removals=1");
  studio.editor.mark(1, "force");
  studio.editor.mark(2, "force");
  await settle();
  expect(last().request.options).toMatchObject({ removals: 2, force: [1, 2] });
});

it("loses nothing to a file that is no map", async () => {
  await studio.maps.start("");
  await settle();
  await studio.maps.upload({ name: "bad.map", bytes: new Blob(["hello"]) });
  expect(studio.page.notice.value?.text).toBe("“bad.map” cannot be used as a map: Not a map.");
  expect(studio.page.loading.value).toBe(false);
  expect(studio.page.mission.value?.map).toBe("city.map");
  expect(studio.page.results.plans.value.after).toBeDefined();
});

it("waits for a server that is gone, and then asks for what is wanted by then", async () => {
  await studio.maps.start("");
  await settle();
  client.gone = true;
  studio.editor.change((mission) => ({ ...mission, removals: 3 }));
  await settle();
  expect(studio.gone.value).toBe(true);
  expect(studio.page.results.plans.value.after).toBeDefined();
  studio.editor.change((mission) => ({ ...mission, removals: 4 }));
  await settle(5000);
  expect(studio.gone.value).toBe(true);
  client.gone = false;
  await settle(2000);
  expect(studio.gone.value).toBe(false);
  expect(last().request.options?.removals).toBe(4);
});

it("does not remove what was drawn, unless told that it may", async () => {
  await studio.maps.start("?map=city.map");
  await settle(1000);
  studio.editor.draw("wall", [[1, 3, 3]]);
  await settle(1000);
  const options = () => last().request.options ?? {};
  const wall = 3;
  expect(last().map).toBe("walled");
  expect(options().protect).toEqual([wall]);
  expect(studio.page.markOf(wall)).toBe("protect");

  studio.editor.mark(wall, null);
  await settle(1000);
  expect(options().protect).toBeUndefined();
  expect(studio.page.markOf(wall)).toBeNull();
  const link = `?${studio.query()}`;

  studio.editor.mark(wall, "force");
  await settle(1000);
  expect(options()).toMatchObject({ force: [wall] });
  expect(options().protect).toBeUndefined();

  studio.editor.mark(wall, "protect");
  await settle(1000);
  expect(options().protect).toEqual([wall]);
  expect(studio.page.mission.value?.marks.size).toBe(0);

  studio = new Studio(client as unknown as Client);
  await studio.maps.start(link);
  await settle(1000);
  expect(studio.page.markOf(wall)).toBeNull();
  expect(options().protect).toBeUndefined();
});

it("asks a server that breaks off every plan less and less often", async () => {
  await studio.maps.start("");
  await settle();
  let plans = 0;
  client.plan = async () => {
    ++plans;
    throw new ServiceError("gone", "Nobody there.");
  };
  studio.editor.change((mission) => ({ ...mission, removals: 3 }));
  await settle(600_000);
  expect(plans).toBeLessThan(30);
});
