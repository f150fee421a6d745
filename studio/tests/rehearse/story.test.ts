import { describe, expect, it } from "vitest";
import type { Cell } from "../../src/domain/geometry";
import type { Plan, Recharge } from "../../src/domain/plan";
import { activityAt } from "../../src/play/activity";
import { Story } from "../../src/play/story";
import { pathOf, retimed } from "../../src/rehearse/retimed";
import { storyOf } from "../../src/rehearse/story";
import { roundTheWall, yard } from "./yard";

const none = new Map();

describe("the story of a mission", () => {
  it("is what was done until now, and then the revision", () => {
    const story = storyOf({ before: yard(), driven: none, next: roundTheWall(10, 34), now: 10, failed: 7 });
    expect(story.agents[0]!.path).toEqual([[0, 0, 0], [4, 0, 4], [4, 0, 10], [4, 8, 18], [12, 8, 26], [12, 0, 34]]);
    expect(story.agents[1]!.path).toEqual([[0, 4, 0], [4, 4, 4], [4, 4, 10], [12, 0, 19]]);
    expect(story.after.makespan).toBe(34);
    expect(story.removed).toEqual([]);
  });

  it("ends for who is lost where that was, and for all where no plan is left", () => {
    const story = storyOf({ before: yard(), driven: none, next: roundTheWall(3, 30), now: 3, failed: null });
    expect(story.agents[2]!.path).toEqual([[0, 2, 0], [3, 2, 3]]);
    expect(story.agents.map(({ lost = false }) => lost)).toEqual([false, false, true]);
    expect(activityAt(new Story(story), 5)).toMatch(/drone is lost/);
    const end = storyOf({ before: yard(), driven: none, next: null, now: 3, failed: null });
    expect(end.agents.map(({ path }) => path.at(-1))).toEqual([[3, 0, 3], [3, 4, 3], [3, 2, 3]]);
  });

  it("keeps what is open, and what is being opened", () => {
    const next = roundTheWall(8, 30);
    const working = { ...next, mission: { agents: [], rules: { opened: [{ obstacle: 7, at: 10 }] } } };
    const story = (now: number, plan: typeof next) => storyOf({ before: yard(), driven: none, next: plan, now, failed: null });
    expect(story(8, working).removed.map(({ obstacle, cleared_at }) => [obstacle, cleared_at])).toEqual([[7, 10]]);
    expect(story(8, next).removed).toEqual([]);
    expect(story(12, next).removed.map(({ entered_at }) => entered_at)).toEqual([11]);
    const again = { ...next, removed: yard().removed };
    expect(story(12, again).removed).toHaveLength(1);
  });

  it("keeps where an aircraft has recharged, and has it go on where it does", () => {
    const one = (at: Cell, from: number, until: number): Recharge => ({ at, from, until, flown: 5 });
    const told = (before: Recharge[], after: Recharge[], now: number) => {
      const landing = (recharges: Recharge[]): Plan => ({ ...yard(), agents: [{ ...yard().agents[2]!, recharges }] });
      return storyOf({ before: landing(before), driven: none, next: landing(after), now, failed: null }).agents[0]!.recharges;
    };
    const [past, under, later] = [one([4, 4], 1, 3), one([6, 4], 5, 9), one([4, 4], 12, 14)];
    expect(told([past, under, later], [], 8)).toEqual([past, { ...under, until: 8 }]);
    expect(told([past, under], [{ ...one([6, 4], 8, 9), flown: 0 }, later], 8)).toEqual([past, under, later]);
    expect(told([past], [later], 8)).toEqual([past, later]);
    expect(told([later], [], 8)).toEqual([]);
  });

  it("has a late vehicle stand where it stood", () => {
    const late = retimed(yard(), "rover", 2, 5);
    const driven = new Map([...late].map(([id, stops]) => [id, pathOf(stops)]));
    const next = { ...roundTheWall(7, 30), agents: [{ ...yard().agents[0]!, path: [[2, 0, 7], [12, 0, 17]] as [number, number, number][] }] };
    const story = storyOf({ before: yard(), driven, next, now: 7, failed: null });
    expect(story.agents[0]!.path).toEqual([[0, 0, 0], [2, 0, 2], [2, 0, 7], [12, 0, 17]]);
  });
});
