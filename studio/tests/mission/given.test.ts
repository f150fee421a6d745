// What is dropped, opened or pasted. (File is no global of Node 18.)
import { expect, it } from "vitest";
import { freshMission } from "../../src/domain/mission";
import { fragmentOf } from "../../src/mission/address";
import { missionInText, understood } from "../../src/mission/given";
import { decodeLink, encodeLink } from "../../src/mission/link";
import { missionFile } from "../../src/mission/mission_file";
import { mapsOfPlan, missionOfPlan } from "../../src/mission/plan_mission";
import { planOf } from "../domain/plans";

const file = (name: string, ...parts: BlobPart[]) => Object.assign(new Blob(parts), { name }) as unknown as File;
const kindOf = async (...files: File[]) => (await understood(files)).kind;
const query = "map=a.map&start=1,2&goal=3,4&removals=5";

it("tells maps, plans and missions apart by what is in them", async () => {
  expect(await kindOf(file("a.map", "type octile\nheight 1\n"))).toBe("map");
  expect(await kindOf(file("a.tif", new Uint8Array([73, 73, 42, 0, 123])))).toBe("map");
  expect(await kindOf(file("a.xml", "<map>see http://x.org/#map=a</map>"))).toBe("map");
  expect(await kindOf(file("p.txt", JSON.stringify(planOf({ after: 9 }))))).toBe("plan");
  expect(await understood([file("m.json", missionFile(query))])).toEqual({
    kind: "mission",
    query: new URLSearchParams(query).toString(),
  });
  expect(await kindOf(file("m.url", `[InternetShortcut]\nURL=http://localhost:8080/#${query}\n`))).toBe("mission");
});

it("says what a file is not", async () => {
  await expect(understood([file("x.json", '{"a": 1}')])).rejects.toThrow(/“x.json” is neither a plan nor a mission/);
  const half = JSON.stringify({ ...planOf({ after: 9 }), agents: [{ kind: "ground" }] });
  await expect(understood([file("x.json", half)])).rejects.toThrow(/neither a plan/);
  await expect(understood([file("x.json", '{"format": "waybreaker-pl')])).rejects.toThrow(/no complete JSON/);
  await expect(understood([file("a.map", "x"), file("b.map", "y")])).rejects.toThrow(/One at a time/);
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
  await expect(understood([yaml])).rejects.toThrow("“floor.yaml” belongs to “floor.pgm”: choose both together.");
});

it("finds the mission of a link in a text", async () => {
  const link = `http://127.0.0.1:8080/${await fragmentOf(query)}`;
  expect(await missionInText(`look: ${link}\n`)).toBe(query);
  expect(await missionInText(`http://127.0.0.1:8080/?${query}`)).toBe(query);
  expect(await missionInText("http://example.org/")).toBeNull();
  expect(await missionInText("http://example.org/#z=broken")).toBeNull();
  expect(await missionInText("no link")).toBeNull();
});

it("a mission file says what the link says", async () => {
  const mission = { ...freshMission("b c.map", { start: [1, 2], goal: [3, 4] }), groundSpeed: 2.5 };
  const given = await understood([file("mission.json", missionFile(encodeLink(mission, 10)))]);
  if (given.kind !== "mission") throw new Error(given.kind);
  expect(decodeLink(given.query, "b c.map", mission.markers, 10, 10)).toEqual({ mission, complaints: [] });
});

it("a plan file says its mission, in metres and seconds", () => {
  const plan = planOf({ after: 9, options: { removals: 4, objective: "flowtime", protect: [3], force: [1], breach_time: 7 } });
  plan.map = { source: "yard.map", width: 10, height: 10, cell_size: 2, digest: `sha256:${"0123456789abcdef".repeat(4)}` };
  plan.agents[0]!.speed = 1.5;
  plan.agents[1]!.goal = [5, 5];
  expect(missionOfPlan(plan, "yard.map")).toMatchObject({
    markers: { start: [0, 0], goal: [9, 0], air_goal: [5, 5] },
    removals: 4,
    objective: "flowtime",
    groundSpeed: 3,
    airSpeed: 2,
    breachTime: 7,
    marks: new Map([
      [3, "protect"],
      [1, "force"],
    ]),
  });
  expect(mapsOfPlan(plan)).toEqual(["yard.map", "upload-0123456789abcdef", "upload-0123456789abcdef-8"]);
  expect(missionOfPlan(planOf({ after: null }), "m")).toBeNull();
});
