import { describe, expect, it } from "vitest";
import type { Units } from "../../src/domain/units";
import { arrivals, counted, figuresText, headline, noWay, proof, savedBy, tooEarly } from "../../src/mission/words";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 2.4, time: "seconds", seconds: 1 };
const plain = (text: string) => text.replaceAll(/[\u00a0\u202f]/g, " ");
const told = { units: city, buildings: true, isLooking: false };
const title = (wanted: Parameters<typeof planOf>[0]) => plain(headline(planOf(wanted), told).title);

describe("headline", () => {
  it("says what removals gain", () => {
    const words = headline(planOf({ removed: [4, 99], before: 1254.65, after: 975.05 }), told);
    expect(plain(words.title)).toBe("Removing 2 buildings gets the ground robot there 22 % sooner");
    expect(plain(figuresText(words.figures!, city))).toBe("16 min 15 s instead of 20 min 55 s");
    expect(words.tone).toBe("good");
    expect(title({ removed: [4], before: 100, after: 90 })).toBe(
      "Removing one building gets the ground robot there 10 % sooner",
    );
  });

  it("names the one whose arrival the figures are", () => {
    const late = planOf({ removed: [4], before: 100, after: 90, air: 95 });
    expect(plain(headline(late, told).title)).toMatch(/^Removing one building ends the mission/);
    expect(plain(arrivals(late, city)!)).toBe("The aircraft arrives last; the ground robot is there after 1 min 30 s.");
    const early = planOf({ removed: [4], before: 100, after: 90, air: 80 });
    expect(title({ removed: [4], before: 100, after: 90, air: 80 })).toContain("gets the ground robot there");
    expect(plain(arrivals(early, city)!)).toBe("The ground robot arrives last; the aircraft is there after 1 min 20 s.");
    const both = planOf({ removed: [4], before: 100, after: 90, air: 90.01 });
    expect(plain(headline(both, told).title)).toContain("gets the ground robot there");
    expect(arrivals(both, city)).toBe("Both arrive then.");
    const sum = planOf({ after: 90, air: 80, options: { objective: "flowtime" } });
    expect(plain(arrivals(sum, city)!)).toBe("The ground robot is there after 1 min 30 s, the aircraft after 1 min 20 s.");
    expect(arrivals(planOf({ after: null }), city)).toBeNull();
    const own = planOf({ removed: [4], before: 100, after: 90, air: 400, options: { objective: "ground-makespan" } });
    expect(plain(headline(own, told).title)).toBe("Removing one building gets the ground robot there 10 % sooner");
    expect(plain(arrivals(own, city)!)).toBe("The aircraft is there after 6 min 40 s.");
  });

  it("does not give the aircraft's time for the robot's where nothing is removed", () => {
    const words = planOf({ removed: [], before: 968, after: 251, air: 968, gap: 0, options: { removals: 2 } });
    words.after.makespan = 968;
    expect(headline(words, told)).toMatchObject({
      title: "No removal ends the mission sooner",
      figures: { after: 968, before: null },
    });
    expect(plain(arrivals(words, city)!)).toBe("The aircraft arrives last; the ground robot is there after 4 min 11 s.");
  });

  it("says that something opens a way that there is not without", () => {
    const words = headline(planOf({ removed: [4], before: null, after: 90 }), { ...told, buildings: false });
    expect(words.title).toBe("Removing one obstacle opens a way that there is not without");
    expect(plain(figuresText(words.figures!, city))).toBe("1 min 30 s");
  });

  describe("where removals gain next to nothing", () => {
    const words = (before: number, after: number, units = city) => headline(planOf({ removed: [4, 5], before, after }), { ...told, units });
    const isLed = (before: number, after: number, units = city) => words(before, after, units).title === "Removing nothing is as good";

    it("leads with removing nothing", () => {
      expect(words(100, 100)).toMatchObject({ tone: "plain", figures: { after: 100, before: null } });
      expect(plain(words(100, 100).note!)).toBe("Removing 2 buildings, as shown, gains nothing.");
      expect(plain(words(1446, 1445.1).note!)).toBe("Removing 2 buildings, as shown, gains 0.06 %.");
      expect(words(100, 90).note).toBeUndefined();
    });

    it("which is less than 0.1 %, or less than a second of more than a minute", () => {
      expect([isLed(7200, 7193), isLed(7200, 7192)]).toEqual([true, false]);
      expect([isLed(100, 99.1), isLed(100, 98.9)]).toEqual([true, false]);
      expect([isLed(30, 29.9), isLed(30, 29.98)]).toEqual([false, true]); // the tenth is told
      const steps: Units = { metric: false, cell: 1, time: "steps", seconds: 1 };
      expect([isLed(100, 99.5, steps), isLed(100, 99.95, steps)]).toEqual([false, true]);
    });

    it("and says what they do for the sum of all times", () => {
      const plan = planOf({ removed: [4], before: 968, after: 968 });
      plan.after.flowtime = 1800;
      expect(plain(headline(plan, told).note!)).toBe(
        "Removing one building, as shown, gains nothing, and takes 2 min 16 s off the sum of all times, 32 min 16 s.",
      );
    });
  });

  it("claims nothing that only the end of the search can say", () => {
    const looking = (wanted: Parameters<typeof planOf>[0]) => headline(planOf(wanted), { ...told, isLooking: true });
    expect(plain(looking({ removed: [4], before: 100, after: 90 }).title)).toBe(
      "So far, removing one building gets the ground robot there 10 % sooner",
    );
    expect(looking({ removed: [], gap: 0, options: { removals: 3 } }).title).toBe(
      "So far, no removal was found that gets the ground robot there sooner",
    );
    expect(looking({ after: null, status: "limit_reached" })).toMatchObject({ tone: "plain", title: "So far, no way was found", remedies: [] });
    const isFound = { ...told, isLooking: true, isFound: true };
    expect(headline(planOf({ after: null, status: "limit_reached" }), isFound).title).toBe("So far, a way was found that is not shown yet");
    expect(looking({ removed: [4], before: 100, after: 100 }).title).toBe("So far, removing nothing is as good");
  });

  it("says that there is no way without removals only where that is known", () => {
    const plan = { ...planOf({ removed: [4], before: null, after: 90 }), limit_reached: true };
    expect(headline(plan, told).title).toBe("Removing one building opens a way that was not found without");
    expect(noWay(plan)).toBe("none found");
    expect(noWay(planOf({ after: null }))).toBe("no way");
  });

  it("does not hide what costs", () => {
    const words = headline(planOf({ removed: [4], before: 100, after: 110 }), told);
    expect(words.tone).toBe("bad");
    expect(plain(words.title)).toContain("10 % later");
    const none = (gap: number | null) => title({ removed: [], gap, options: { removals: 3 } });
    expect(none(0)).toBe("No removal gets the ground robot there sooner");
    for (const gap of [0.02, null]) expect(none(gap)).toBe("No removal was found that gets the ground robot there sooner");
    expect(title({ removed: [], options: { removals: 0 } })).toContain("With nothing removed");
  });

  it("counts the sum of arrivals where that is wanted", () => {
    const words = headline(planOf({ removed: [4], before: 100, after: 90, options: { objective: "flowtime" } }), told);
    expect(words.figures).toEqual({ after: 180, before: 200 });
    expect(plain(words.title)).toContain("saves 10 %");
  });

  it("says what can be done where there is no plan", () => {
    const words = headline(planOf({ after: null, options: { removals: 2, protect: [4], radius: 0.5 } }), told);
    expect(words.title).toBe("The ground robot cannot get there, even with 2 buildings removed");
    expect(words.remedies.join(" ")).toMatch(/Allow more removals.*Move.*Protect fewer.*smaller robot/);
    expect(headline(planOf({ after: null, options: { removals: 8 } }), told).remedies).not.toContain(
      "Allow more removals.",
    );
    expect(title({ after: null, status: "limit_reached" })).toContain("in the time there was");
  });
});

