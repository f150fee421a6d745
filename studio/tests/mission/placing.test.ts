import { describe, expect, it } from "vitest";
import { type Agents, changed, joined, pair, usualAircraft, vehiclesOf } from "../../src/domain/agents";
import type { Cell } from "../../src/domain/geometry";
import { oneAircraftMore, oneVehicleMore } from "../../src/mission/placing";
import { mapOf } from "../domain/picture";

const open = mapOf(...Array.from({ length: 40 }, () => ".".repeat(40)));

describe("one vehicle more", () => {
  it("has room beside all others, start and goal", () => {
    let agents: Agents = pair([5, 5], [30, 30]);
    for (let i = 0; i < 12; ++i) agents = joined(agents, oneVehicleMore(agents, open, 0.5)!);
    const vehicles = vehiclesOf(agents);
    expect(vehicles.map(({ id }) => id)).toEqual(Array.from({ length: 13 }, (_, i) => String(i + 1)));
    for (const end of ["start", "goal"] as const) {
      vehicles.forEach(({ [end]: [x, y] }, i) =>
        vehicles.slice(0, i).forEach(({ [end]: [ox, oy] }) => expect(Math.hypot(x - ox, y - oy)).toBeGreaterThanOrEqual(1.5)),
      );
    }
  });

  it("stands where the last one can get to, clear of walls", () => {
    const yard = mapOf("..aaaaa", "..a...a", "..a...a", "..aaaaa", ".......");
    const one = oneVehicleMore(pair([0, 0], [6, 4]), yard, 0)!;
    for (const [x, y] of [one.start, one.goal]) {
      expect(yard.at(x, y)).toBe(0);
      expect(x >= 3 && x <= 5 && y >= 1 && y <= 2).toBe(false);
    }
    const wide = pair([1, 1], [1, 1]).map((agent) => (agent.kind === "ground" ? { ...agent, radius: 1.5 } : agent));
    expect(oneVehicleMore(wide, mapOf("...", "...", "..."), 0)).toBeNull();
  });
});

it("one aircraft more has the battery of the last one, and its bases", () => {
  const battery = { range: 900, endurance: 60, reserve: 0.2, recharge: 300, bases: [[4, 5]] satisfies Cell[] };
  const agents = changed(pair([1, 1], [8, 8]), 1, { ...battery, breaches: 2, start: [3, 3] });
  expect(oneAircraftMore(agents)).toMatchObject({ ...battery, breaches: null, start: null });
  expect(oneAircraftMore([])).toMatchObject(usualAircraft);
});
