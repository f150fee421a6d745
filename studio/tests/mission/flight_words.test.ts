import { expect, it } from "vitest";
import type { Plan, Recharge } from "../../src/domain/plan";
import type { Units } from "../../src/domain/units";
import { landings, refusalWords, tooFar, whyTooFar } from "../../src/mission/flight_words";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 2, time: "seconds", seconds: 1 };
const grid: Units = { metric: false, cell: 1, time: "steps", seconds: 1 };
const plain = (text: string | null) => text?.replaceAll(/[\u00a0\u202f]/g, " ") ?? null;
const named = (id: number) => `Section ${id}`;

function flown(battery: object, far: Plan["out_of_range"] = []): Plan {
  const plan = planOf({ after: 100, air: 100 });
  plan.agents[1]!.speed = 3;
  plan.mission = { agents: [{ id: "ground" }, { id: "air", ...battery }] };
  return { ...plan, out_of_range: far };
}

const landed = (battery: object, units = city) => landings(flown(battery), flown(battery).agents[1]!, units).map(plain).join(". ");

it("says what an aircraft lands with", () => {
  expect(landed({ range: 500 })).toBe("lands with 400 m of 1000 m left");
  expect(landed({ range: 500 }, grid)).toBe("lands with 200 cells of 500 cells left");
  expect(landed({ range: 500, reserve: 0.2 })).toBe("lands with 400 m of 1000 m left; 20 % are to be in reserve");
  expect(landed({ endurance: 160 })).toBe("lands with 1 min of 2 min 40 s left");
  expect(landed({ range: 500, endurance: 160 })).toBe("lands with 400 m of 1000 m and 1 min of 2 min 40 s left");
  expect(landed({ endurance: 160, ready_at: 40 })).toBe("lands with 1 min 40 s of 2 min 40 s left");
  expect(landed({ range: 300 })).toBe("lands with 0 m of 600 m left");
  expect(landed({})).toBe("");
  expect(landings(flown({ range: 500 }), flown({}).agents[0]!, city)).toEqual([]);
});

it("says where an aircraft recharges, and counts since then", () => {
  const told = (battery: object, ...recharges: Recharge[]) => {
    const plan = flown(battery);
    return landings(plan, { ...plan.agents[1]!, recharges }, city).map(plain);
  };
  const first: Recharge = { at: [4, 0], from: 20, until: 50, flown: 20 };
  expect(told({ range: 500, endurance: 160, reserve: 0.2, ready_at: 10, flown: 10 }, first)).toEqual([
    "recharges at 4,0 for 30 s, with 880 m of 1000 m and 2 min 20 s of 2 min 40 s left",
    "lands with 700 m of 1000 m and 1 min 50 s of 2 min 40 s left; 20 % are to be in reserve",
  ]);
  expect(told({ endurance: 60 }, first, { at: [9, 0], from: 80, until: 90, flown: 30 })).toEqual([
    "recharges at 4,0 for 30 s, with 40 s of 1 min left",
    "recharges at 9,0 for 10 s, with 30 s of 1 min left",
    "lands with 50 s of 1 min left",
  ]);
});

it("says what is out of range", () => {
  const far = { agent: "air", longest: 400 / 3, flight: 440 / 3 };
  const plan = flown({ range: 500, reserve: 0.2 }, [{ ...far, obstacle: 607 }, { ...far, obstacle: 520, flight: 300 }]);
  expect(tooFar(plan, city).map(({ can }) => plain(can))).toEqual(["the aircraft can fly 800 m with 20 % in reserve"]);
  expect(tooFar(plan, city)[0]!.obstacles.map(({ id, needs }) => [id, plain(needs)])).toEqual([
    [607, "there and back is 880 m"],
    [520, "there and back is 1800 m"],
  ]);
  expect(plain(whyTooFar(plan, 607, city))).toBe("Out of range: the aircraft can fly 800 m with 20 % in reserve; there and back is 880 m.");
  expect(whyTooFar(plan, 608, city)).toBeNull();
  const timed = flown({ range: 5000, endurance: 90 }, [{ agent: "air", obstacle: 7, longest: 90, flight: 120 }]);
  expect(plain(whyTooFar(timed, 7, city))).toBe("Out of range: the aircraft can fly for 1 min 30 s; there and back takes 2 min.");
  const near = flown({ range: 500 }, [{ agent: "air", obstacle: 7, longest: 500 / 3, flight: 500.1 / 3 }]);
  expect(plain(whyTooFar(near, 7, city))).toBe("Out of range: the aircraft can fly 1000 m; there and back is a little more.");
  expect(tooFar(flown({}), city)).toEqual([]);
});

it("says why a mission is refused, in the page's units", () => {
  const said = (message: string) => plain(refusalWords(message, city, named));
  expect(said("The air agent can fly 250 cells; from its start to its goal it is 336.001.")).toBe(
    "The aircraft can fly 500 m; from its start to its goal it is 672 m.",
  );
  expect(said("Obstacle 520 must be removed, but the heli; 2 agent can fly 400 cells, with 20 % in reserve; obstacle 520 and back is 650.6.")).toBe(
    "Section 520 must be removed, but heli; 2 can fly 800 m with 20 % in reserve; there and back is 1301 m.",
  );
  expect(said("Obstacle 520 must be removed, but no agent can breach it.")).toBe("Section 520 must be removed, but nobody here opens it.");
  expect(said("The air agent can fly for 300 units of time; from its start to its goal it takes 806.4.")).toBe(
    "The aircraft can fly for 5 min; from its start to its goal it takes 13 min 26 s.",
  );
  const away = "send it to a nearer goal, or report it as lost";
  expect(said(`The air agent can still fly 5 cells; from where it is to its goal it is 6: ${away}.`)).toBe(
    `The aircraft can still fly 10 m; from where it is to its goal it is 12 m: ${away}.`,
  );
  expect(said("The air agent cannot fly.")).toBe("The air agent cannot fly.");
});
