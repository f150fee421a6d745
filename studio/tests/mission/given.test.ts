// What is dropped, opened or pasted. (File is no global of Node 18.)
import { expect, it } from "vitest";
import { type Agents, changed } from "../../src/domain/agents";
import type { Point } from "../../src/domain/geometry";
import { freshMission, type Mission, wallKey } from "../../src/domain/mission";
import type { Plan } from "../../src/domain/plan";
import { zoneCollection } from "../../src/domain/zone";
import { fragmentOf } from "../../src/mission/address";
import { missionInText, understood } from "../../src/mission/given";
import { decodeLink, encodeLink } from "../../src/mission/link";
import { missionFile, queryOfFile } from "../../src/mission/mission_file";
import { leftOutOfPlan, missionOfPlan } from "../../src/mission/plan_mission";
import { planOf } from "../domain/plans";
import { Random } from "./random";
import { height, markers, randomMission, sorted, width } from "./random_mission";

const file = (name: string, ...parts: BlobPart[]) => Object.assign(new Blob(parts), { name }) as unknown as File;
const kindOf = async (...files: File[]) => (await understood(files)).kind;
const yard = freshMission("yard.map", { start: [1, 2], goal: [3, 4] });
const tenWide = { width: 10, cell: 2, metric: true };
const query = "map=a.map&start=1,2&goal=3,4&removals=5";

it("tells maps, plans and missions apart by what is in them", async () => {
  expect(await kindOf(file("a.map", "type octile\nheight 1\n"))).toBe("map");
  expect(await kindOf(file("a.tif", new Uint8Array([73, 73, 42, 0, 123])))).toBe("map");
  expect(await kindOf(file("a.xml", "<map>see http://x.org/#map=a</map>"))).toBe("map");
  expect(await kindOf(file("p.txt", JSON.stringify(planOf({ after: 9 }))))).toBe("plan");
  expect(await kindOf(file("m.json", missionFile(yard, tenWide, 3)))).toBe("mission file");
  const zones = [{ kind: "no_fly", name: "", agents: [], rings: [[[0, 0], [4, 0], [4, 4]]] }] satisfies Mission["zones"];
  expect(await kindOf(file("m.json", missionFile({ ...yard, zones }, tenWide, 3)))).toBe("mission file");
  const { features } = zoneCollection(zones);
  expect(await kindOf(file("z.json", JSON.stringify({ type: "FeatureCollection", features })))).toBe("zones");
  expect(await kindOf(file("z.geojson", JSON.stringify(zoneCollection(zones))))).toBe("zones");
  expect(await kindOf(file("m.url", `[InternetShortcut]\nURL=http://localhost:8080/#${query}\n`))).toBe("mission");
});

it("tells map data by its first bytes", async () => {
  const all = [
    file("a", new Uint8Array([0, 0, 0, 13, 10, 9]), "OSMHeader", new Uint8Array([24, 127])),
    file("a.xml", '<?xml version="1.0"?>\n<!-- by hand -->\n<osm version="0.6">'),
    file("a.osm.gz", new Uint8Array([0x1f, 0x8b, 8, 0])),
    file("a.geojson", '{"type": "FeatureCollection", "features": [{"properties": {"building": "yes"}}]}'),
  ];
  for (const one of all) expect(await kindOf(one)).toBe("map data");
  expect(await kindOf(file("a.xml", "<root><map/></root>"))).toBe("map");
});

it("tells what can lie over a map from the map data of a city", async () => {
  const all = [
    file("a.json", ' {"type": "FeatureCollection", "features": []}'),
    file("a.geojson", '{"name": "x", "type": "FeatureCollection"}'),
    file("flood.geojson", '{"type": "Feature", "properties": {"name": "building site"}}'),
  ];
  for (const one of all) expect(await kindOf(one)).toBe("shapes");
});