describe("proof", () => {
  it("is said in words", () => {
    const text = (gap: number | null) => plain(proof(planOf({ gap }))!.text);
    expect(text(0)).toBe("Proven best possible");
    expect(text(0.0015)).toBe("Proven within 0.15 % of the best possible");
    expect(text(null)).toContain("Not proven");
    expect(text(0.024)).toBe("May be up to 2.4 % from the best possible");
    expect([0, 0.01, 0.0101, null].map((gap) => proof(planOf({ gap }))!.tone)).toEqual(["sure", "sure", "plain", "unsure"]);
    expect(proof(planOf({ after: null }))).toBeNull();
  });

  it("notices who drives in too early", () => {
    const plan = planOf({ removed: [1, 2], after: 90 });
    expect(tooEarly(plan)).toBe(0);
    plan.removed[1]!.entered_at = 3;
    expect(tooEarly(plan)).toBe(1);
    plan.removed[0]!.entered_at = null;
    expect(tooEarly(plan)).toBe(1);
  });
});

it("counts", () => {
  expect([0, 1, 2].map((n) => counted(n, true))).toEqual(["no buildings", "one building", "2 buildings"]);
});

it("what is saved is the difference of the figures shown", () => {
  const plan = planOf({ removed: [1], before: 930.6, after: 860.4 });
  expect(plain(figuresText({ after: 860.4, before: 930.6 }, city))).toBe("14 min 20 s instead of 15 min 31 s");
  expect(plain(savedBy(plan, city)!)).toBe("1 min 11 s");
  expect(savedBy(planOf({ removed: [1], before: 90, after: 90 }), city)).toBeNull();
  expect(plain(figuresText({ after: 6225, before: 6252 }, city))).toBe("1 h 43 min 45 s instead of 1 h 44 min 12 s");
});
