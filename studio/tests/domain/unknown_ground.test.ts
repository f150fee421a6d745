import { expect, it } from "vitest";
import { lookOf } from "../../src/domain/looks";
import { factsOf, whatItIs, whyItStays } from "../../src/domain/obstacle_words";
import { unknownSentence } from "../../src/domain/unknown_ground";
import { mapOf } from "./picture";

const ofRobots = { ...mapOf("A").obstacle(1)!, tags: ["occupancy=unknown"] };
const unknown = { ...ofRobots, kind: "unknown" as const };

it("looks like nothing else, on maps that say what obstacles are and on those of robots", () => {
  expect(lookOf(unknown)).toBe("unknown");
  expect(lookOf(ofRobots)).toBe("unknown");
  expect(lookOf({ ...unknown, tags: ["barrier=wall"] })).toBe("fixed");
});

it("is called so, and why it stays is said", () => {
  expect(whatItIs(unknown)).toBe("unknown ground");
  expect(factsOf(unknown, "Unknown ground 1")).toEqual([]);
  expect(whyItStays(unknown)).toMatch(/nobody knows/);
});

it("is said with its share of the map", () => {
  expect(unknownSentence(0, true)).toBeNull();
  expect(unknownSentence(0.12345, true)).toBe("12.3 % of this map is unknown ground, without data: it bars the way.");
  expect(unknownSentence(0.0001, false)).toBe("Less than 0.1 % of this map is unknown ground, without data: it counts as free.");
});
