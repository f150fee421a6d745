import { expect, it } from "vitest";
import { spread } from "../../src/play/spread";
import { Random } from "../mission/random";

it("leaves what has room, and puts side by side what has none", () => {
  expect(spread([10, 40, 80], 17)).toEqual([10, 40, 80]);
  expect(spread([40, 40], 17)).toEqual([31.5, 48.5]);
  expect(spread([40, 10, 42], 17)).toEqual([32.5, 10, 49.5]);
  expect(spread([0, 10, 20, 60], 17)).toEqual([-7, 10, 27, 60]);
  expect(spread([], 17)).toEqual([]);
});

it("never puts two nearer to each other than asked, keeps their order, and moves nothing without need", () => {
  const random = new Random(7);
  for (let round = 0; round < 200; ++round) {
    const wanted = Array.from({ length: 1 + random.below(9) }, () => 300 * random.next());
    const places = spread(wanted, 17);
    const order = wanted.map((_, i) => i).sort((a, b) => wanted[a]! - wanted[b]!);
    order.slice(1).forEach((i, k) => expect(places[i]! - places[order[k]!]!).toBeGreaterThan(17 - 1e-9));
    const mean = (of: number[]) => of.reduce((sum, at) => sum + at, 0) / of.length;
    expect(mean(places)).toBeCloseTo(mean(wanted), 6);
  }
});