it("says what a file is not", async () => {
  await expect(understood([file("x.json", '{"a": 1}')])).rejects.toThrow(/“x.json” is neither a plan nor a mission/);
  const half = JSON.stringify({ ...planOf({ after: 9 }), agents: [{ kind: "ground" }] });
  await expect(understood([file("x.json", half)])).rejects.toThrow(/neither a plan/);
  await expect(understood([file("x.json", '{"format": "waybreaker-pl')])).rejects.toThrow(/no complete JSON/);
  await expect(understood([file("a.map", "x"), file("b.map", "y")])).rejects.toThrow(/One at a time/);
  const shape = file("roads.shp", new Uint8Array([0, 0, 0x27, 0x0a, 0, 0]));
  await expect(understood([shape])).rejects.toThrow(/one of the files of a shapefile.*waybreaker import/);
  await expect(understood([file("roads.dbf", new Uint8Array([3, 95]))])).rejects.toThrow(/ogr2ogr town\.geojson roads\.shp/);
  await expect(understood([file("town.gpkg", "SQLite format 3\0")])).rejects.toThrow(/GeoPackage.*waybreaker import/);
  const folder = { name: "maps", arrayBuffer: () => Promise.reject(new Error("NotFound")) } as unknown as File;
  await expect(understood([folder])).rejects.toThrow(/cannot be read/);
});

it("puts the two files of a ROS map together, in whatever order they come", async () => {
  const yaml = file("floor.yaml", "image: floor.pgm\nresolution: 0.05");
  const image = file("floor.pgm", "P5 1 1 255\n", new Uint8Array([205]));
  for (const files of [
    [yaml, image],
    [image, yaml],
  ]) {
    const given = await understood(files);
    if (given.kind !== "map") throw new Error(given.kind);
    expect(given.file.name).toBe("floor.yaml");
    const bytes = new Uint8Array(await given.file.bytes.arrayBuffer());
    const text = String.fromCharCode(...bytes);
    expect(text).toBe("image: floor.pgm\nresolution: 0.05\n...\nP5 1 1 255\n\u00cd");
  }
});

it.each([
  ["image: floor.pgm\nresolution: 0.05", "“floor.pgm”"],
  ["resolution: 0.05\nimage: 'floor 2.pgm' # the second\n", "“floor 2.pgm”"],
  ["  resolution: 0.05\r\n  image: maps/floor 2, north.pgm  # the second\r\n", "“maps/floor 2, north.pgm”"],
  ["  image: floor.pgm", "“floor.pgm”"],
  ["{resolution: 0.05, image: floor.pgm, origin: [0, 0, 0]}", "“floor.pgm”"],
  ['{"image": "floor.pgm", "resolution": 0.05}', "“floor.pgm”"],
  ["{\n  image: floor.pgm\n}", "“floor.pgm”"],
  ["my_image: floor.pgm\n", "an image"],
  ["# image: old.pgm\nresolution: 0.05\nimage: #\n", "an image"],
])("names the image that the YAML of a ROS map lacks: %j", async (yaml, image) => {
  await expect(understood([file("floor.yaml", yaml)])).rejects.toThrow(`“floor.yaml” belongs to ${image}: choose both together.`);
});

it("finds the mission of a link in a text", async () => {
  const link = `http://127.0.0.1:8080/${await fragmentOf(query)}`;
  expect(await missionInText(`look: ${link}\n`)).toBe(query);
  expect(await missionInText(`http://127.0.0.1:8080/?${query}`)).toBe(query);
  expect(await missionInText("http://example.org/")).toBeNull();
  expect(await missionInText("http://example.org/#z=broken")).toBeNull();
  expect(await missionInText("no link")).toBeNull();
});

const missionIn = (text: string, cell = 2) => {
  const said = queryOfFile(JSON.parse(text) as Record<string, unknown>, cell);
  return said && { ...decodeLink(said.query, "yard.map", { start: [1, 2], goal: [3, 4] }, 10, 10), leftOut: said.leftOut };
};

it("a mission file brings back all of a mission", () => {
  const wall = wallKey([4, 5], 10);
  const missions: Mission[] = [
    yard,
    { ...yard, agents: changed(yard.agents, 0, { speed: 2.5, radius: 1.5 }), breachTime: 3, breachTimePerCell: 0.5, objective: "flowtime", time: 7.5 },
    { ...yard, agents: changed(yard.agents, 1, { start: [9, 9], goal: [0, 0] }), removals: 5, layers: ["before"] },
    { ...yard, method: "paper", removals: 1, walls: [[4, 5, 1]], erased: [[0, 3, 2]] },
    { ...yard, walls: [[4, 5, 1]], marks: new Map([[3, "protect"], [7, "force"], [8, "exclude"], [wall, "force"]]) },
    { ...yard, protectAll: [{ key: "heritage", values: [] }, { key: "amenity", values: ["hospital", "school"] }] },
    { ...yard, removals: "auto", price: 4, marks: new Map([[wall, "allow"]]), walls: [[4, 5, 1]] },
  ];
  for (const mission of missions) {
    expect(missionIn(missionFile(mission, tenWide, 3))).toEqual({ mission, complaints: [], leftOut: [] });
  }
});

