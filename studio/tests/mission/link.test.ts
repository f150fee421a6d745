import { describe, expect, it } from "vitest";
import { aircraftOf, changed } from "../../src/domain/agents";
import type { Run } from "../../src/domain/geometry";
import { freshMission, type Mark } from "../../src/domain/mission";
import { decodeLink, encodeLink, mapOfLink } from "../../src/mission/link";
import { decodeRuns, encodeRuns } from "../../src/mission/run_code";
import { Random } from "./random";
import { height, markers, randomMission, sorted, width } from "./random_mission";

describe("link", () => {
  it("brings back every mission", () => {
    const random = new Random(1);
    for (let i = 0; i < 300; ++i) {
      const mission = randomMission(random);
      const query = encodeLink(mission, width);
      expect(mapOfLink(query)).toBe(mission.map);
      const decoded = decodeLink(query, mission.map, markers, width, height);
      expect(decoded.complaints).toEqual([]);
      expect(sorted(decoded.mission)).toEqual(sorted(mission));
    }
  });

  it("is readable and says only what is unusual", () => {
    const mission = freshMission("berlin-mitte.tif", { start: [256, 434], goal: [118, 55] });
    expect(encodeLink(mission, width)).toBe("map=berlin-mitte.tif&start=256,434&goal=118,55&removals=2");
    const marked = {
      ...mission,
      marks: new Map<number, Mark>([
        [4, "protect"],
        [17, "protect"],
      ]),
    };
    expect(encodeLink(marked, width)).toContain("&protect=4,17");
  });

  it("says where an aircraft recharges, behind all that links said before", () => {
    const once = "vehicles=1,2,3,4&aircraft=,,,,3,,heli,900,60,0.2,2";
    const air = (query: string) => aircraftOf(decodeLink(query, "m", markers, width, height).mission.agents)[0];
    expect(air(once)).toMatchObject({ id: "heli", reserve: 0.2, weight: 2, recharge: null, bases: [] });
    expect(air(`${once},300`)).toMatchObject({ weight: 2, recharge: 300, bases: [] });
    expect(air(`${once},300,10.20.500.399`)).toMatchObject({ recharge: 300, bases: [[10, 20], [500, 399]] });
    const two = freshMission("m", markers);
    const mission = { ...two, agents: changed(two.agents, 1, { endurance: 60, recharge: 300, bases: [[10, 20]] }) };
    expect(encodeLink(mission, width)).toContain("&aircraft=,,,,,,air,,60,,,300,10.20&");
    const off = { ...two, agents: changed(two.agents, 1, { recharge: 300 }) }; // while its battery has no end
    expect(decodeLink(encodeLink(off, width), "m", markers, width, height).mission).toEqual(off);
  });

  it.each([
    ["vehicles=1,2,3,4&aircraft=,,,,,,,900,,,,0", "vehicles"],
    ["vehicles=1,2,3,4&aircraft=,,,,,,,900,,,,60,10.20.30", "vehicles"],
    ["vehicles=1,2,3,4&aircraft=,,,,,,,900,,,,60,10.a", "vehicles"],
    ["vehicles=1,2,3,4&aircraft=,,,,,,,900,,,,60,501.1", "vehicles"],
    [`vehicles=1,2,3,4&aircraft=,,,,,,,900,,,,60,${Array.from({ length: 101 }, () => "1.1").join(".")}`, "vehicles"],
    ["start=9999,1", "start"],
    ["start=-1,1", "start"],
    ["goal=a,b", "goal"],
    ["removals=9", "removals"],
    ["removals=", "removals"],
    ["method=best", "method"],
    ["ground_speed=0", "ground_speed"],
    ["ground_speed=NaN", "ground_speed"],
    ["air_speed=1e99", "air_speed"],
    ["protect=1,x", "protect"],
    ["force=0", "force"],
    ["exclude=wall.1000.1", "exclude"],
    ["walls=%00", "walls"],
    ["erased=__8", "erased"],
    ["show=all", "show"],
    ["time=-1", "time"],
    ["also=budget:x", "also"],
    ["also=toString:1", "also"],
    ["also=timing:late", "also"],
    ["zones=no_fly:a::1,2,3,4", "zones"],
    ["zones=no_fly:a::1,2,3,4,5,x", "zones"],
    ["zones=park:a::1,2,3,4,5,6", "zones"],
    ["zones=no_fly:%25E0%25A4:a:1,2,3,4,5,6", "zones"],
  ])("says what cannot be read in %s and takes the usual", (query, name) => {
    const { mission, complaints } = decodeLink(query, "m", markers, width, height);
    expect(complaints).toHaveLength(1);
    expect(complaints[0]).toContain(name);
    expect(mission).toEqual(freshMission("m", markers));
  });

  it("survives any text", () => {
    const random = new Random(2);
    const names = ["start", "walls", "erased", "protect", "removals", "time", "show", "radius", "map", "zones"];
    for (let i = 0; i < 500; ++i) {
      const noise = Array.from({ length: random.below(40) }, () => String.fromCharCode(random.below(300))).join("");
      decodeLink(`${random.oneOf(names)}=${noise}`, "m", markers, width, height);
    }
  });

  it("keeps runs on the map", () => {
    const query = `walls=${encodeRuns([
      [490, 5, 100],
      [0, 399, 3],
      [0, 400, 3],
    ])}`;
    expect(decodeLink(query, "m", markers, width, height).mission.walls).toEqual([
      [490, 5, 11],
      [0, 399, 3],
    ]);
  });
});

describe("runs as text", () => {
  it("come back, in few letters", () => {
    const stroke = Array.from({ length: 60 }, (_, y): Run => [100 + y, 200 + y, 3]);
    expect(decodeRuns(encodeRuns(stroke))).toEqual(stroke);
    expect(encodeRuns(stroke).length).toBeLessThan(300);
    expect(decodeRuns("")).toEqual([]);
  });

  it("must be whole", () => {
    expect(() => decodeRuns(encodeRuns([[100, 200, 3]]).slice(0, -2))).toThrow();
  });
});
