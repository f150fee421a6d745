// What agents open, and how long that takes them: kept in files and links, edited, and asked of the service.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Client } from "../../src/api/client";
import type { AgentDocument } from "../../src/domain/agent_document";
import { type Agents, aircraftOf, changed, vehiclesOf } from "../../src/domain/agents";
import { freshMission } from "../../src/domain/mission";
import { decodeLink, encodeLink } from "../../src/mission/link";
import { missionFile, queryOfFile } from "../../src/mission/mission_file";
import { leftOutOfPlan, missionOfPlan } from "../../src/mission/plan_mission";
import { Studio } from "../../src/mission/studio";
import { planOf } from "../domain/plans";
import { FakeClient } from "./fake_client";

const ends = { start: [1, 2], goal: [3, 4] } satisfies Parameters<typeof freshMission>[1];
const fresh = freshMission("m", ends);
const decoded = (query: string) => decodeLink(query, "m", ends, 10, 10);

describe("links", () => {
  const opener = (query: string) => aircraftOf(decoded(`vehicles=1,2,3,4&aircraft=${query}`).mission.agents)[0];
  const linked = (index: number, part: object) => encodeLink({ ...fresh, agents: changed(fresh.agents, index, part) }, 10);

  it("say it behind all that they said before", () => {
    const once = ",,,,3,,heli,900,60,0.2,2,300,1.1";
    expect(opener(once)).toMatchObject({ bases: [[1, 1]], breachTime: null, breachTimePerCell: null, mostArea: null, only: null });
    const all = opener(`${once},20,0.5,300,17_4!barrier%252Cbuilding%253Dgarage%252Cshed`);
    expect(all).toMatchObject({ breachTime: 20, breachTimePerCell: 0.5, mostArea: 300, only: [17, 4, "barrier", "building=garage,shed"] });
    expect(linked(1, { mostArea: 300, only: [17] })).toContain("&aircraft=,,,,,,air,,,,,,,,,300,17&");
    expect(linked(1, { only: [] })).toContain("&aircraft=,,,,,,air,,,,,,,,,,!&");
    const vehicle = vehiclesOf(decoded("vehicles=1,2,3,4,,,,dozer,2,,20,,,,2.5").mission.agents)[0];
    expect(vehicle).toMatchObject({ breaches: 2, breachTime: 20, reach: 2.5 });
    expect(linked(0, { reach: 0 })).toContain("vehicles=1,2,3,4,,,,ground,,,,,,,0&");
  });

  it.each([",,,,,,,,,,,,,-1", ",,,,,,,,,,,,,x", ",,,,,,,,,,,,,,-1", ",,,,,,,,,,,,,,,0", ",,,,,,,,,,,,,,,,0", ",,,,,,,,,,,,,,,,1.5", ",,,,,,,,,,,,,,,,!%253Db"])(
    "complain of what cannot be: %s",
    (aircraft) => {
      expect(opener(aircraft)).toMatchObject({ breachTime: null, only: null });
      expect(decoded(`vehicles=1,2,3,4&aircraft=${aircraft}`).complaints).toHaveLength(1);
    },
  );

  it("take no reach that is none", () => {
    for (const reach of ["-1", "101", "far"]) expect(decoded(`vehicles=1,2,3,4,,,,,2,,,,,,${reach}`).complaints).toHaveLength(1);
  });
});