it("a mission file brings back every mission", () => {
  const random = new Random(2);
  for (let i = 0; i < 300; ++i) {
    const drawn = randomMission(random);
    const speed = () => random.oneOf([1, 10, 2.5, 0.3]); // cells keep 15 digits of metres
    const mission = { ...drawn, agents: drawn.agents.map((agent) => ({ ...agent, speed: speed() })) };
    const cell = random.oneOf([1, 2, 2.4, 0.05]);
    const said = queryOfFile(JSON.parse(missionFile(mission, { width, cell, metric: true }, 3)) as Record<string, unknown>, 7);
    expect(said?.leftOut).toEqual([]);
    const { mission: back, complaints } = decodeLink(said!.query, mission.map, markers, width, height);
    expect(complaints).toEqual([]);
    expect(sorted(back)).toEqual(sorted(mission));
  }
});

it("a mission file is the command line's, in cells", () => {
  const said = JSON.parse(missionFile({ ...yard, agents: changed(yard.agents, 0, { speed: 3 }), removals: "auto", marks: new Map([[3, "protect"]]) }, tenWide, 4));
  expect(said).toMatchObject({
    format: "waybreaker-mission/1",
    time_unit: "s",
    agents: [
      { id: "ground", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1.5, radius: 0.5 },
      { id: "air", kind: "air", start: [1, 2], goal: [3, 4] },
    ],
    rules: { removals: 4, protect: [3], force: [], timing: "enforce", objective: "makespan" },
    method: { select: "exact" },
    page: { map: "yard.map", removals: "auto", cell_size: 2 },
  });
});

it("a mission file of the command line opens, and what the page cannot ask is said", () => {
  const agents = [
    { id: "g", kind: "ground", start: [1, 2], goal: [3, 4], speed: 2, corners: "cut" },
    { id: "a", kind: "air", start: [1, 2], goal: [5, 5] },
  ];
  const document = { format: "waybreaker-mission/1", agents, rules: { removals: 2, budget: 12, force: [6], protect: [5, "amenity=school"] } };
  const found = missionIn(JSON.stringify(document));
  expect(found?.mission).toMatchObject({
    removals: 2,
    agents: [{ id: "g", speed: 4 }, { id: "a", speed: 2, start: null, goal: [5, 5] }],
  });
  expect(found?.mission.marks).toEqual(new Map([[5, "protect"], [6, "force"]]));
  expect(found?.mission.protectAll).toEqual([{ key: "amenity", values: ["school"] }]);
  expect(found?.mission.also).toEqual({ budget: 12, corners: "cut" });
  expect(found?.leftOut).toEqual([]);
  expect(missionIn(JSON.stringify({ ...document, agents: [agents[1]] }))).toBeNull();
});

it("a mission file whose speeds are all 1 is at 1 m/s, unless its times are seconds", () => {
  const two = [{ id: "ground", kind: "ground", start: [1, 2], goal: [3, 4] }, { id: "air", kind: "air", start: [1, 2], goal: [3, 4], speed: 1 }];
  const team = [two[0], { id: "2", kind: "ground", start: [5, 5], goal: [6, 6], ready_at: 10 }, two[1]];
  const yard = { kind: "no_fly" as const, name: "", agents: [], rings: [[[0, 0], [3, 0], [3, 3]] as Point[]], from: 10, until: 30 };
  const rules = { breach_time: 5, breach_time_per_cell: 0.5, rubble: 4, zones: zoneCollection([yard]) };
  const opened = (agents: unknown, more: object) => missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules, ...more }))!.mission;
  for (const agents of [two, team]) {
    const [free, said] = [opened(agents, {}), opened(agents, { time_unit: "s" })];
    expect(free.agents.map(({ speed }) => speed)).toEqual(agents.map(() => 1));
    expect(free).toMatchObject({ breachTime: 10, breachTimePerCell: 1, rubble: 8, zones: [{ from: 20, until: 60 }] });
    expect(said.agents.map(({ speed }) => speed)).toEqual(agents.map(() => 2));
    expect(said).toMatchObject({ breachTime: 5, breachTimePerCell: 0.5, rubble: 4, zones: [{ from: 10, until: 30 }] });
  }
  expect(opened(team, {}).agents[1]).toMatchObject({ readyAt: 20 });
});

