import { describe, expect, it } from "vitest";
import { pathOf, positionAtTime, retimed } from "../../src/rehearse/retimed";
import { yard } from "./yard";

const paths = (agent: string, from: number, by: number) => {
  const all = retimed(yard(), agent, from, by);
  return Object.fromEntries([...all].map(([id, stops]) => [id, pathOf(stops)]));
};

describe("a plan whose vehicle is late", () => {
  it("is as it was where nobody is", () => {
    const { agents } = yard();
    expect(paths("rover", 3, 0)).toEqual(Object.fromEntries(agents.map(({ id, path }) => [id, id === "rover" ? [[0, 0, 0], [3, 0, 3], [4, 0, 4], ...path.slice(2)] : path])));
  });

  it("loses no more time than its waits do not make up for", () => {
    expect(paths("rover", 2, 5).rover).toEqual([[0, 0, 0], [2, 0, 2], [2, 0, 7], [4, 0, 9], [4, 0, 10], [12, 0, 18]]);
    expect(paths("rover", 2, 8).rover!.at(-1)).toEqual([12, 0, 20]);
  });

  it("works as long as it takes where it opens its own way", () => {
    const [rover] = yard().agents;
    const own = { ...rover!, waits: [{ at: [4, 0] as [number, number], from: 4, until: 10, reason: "opening" as const, obstacle: 7, agent: "rover" }] };
    const late = retimed({ ...yard(), agents: [own], orders: [] }, "rover", 2, 5);
    expect(pathOf(late.get("rover")!)).toEqual([[0, 0, 0], [2, 0, 2], [2, 0, 7], [4, 0, 9], [4, 0, 15], [12, 0, 23]]);
  });

  it("puts off who may not go before it, and nobody else", () => {
    const { rover, truck, drone } = paths("rover", 9, 10);
    expect(rover!.at(-1)).toEqual([12, 0, 27]);
    expect(truck).toEqual([[0, 4, 0], [4, 4, 4], [4, 4, 12], [4, 0, 16], [4, 0, 21], [12, 0, 29]]);
    expect(drone).toEqual(yard().agents[2]!.path);
  });

  it("leaves a plan be that is ahead of an order by a little", () => {
    const plan = yard();
    const ahead = { ...plan, orders: [{ ...plan.orders![1]!, before: { agent: "rover", point: 3 }, slack: -2 }] };
    expect(pathOf(retimed(ahead, "drone", 1, 0).get("truck")!)).toEqual(plan.agents[1]!.path);
  });

  it("ends even where orders wait for each other in a circle", () => {
    const [one] = yard().orders!;
    const circle = { ...yard(), orders: [...yard().orders!, { ...one!, before: { agent: "truck", point: 4 }, after: { agent: "rover", point: 2 }, slack: 0 }] };
    expect(retimed(circle, "rover", 1, 1).size).toBe(3);
  });
});

it("says where on a path an agent is", () => {
  const path = yard().agents[0]!.path;
  expect([0, 2, 4, 7, 10, 14, 18, 99].map((time) => positionAtTime(path, time))).toEqual([0, 0.5, 1, 1, 2, 2.5, 3, 3]);
});
