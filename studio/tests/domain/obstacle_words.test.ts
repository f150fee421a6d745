import { describe, expect, it } from "vitest";
import { lookOf, looksOn } from "../../src/domain/looks";
import type { Obstacle } from "../../src/domain/map";
import { factsOf, usesAmong, usesOf, whatItIs, whyItStays } from "../../src/domain/obstacle_words";
import { filterText } from "../../src/domain/tag_filter";
import { mapOf } from "./picture";

const obstacle = (what: Partial<Obstacle>): Obstacle => ({ ...mapOf("a").obstacle(1)!, ...what });

describe("an obstacle in words", () => {
  it("is what the source of the map calls it", () => {
    expect(whatItIs(obstacle({}))).toBe("obstacle");
    expect(whatItIs(obstacle({ kind: "building", tags: ["building=yes"] }))).toBe("building");
    expect(whatItIs(obstacle({ kind: "barrier", tags: ["barrier=hedge"] }))).toBe("hedge");
    expect(whatItIs(obstacle({ kind: "barrier", tags: ["barrier=yes"] }))).toBe("wall or fence");
  });

  it("is a section of what it has parts of", () => {
    const parts = (...kinds: ("building" | "barrier")[]) => whatItIs(obstacle({ structures: kinds.map((kind) => ({ kind })) }));
    expect(parts("building")).toBe("section of a building");
    expect(parts("building", "barrier", "building")).toBe("section of 2 buildings and a wall or fence");
  });

  it("is used for what its tags say, each use once", () => {
    expect(usesOf(obstacle({ tags: ["amenity=place_of_worship", "building=church", "heritage=4"] }))).toEqual([
      "place of worship",
      "church",
      "heritage",
    ]);
    expect(usesOf(obstacle({ tags: ["building=residential", "historic=yes"] }))).toEqual([]);
    expect(usesOf(obstacle({ tags: ["amenity=school", "building=school"] }))).toEqual(["school"]);
  });

  it("says what it is once, in what it is called or after it", () => {
    const school = obstacle({ kind: "building", tags: ["amenity=school"] });
    expect(factsOf(school, "Building 17")).toEqual(["school"]);
    expect(factsOf(school, "Building Site 9 School")).toEqual(["Building", "school"]);
    expect(factsOf(obstacle({ kind: "barrier", tags: ["barrier=city_wall", "historic=city_wall"] }), "City wall 3")).toEqual([]);
    expect(factsOf(obstacle({ kind: "water", destructible: false }), "Spree")).toEqual(["Water"]);
    expect(factsOf(obstacle({}), "Obstacle 1")).toEqual([]);
  });

  it("says why it stays, if it does", () => {
    expect(whyItStays(obstacle({}))).toBeNull();
    expect(whyItStays(obstacle({ destructible: false, kind: "water" }))).toMatch(/^Water/);
    expect(whyItStays(obstacle({ destructible: false, kind: "forbidden" }))).toMatch(/motorway/);
    expect(whyItStays(obstacle({ destructible: false, kind: "building", tags: ["amenity=school"] }))).toMatch(/\(school\)/);
    expect(whyItStays(obstacle({ destructible: false }))).toBe("It cannot be removed.");
  });

  it("can be protected with all others of its use", () => {
    const theatre = { tags: ["amenity=theatre"] };
    const all = [
      obstacle({ id: 1, ...theatre }),
      obstacle({ id: 2, destructible: false, ...theatre }),
      obstacle({ id: 3, ...theatre }),
      obstacle({ id: 4, tags: ["amenity=school", "building=school", "heritage=2"] }),
      obstacle({ id: 5, tags: ["building=school", "historic=no"] }),
    ];
    expect(usesAmong(all).map(({ name, obstacles, rules }) => [name, obstacles, ...rules.map(filterText)])).toEqual([
      ["heritage", 1, "heritage"],
      ["school", 2, "amenity=school", "building=school"],
      ["theatre", 2, "amenity=theatre"],
    ]);
  });
});

it("looks like what it is, unless it can be removed", () => {
  expect(lookOf(obstacle({}))).toBe("removable");
  expect(lookOf(obstacle({ kind: "barrier" }))).toBe("barrier");
  expect(lookOf(obstacle({ kind: "barrier", destructible: false }))).toBe("fixed");
  expect(lookOf(obstacle({ kind: "water", destructible: false }))).toBe("water");
  expect(looksOn(mapOf("aB"))).toEqual(["removable", "fixed"]);
  expect(looksOn(mapOf("ab"), new Set([2]))).toEqual(["removable", "fixed"]);
});
