import { expect, it } from "vitest";
import { agentDocuments, agentsOf } from "../../src/domain/agent_document";
import { type Aircraft, basesOf, canOpen, drivesAlone, isPair, joined, onItsOwn, pair, usualAircraft, usualVehicle, type Vehicle } from "../../src/domain/agents";

const robot = onItsOwn(pair([1, 2], [8, 2]), 3);
const another: Vehicle = { kind: "ground", id: "2", start: [1, 5], goal: [8, 5], ...usualVehicle };
const aircraft: Aircraft = { kind: "air", id: "air", ...usualAircraft };

it("a robot that breaches clears for a vehicle that joins it", () => {
  const crew = joined(robot, another);
  expect(crew.map(({ breaches }) => breaches)).toEqual([3, 0]);
  expect(canOpen(crew)).toBe(true);
  const documents = agentDocuments(crew, 1);
  expect(documents.map(({ breaches }) => breaches)).toEqual([3, undefined]);
  expect(agentsOf(documents, { cell: 1, seconds: 1 })).toEqual(crew);
});

it("an aircraft takes the breaches of a robot over that is alone", () => {
  const both = joined(robot, aircraft);
  expect(both.map(({ breaches }) => breaches)).toEqual([0, null]);
  expect(isPair(both)).toBe(true);
});

it("a vehicle that breaches and an aircraft are no pair", () => {
  const crew = [...robot, aircraft];
  expect(isPair(crew)).toBe(false);
  expect(drivesAlone({ agents: crew, unreached: null })).toBe(false);
});

it("bases are those of aircraft that recharge, each place once", () => {
  const drone: Aircraft = { ...aircraft, id: "drone", endurance: 60, recharge: 30, bases: [[1, 2], [3, 4]] };
  const others: Aircraft[] = [
    { ...drone, id: "a", bases: [[3, 4], [5, 6]] },
    { ...drone, id: "b", recharge: null, bases: [[7, 7]] },
    { ...drone, id: "c", endurance: null, bases: [[8, 8]] },
  ];
  expect(basesOf([...robot, drone, ...others])).toEqual([[1, 2], [3, 4], [5, 6]]);
  expect(basesOf(robot)).toEqual([]);
});
