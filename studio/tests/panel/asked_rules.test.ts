// The rules of a plan in words.
import { describe, expect, it } from "vitest";
import type { Plan } from "../../src/domain/plan";
import { askedRules } from "../../src/panel/asked_rules";

function planOf(options: object, rules?: object): Plan {
  return { options, ...(rules && { mission: { agents: [], rules } }) } as unknown as Plan;
}

describe("the rules that were asked for", () => {
  it("are said where there are any", () => {
    expect(askedRules(planOf({ removals: 2, protect: [], force: [] }, { removals: 2 }))).toBeNull();
    expect(askedRules(planOf({ budget_m2: 300 }, { budget_m2: 300, protect: [1, 2] }))).toBe(
      "at most 300\u00a0m² demolished; 2 obstacles protected",
    );
    expect(askedRules(planOf({ budget: 12 }))).toBe("removals that weigh at most 12");
    expect(askedRules(planOf({}, { minimise_demolition: 0.05, force: [4] }))).toBe(
      "the least demolition within 5 % of the best plan; 1 obstacle to be removed",
    );
    expect(askedRules(planOf({}, { collisions: false }))).toBe("vehicles pass through each other");
    expect(askedRules(planOf({}, { minimise_demolition: 0 }))).toBe("of the best plans the one that demolishes least");
  });
});