describe("mission files", () => {
  const dozer = { id: "dozer", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1, radius: 0.5, breaches: 2 };
  const drone = { id: "drone", kind: "air", start: [1, 2], goal: [1, 2], speed: 1 };
  const can_breach = { most_cells: 60, only: [17, "barrier", "building=garage,shed"] };
  const opened = (agents: object[], more: object = {}) => {
    const said = queryOfFile({ format: "waybreaker-mission/1", agents, ...more }, 2)!;
    return { ...decoded(said.query), leftOut: said.leftOut };
  };
  const saved = (agents: Agents) =>
    (JSON.parse(missionFile({ ...fresh, agents }, { width: 10, cell: 2, metric: true }, 3)) as { agents: AgentDocument[] }).agents;

  it("keep all of it, in seconds and square metres on the page", () => {
    const own = { breach_time: 20, breach_time_per_cell: 0.5, can_breach };
    const found = opened([{ ...dozer, ...own, reach: 2.5 }, { ...drone, ...own }], { time_unit: "s" });
    expect([found.complaints, found.leftOut]).toEqual([[], []]);
    const abilities = { breachTime: 20, breachTimePerCell: 0.5, mostArea: 240, only: can_breach.only };
    expect(found.mission.agents).toMatchObject([{ ...abilities, reach: 2.5 }, abilities]);
    expect(saved(found.mission.agents)).toMatchObject([{ ...own, reach: 2.5 }, own]);
    expect(saved(fresh.agents).flatMap(Object.keys)).toEqual(expect.not.arrayContaining(["breach_time", "can_breach", "reach"]));
  });

  it("have times in their own unit", () => {
    const found = opened([dozer, { ...drone, breach_time: 20, breach_time_per_cell: 0.5 }]); // cells of 2 m, at 1 m/s
    expect(found.mission.agents[1]).toMatchObject({ breachTime: 40, breachTimePerCell: 1 });
  });

  it("keep what an agent opens that breaches nothing now", () => {
    const found = opened([{ ...dozer, breaches: 0, breach_time: 20, can_breach }, drone], { time_unit: "s" });
    expect(saved(found.mission.agents)[0]).toMatchObject({ breach_time: 20, can_breach });
  });

  it("are complained of where something cannot be, and nothing is dropped without a word", () => {
    const wrong = [{ breach_time: -1 }, { breach_time: null }, { breach_time_per_cell: "x" }, { can_breach: { most_cells: 0 } }];
    const named = [{ can_breach: { only: [0] } }, { can_breach: { only: [1.5] } }, { can_breach: { only: ["=b"] } }];
    for (const part of [...wrong, ...named]) expect(opened([dozer, { ...drone, ...part }]).complaints).toHaveLength(1);
    expect(opened([{ ...dozer, reach: 101 }, drone]).complaints).toHaveLength(1);
    expect(opened([dozer, { ...drone, reach: 2 }]).leftOut).toEqual(["reach of aircraft"]);
    expect(opened([dozer, { ...drone, can_breach: { least_cells: 2 } }]).leftOut).toEqual(["can_breach that is more than most_cells and only"]);
  });

  it("of plans are kept as well", () => {
    const plan = planOf({ after: 9 });
    plan.map.cell_size = 2;
    plan.mission = { time_unit: "s", agents: [{}, { breach_time: 20, can_breach: { most_cells: 60, only: [17] } }] };
    expect(missionOfPlan(plan, "m")!.agents[1]).toMatchObject({ breachTime: 20, mostArea: 240, only: [17] });
    expect(leftOutOfPlan(plan)).toEqual([]);
  });
});

describe("on the page", () => {
  let client: FakeClient;
  let studio: Studio;
  const settle = () => vi.advanceTimersByTimeAsync(0);
  const asked = () => client.planned.at(-1)!.request.mission.agents;

  beforeEach(async () => {
    vi.useFakeTimers();
    client = new FakeClient();
    studio = new Studio(client as unknown as Client);
    await studio.maps.start("?map=town.map&start=0,3&goal=9,3&removals=1");
    await settle();
  });
  afterEach(() => vi.useRealTimers());

  it("is planned with, undone and done again", async () => {
    studio.editor.changeAgent(1, { breachTime: 20 });
    studio.editor.changeAgent(1, { mostArea: 3 });
    await settle();
    expect(asked()[1]).toMatchObject({ breach_time: 20, can_breach: { most_cells: 3 } });
    studio.undo();
    await settle();
    expect(asked()[1]).toMatchObject({ breach_time: 20 });
    expect(asked()[1]).not.toHaveProperty("can_breach");
    studio.editor.redo();
    await settle();
    expect(asked()[1]).toMatchObject({ breach_time: 20, can_breach: { most_cells: 3 } });
  });

  it("names obstacles of the map that is planned on", async () => {
    const only = [1, 2, 99, "amenity=theatre", "name=nobody"];
    studio.editor.changeAgent(1, { only });
    await settle();
    expect(asked()[1]).toMatchObject({ can_breach: { only } });
    studio.editor.mark(1, "exclude"); // and with it all theatres; the other obstacle is the first one then
    await settle();
    expect(client.planned.at(-1)!.map).toBe("edited");
    expect(asked()[1]).toMatchObject({ can_breach: { only: [1, 99, "name=nobody"] } });
    expect(studio.page.mission.value!.agents[1]!.only).toEqual(only);
  });

  it("is taken over by one aircraft more, and by no vehicle", async () => {
    studio.editor.leaveItAlone();
    studio.editor.changeAgent(0, { breachTime: 20, only: [1], reach: 2 });
    studio.editor.addVehicle();
    expect(studio.page.mission.value!.agents).toMatchObject([{ only: [1], reach: 2 }, { breachTime: null, only: null, reach: 1 }]);
    studio.editor.removeAgent(1);
    studio.editor.addAircraft(); // opens the way for the robot from now on
    expect(studio.page.mission.value!.agents).toMatchObject([{ breachTime: null, only: null, reach: 1 }, { breachTime: null }]);
    studio.editor.changeAgent(1, { breachTime: 5, only: [2] });
    studio.editor.addAircraft();
    expect(studio.page.mission.value!.agents[2]).toMatchObject({ breachTime: 5, only: [2] });
    await settle();
  });
});
