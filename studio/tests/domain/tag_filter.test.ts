// What a rule protects: the same as on the command line (tests/io/tagged_obstacles_test.cpp has the same town).
import { describe, expect, it } from "vitest";
import type { Obstacle } from "../../src/domain/map";
import { filtersText, filterText, matches, parseTagFilters } from "../../src/domain/tag_filter";
import { draws, mapOf } from "./picture";

const obstacle = (what: Partial<Obstacle>): Obstacle => ({ ...mapOf("a").obstacle(1)!, ...what });
const school = { kind: "building", name: "Upper School" } as const;
const shop = { kind: "building", name: "Corner Shop" } as const;

// A church; a section of a school and a shop; a section of the shop alone; a wall without a name.
const town: Obstacle[] = [
  obstacle({ id: 1, name: "St. Mary", tags: ["amenity=place_of_worship", "building=church"] }),
  obstacle({ id: 2, name: "Upper School, Corner Shop", tags: ["amenity=school", "building=yes"], structures: [school, shop] }),
  obstacle({ id: 3, name: "Corner Shop", tags: ["building=yes", "historic=no"], structures: [shop] }),
  obstacle({ id: 4 }),
];

function meant(text: string): number[] {
  const filters = parseTagFilters(text)!;
  return town.filter((one) => filters.some((filter) => matches(one, filter))).map(({ id }) => id);
}

describe("a rule by tag or name", () => {
  it("means the obstacles that have the tag", () => {
    expect(meant("amenity=school")).toEqual([2]);
    expect(meant("amenity")).toEqual([1, 2]);
    expect(meant("building=ch*,yes")).toEqual([1, 2, 3]);
    expect(meant("building=church,amenity=school")).toEqual([1, 2]);
    expect(meant("*")).toEqual([1, 2, 3]);
    expect(meant("historic")).toEqual([]);
  });

  it("means what is called so, and sections of it", () => {
    expect(meant("name=Corner Shop")).toEqual([2, 3]);
    expect(meant("name=*School")).toEqual([2]);
    expect(meant("name=St. M*")).toEqual([1]);
    expect(meant("name")).toEqual([1, 2, 3]);
  });

  it("is refused where it is none", () => {
    for (const text of ["", "amenity=", "=school", "a,", 'na"me=x']) expect(parseTagFilters(text), text).toBeNull();
    expect(parseTagFilters("amenity=a,b,name=c=d")).toEqual([
      { key: "amenity", values: ["a", "b"] },
      { key: "name", values: ["c=d"] },
    ]);
  });

  it("keeps its words, beside others as well", () => {
    const filters = parseTagFilters("name=St. Mary*,amenity=hospital,school")!.concat({ key: "heritage", values: [] });
    expect(filters.map(filterText)).toEqual(["name=St. Mary*", "amenity=hospital,school", "heritage"]);
    expect(parseTagFilters(filtersText(filters))).toEqual([filters[2], filters[0], filters[1]]);
  });

  it("has a star for any text", () => {
    const fits = (text: string, pattern: string): boolean => {
      if (pattern === "") return text === "";
      if (pattern[0] !== "*") return text[0] === pattern[0] && fits(text.slice(1), pattern.slice(1));
      return [...text, ""].some((_, taken) => fits(text.slice(taken), pattern.slice(1)));
    };
    const draw = draws(5);
    const some = (letters: string, least: number) =>
      Array.from({ length: least + Math.floor(draw() * 7) }, () => letters[Math.floor(draw() * letters.length)]).join("");
    const counts = { yes: 0, no: 0 };
    for (let i = 0; i < 2000; ++i) {
      const [name, pattern] = [some("ab", 1), some("ab*", 1)];
      const found = matches(obstacle({ name }), { key: "name", values: [pattern] });
      expect([name, pattern, found]).toEqual([name, pattern, fits(name, pattern)]);
      ++counts[found ? "yes" : "no"];
    }
    expect(Math.min(counts.yes, counts.no)).toBeGreaterThan(300);
  });
});