it("a mission file keeps what the page has no control for", () => {
  const agents = [{ id: "ground", kind: "ground", start: [1, 2], goal: [3, 4] }, { id: "air", kind: "air", start: [1, 2], goal: [3, 4] }];
  const open = (document: object) => missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, ...document }))!;
  const alsoIn = (rules: object, method: object = {}) => open({ rules, method }).mission.also;
  expect(alsoIn({ budget_m2: 300 })).toEqual({ budget_m2: 300 });
  expect(alsoIn({ minimise_demolition: 0.05, timing: "ignore" }, { explain: true })).toEqual({ minimise_demolition: 0.05, timing: "ignore" });
  expect(alsoIn({}, { select: "none", planner: "optimal", moves: 8, weight: 1 })).toEqual({ select: "none" });
  const steps = open({ rules: {}, method: { select: "hits", planner: "astar", moves: 4 } });
  expect(steps.mission).toMatchObject({ method: "paper", also: { timing: "enforce", flight: "optimal", planner: "astar", moves: 4 } });
  const saved = JSON.parse(missionFile(steps.mission, tenWide, 3)) as Record<string, unknown>;
  expect(saved).toMatchObject({ rules: { timing: "enforce" }, method: { select: "hits", flight: "optimal", planner: "astar", moves: 4 } });
  expect(open(saved).mission).toEqual(steps.mission);
  expect(open({ rules: { timing: "late" } }).complaints).toEqual(["“also=timing:late” in the link cannot be read"]);
});

it.each([0, 1])("a mission file of one vehicle and one aircraft opens with all that it says, and is saved so, aircraft first: %i", (turned) => {
  const agents = [
    { id: "truck", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1, radius: 0.5, ready_at: 5 },
    { id: "heli", kind: "air", start: [1, 2], goal: [3, 4], speed: 3, breaches: 1 },
  ];
  const rules = { removals: 3, separation: 0.5, at_goal: "leave" };
  const document = { format: "waybreaker-mission/1", agents: turned ? [...agents].reverse() : agents, rules };
  const found = missionIn(JSON.stringify(document))!;
  expect([found.complaints, found.leftOut]).toEqual([[], []]);
  expect(found.mission.agents).toMatchObject([{ id: "truck", speed: 2, readyAt: 5 }, { id: "heli", speed: 6, breaches: 1 }]);
  expect(JSON.parse(missionFile(found.mission, tenWide, 3))).toMatchObject({ agents, rules });
});

it("a mission file says what is left out of it", () => {
  const agents = [
    { id: "truck", kind: "ground", start: [1, 2], goal: [3, 4], ready_at: 5 },
    { id: "heli", kind: "air", start: [1, 2], goal: [3, 4], breaches: 1 },
  ];
  const open = (document: object) => missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, ...document }))!;
  expect(open({ rules: { removals: 12, noise: 1 } }).leftOut).toEqual([
    "noise",
    "12 removals: 8 are the most here",
  ]);
  expect(open({ overlays: [{ file: "flood.geojson", as: "water", width: 8 }] }).leftOut).toEqual([
    "the overlay flood.geojson: drop that file on the page, and lay it over the map as water",
  ]);
  const three = [{ ...agents[0], corners: "cut" }, { ...agents[0], id: "2", breaches: 1, weight: 40 }, { ...agents[1], ready_at: 3 }];
  expect(open({ agents: three }).leftOut).toEqual([
    "corners, which differ between its vehicles",
    "ready_at of aircraft",
  ]);
});

