import { describe, expect, it } from "vitest";
import type { Plan, Surface } from "../../src/domain/plan";
import type { Units } from "../../src/domain/units";
import { surfaceWords } from "../../src/mission/surface_words";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 2, time: "seconds", seconds: 1 };

function driven(...surfaces: (Surface | undefined)[]): Plan {
  const plan = planOf({ after: 90 });
  const [ground, air] = plan.agents;
  const agents = [...surfaces.map((surface) => ({ ...ground!, ...(surface && { surface }) })), air!];
  const team = surfaces.length > 1;
  return { ...plan, agents, after: { ...plan.after, ...(team && { routes: [] }) } };
}

const words = (plan: Plan) => surfaceWords(plan, city)?.replaceAll("\u00a0", " ");

describe("what vehicles drive over", () => {
  it("is one sentence in metres", () => {
    const plan = driven({ ways: 590, off_ways: 32, unknown: 0, near_water: 20 });
    expect(words(plan)).toBe("The ground robot drives 1180 m on ways, 64 m off ways; 40 m within 5 m of water.");
  });

  it("says what is unknown, and nothing of water that is not near", () => {
    expect(words(driven({ ways: 5, off_ways: 0, unknown: 7, near_water: 0.2 }))).toBe(
      "The ground robot drives 10 m on ways, 0 m off ways, 14 m on unknown ground.",
    );
    expect(words(driven({ ways: 5, off_ways: 0, unknown: 0 }))).toBe("The ground robot drives 10 m on ways, 0 m off ways.");
  });

  it("is the sum of a team", () => {
    const one = { ways: 10, off_ways: 1, unknown: 0, near_water: 2 };
    expect(words(driven(one, one))).toBe("The vehicles drive 40 m on ways, 4 m off ways; 8 m within 5 m of water.");
  });

  it("is not said where the map does not know", () => {
    expect(words(driven(undefined))).toBeUndefined();
  });
});
