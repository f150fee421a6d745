import { expect, it } from "vitest";
import { cellAhead, usualDelays } from "../../src/rehearse/choices";
import { yard } from "./yard";

it("offers a short delay and a long one, in round numbers", () => {
  expect(usualDelays(851, 1)).toEqual([30, 120]);
  expect(usualDelays(24, 1)).toEqual([1, 2]);
  expect(usualDelays(8, 1)).toEqual([1]);
  expect(usualDelays(425.5, 2)).toEqual([15, 60]); // the plan's unit is two seconds
});

it("drops rubble ahead on the way, past waits and around bends", () => {
  const [rover, truck] = yard().agents;
  expect(cellAhead(rover!, 2, 5)).toEqual([7, 0]);
  expect(cellAhead(truck!, 2, 5)).toEqual([4, 1]);
  expect(cellAhead(rover!, 16, 5)).toBeNull();
  expect(cellAhead({ path: [] }, 0, 1)).toBeNull();
});
