import { expect, it } from "vitest";
import { usualAbilities } from "../../src/domain/abilities";
import { changed, type MissionAgent, pair } from "../../src/domain/agents";
import { abilityWords, onlyWords, whyNobodyOpens } from "../../src/mission/ability_words";
import { mapOf } from "../domain/picture";

const city = { metric: true, cell: 2, time: "seconds", seconds: 1 } as const;
const grid = { metric: false, cell: 1, time: "steps", seconds: 1 } as const;
const plain = (text: string | null) => text?.replaceAll(/[\u00a0\u202f]/g, " ");

it("says what an agent opens", () => {
  const said = (part: object, units: typeof city | typeof grid = city) => plain(abilityWords({ ...usualAbilities, ...part }, units));
  expect(said({})).toBe("anything");
  expect(said({ mostArea: 300 })).toBe("up to 300 m²");
  expect(said({ mostArea: 60 }, grid)).toBe("up to 60 cells");
  expect(said({ mostArea: 300, only: [17], breachTimePerCell: 0 })).toBe("up to 300 m², only what is named, in its own time");
  expect(said({ only: [], breachTime: 5 })).toBe("nothing");
});

it("names what alone it opens", () => {
  expect(onlyWords([17, 20, "barrier"])).toBe("Only obstacles 17, 20 and barrier");
  expect(onlyWords([17])).toBe("Only obstacle 17");
  expect(onlyWords([17, "barrier"])).toBe("Only obstacle 17 and barrier");
  expect(onlyWords(["barrier", "building=garage,shed"])).toBe("Only barrier and building=garage,shed");
  expect(onlyWords([])).toBe("No obstacle");
  const many = onlyWords(Array.from({ length: 15 }, (_, i) => i + 1));
  expect(many).toBe("Only obstacles 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 3 more");
});

it("says why nobody opens an obstacle", () => {
  const [block, hut] = mapOf("aaa.b", "aaa..").obstacles;
  const why = (part: Partial<MissionAgent>, one = block!) => whyNobodyOpens(changed(pair([0, 0], [4, 1]), 1, part as object), one, city);
  expect(why({})).toBeNull();
  expect(why({ mostArea: 20 })).toBe("Too large for all who open the way here.");
  expect(why({ mostArea: 20 }, hut)).toBeNull();
  expect(why({ only: [2] })).toBe("Not among what anybody here opens.");
  expect(why({ only: [2] }, hut)).toBeNull();
  expect(why({ only: [2], breaches: 0 })).toBeNull(); // nobody opens anything: that is said elsewhere
  const both = changed(changed(pair([0, 0], [4, 1]), 0, { breaches: 1 }), 1, { only: [2] });
  expect(whyNobodyOpens(both, block!, city)).toBeNull();
});
