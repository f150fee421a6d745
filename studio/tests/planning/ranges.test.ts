// What is asked otherwise where a battery ends.
import { expect, it } from "vitest";
import { changed } from "../../src/domain/agents";
import { freshMission } from "../../src/domain/mission";
import { canKeep, hasReasons, type Question, questionOf } from "../../src/planning/request";
import { planOf } from "../domain/plans";

const grid = { metric: false, cell: 1, time: "steps", seconds: 1 } as const;
const fresh = freshMission("m", { start: [0, 0], goal: [9, 9] });
const limited = { ...fresh, agents: changed(fresh.agents, 1, { range: 40, reserve: 0.1 }) };
const asked = (mission: typeof fresh, removals: Question["removals"] = 2) => questionOf({ ...mission, removals }, grid, "m", (key) => key);

it("asks for the battery", () => {
  expect(asked(limited).mission.agents[1]).toMatchObject({ range: 40, reserve: 0.1 });
  expect(asked(fresh).mission.agents[1]).toEqual({ id: "air", kind: "air", start: [0, 0], goal: [9, 9], speed: 1 });
});

it("keeps no removal for a draft that may be too far from another start", () => {
  expect(canKeep(asked(fresh))).toBe(true);
  expect(canKeep(asked(limited))).toBe(false);
});

it("asks what is out of range, also where nothing is removed", () => {
  const [none, some] = [planOf({}), planOf({ removed: [4] })];
  expect(hasReasons(asked(fresh), none)).toBe(false);
  expect(hasReasons(asked(fresh), some)).toBe(true);
  expect(hasReasons(asked(limited), none)).toBe(true);
  expect(hasReasons(asked(limited, 0), none)).toBe(false);
  expect(hasReasons(asked(limited, "auto"), none)).toBe(false);
});