it("a mission file keeps what it protects by tag or name", () => {
  const rules = { protect: [5, "name=St. Mary*", "amenity=hospital,school,heritage=4"] };
  const agents = [{ id: "g", kind: "ground", start: [1, 2], goal: [3, 4] }, { id: "a", kind: "air", start: [1, 2], goal: [3, 4] }];
  const found = missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules }))!;
  expect([found.complaints, found.leftOut]).toEqual([[], []]);
  const saved = JSON.parse(missionFile(found.mission, tenWide, 3)) as { rules: object; page: object };
  expect(saved.rules).toMatchObject({ protect: [5, "name=St. Mary*", "amenity=hospital,school", "heritage=4"] });
  expect(saved.page).not.toHaveProperty("protect_all");
  const odd = missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules: { protect: ["amenity="] } }))!;
  expect(odd.complaints).toEqual(["“protect_all=amenity=” in the link cannot be read"]);
});

it("a mission file of a team opens with all that it says, and is saved so", () => {
  const agents = [
    { id: "truck", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1, radius: 1.5 },
    { id: "rover, 2~", kind: "ground", start: [6, 6], goal: [8, 8], speed: 2, radius: 0.5, ready_at: 20 },
    { id: "drone", kind: "air", start: [1, 2], goal: [3, 4], speed: 5, breaches: 2 },
    { id: "heli", kind: "air", start: [9, 9], goal: [3, 4], speed: 10 },
  ];
  const rules = { removals: 3, breach_time: 5, objective: "flowtime", separation: 0.5, at_goal: "leave" };
  const found = missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules }))!;
  expect(found.complaints).toEqual([]);
  expect(found.leftOut).toEqual([]);
  expect(found.mission).toMatchObject({
    agents: [
      { id: "truck", speed: 2, radius: 1.5, readyAt: 0 },
      { id: "rover, 2~", start: [6, 6], goal: [8, 8], speed: 4, readyAt: 20 },
      { id: "drone", start: null, goal: null, speed: 10, breaches: 2 },
      { id: "heli", start: [9, 9], goal: null, speed: 20, breaches: null },
    ],
    separation: 0.5,
    atGoal: "leave",
  });
  const saved = JSON.parse(missionFile(found.mission, tenWide, 3)) as Record<string, unknown>;
  expect(saved).toMatchObject({ agents, rules, method: { select: "exact" } });
  expect(Object.keys(saved.page as object)).toEqual(["map", "cell_size"]);
});

it("a mission file keeps the batteries of aircraft, in metres and seconds on the page", () => {
  const agents = [
    { id: "truck", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1 },
    { id: "drone", kind: "air", start: [1, 2], goal: [1, 2], speed: 5, range: 450, endurance: 90, reserve: 0.2 },
    { id: "heli", kind: "air", start: [9, 9], goal: [3, 4], speed: 10 },
  ];
  const found = missionIn(JSON.stringify({ format: "waybreaker-mission/1", time_unit: "s", agents }))!;
  expect([found.complaints, found.leftOut]).toEqual([[], []]);
  expect(found.mission.agents.slice(1)).toMatchObject([
    { id: "drone", range: 900, endurance: 90, reserve: 0.2 },
    { id: "heli", range: null, endurance: null, reserve: 0 },
  ]);
  const saved = JSON.parse(missionFile(found.mission, tenWide, 3)) as { agents: object[] };
  expect(saved.agents[1]).toMatchObject({ range: 450, endurance: 90, reserve: 0.2 });
  expect(Object.keys(saved.agents[2]!)).toEqual(["id", "kind", "start", "goal", "speed"]);
  const kept = changed(found.mission.agents, 1, { range: null, endurance: null }); // of what never ends nothing is kept
  expect((JSON.parse(missionFile({ ...found.mission, agents: kept }, tenWide, 3)) as typeof saved).agents[1]).not.toHaveProperty("reserve");
  const wrong = missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents: [agents[0], { ...agents[1], range: -1 }] }))!;
  expect(wrong.complaints).toHaveLength(1);
});

it("a mission file keeps where aircraft recharge, and how long", () => {
  const truck = { id: "truck", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1 };
  const drone = { id: "drone", kind: "air", start: [1, 2], goal: [1, 2], speed: 1, endurance: 90 };
  const fileOf = (...aircraft: object[]) => JSON.stringify({ format: "waybreaker-mission/1", agents: [truck, ...aircraft] });
  const said = [{ ...drone, recharge: 300, bases: [[5, 6], [0, 9]] }, { ...drone, id: "heli", recharge: 30 }];
  const found = missionIn(fileOf(...said))!;
  expect([found.complaints, found.leftOut]).toEqual([[], []]);
  expect(found.mission.agents.slice(1)).toMatchObject([
    { endurance: 180, recharge: 600, bases: [[5, 6], [0, 9]] }, // cells of 2 m, at 1 m/s
    { endurance: 180, recharge: 60, bases: [] },
  ]);
  const saved = (agents: Agents) => (JSON.parse(missionFile({ ...found.mission, agents }, tenWide, 3)) as { agents: object[] }).agents;
  expect(saved(found.mission.agents)[1]).toMatchObject({ endurance: 180, recharge: 600, bases: [[5, 6], [0, 9]] });
  expect(saved(found.mission.agents)[2]).not.toHaveProperty("bases");
  for (const part of [{ recharge: null }, { endurance: null }]) {
    const kept = saved(changed(found.mission.agents, 1, part))[1];
    expect([kept, "recharge" in kept!, "bases" in kept!]).toEqual([kept, false, false]);
  }

  expect(missionIn(fileOf({ ...drone, bases: [[5, 6]] }))!.leftOut).toEqual(["bases of aircraft without recharge"]);
  expect(missionIn(fileOf({ ...drone, endurance: undefined, recharge: 9 }))!.leftOut).toEqual(["recharge of aircraft without range and endurance"]);
  expect(missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents: [{ ...truck, recharge: 9, bases: [[1, 1]] }] }))!.leftOut).toEqual(
    ["recharge of vehicles", "bases of vehicles"],
  );
  const wrong = [{ recharge: 0 }, { recharge: 9, bases: [[500, 1]] }, { recharge: 9, bases: Array.from({ length: 101 }, () => [1, 1]) }];
  for (const part of wrong) expect(missionIn(fileOf({ ...drone, ...part }))!.complaints).toHaveLength(1);
});

it("a mission file of many places keeps its rules and weights", () => {
  const agents = [
    { id: "school", kind: "ground", start: [1, 2], goal: [3, 4], speed: 1, weight: 180 },
    { id: "mill", kind: "ground", start: [1, 2], goal: [6, 4], speed: 1 },
    { id: "air", kind: "air", start: [1, 2], goal: [1, 2], speed: 1, weight: 0 },
  ];
  const rules = { removals: 3, objective: "flowtime", collisions: false, unreached: 310 };
  const found = missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules }))!;
  expect([found.complaints, found.leftOut]).toEqual([[], []]);
  expect(found.mission).toMatchObject({ collisions: false, unreached: 620, objective: "flowtime" }); // cells of 2 m, at 1 m/s
  expect(found.mission.agents.map(({ weight }) => weight)).toEqual([180, 1, 0]);
  const back = JSON.parse(missionFile(found.mission, tenWide, 3)) as { agents: object[]; rules: object };
  expect(back.rules).toMatchObject({ collisions: false, unreached: 620, separation: 0 });
  expect(back.agents.map((agent) => ("weight" in agent ? agent.weight : 1))).toEqual([180, 1, 0]);
  const apart = JSON.parse(missionFile({ ...found.mission, collisions: true }, tenWide, 3)) as typeof back;
  expect(apart.rules).not.toHaveProperty("collisions"); // nor what is for those that pass alone
  expect(apart.rules).not.toHaveProperty("unreached");
  expect(missionIn(JSON.stringify({ format: "waybreaker-mission/1", agents, rules: { collisions: "maybe" } }))!.complaints).toHaveLength(1);

  const plan = { ...planOf({ after: 9, options: { objective: "flowtime" } }), mission: { time_unit: "s", agents, rules } };
  plan.map.cell_size = 2;
  plan.after.routes = [];
  plan.agents = agents.map((agent) => ({ ...plan.agents[0]!, ...agent }) as Plan["agents"][number]);
  expect(missionOfPlan(plan, "m")).toMatchObject({ collisions: false, unreached: 310, agents: [{ weight: 180 }, { weight: 1 }, { weight: 0 }] });
  expect(leftOutOfPlan(plan)).toEqual([]);
});

it("a mission file of former versions, a link line by line, still opens", () => {
  const link = Object.fromEntries(new URLSearchParams(encodeLink({ ...yard, removals: 6 }, 10)));
  expect(missionIn(JSON.stringify({ format: "waybreaker-mission/1", ...link }))?.mission.removals).toBe(6);
});
