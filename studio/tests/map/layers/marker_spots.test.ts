import { describe, expect, it } from "vitest";
import { type Agents, changed, joined, pair, usualAircraft, usualVehicle } from "../../../src/domain/agents";
import { overlap, type Point } from "../../../src/domain/geometry";
import { beside, Boxes } from "../../../src/map/layers/free_places";
import { halo, keptClear, type Spot, spotAt, spots } from "../../../src/map/layers/marker_spots";
import { draws } from "../../domain/picture";

const toPixels = ([x, y]: Point): Point => [10 * x, 10 * y];
const at = (agents: Agents, point: Point) => {
  const spot = spotAt(spots(agents, toPixels), point);
  return spot && `${spot.agent.id} ${spot.handle.end}`;
};

describe("markers", () => {
  it("are met where they are drawn, the nearest first", () => {
    const agents = changed(pair([10, 10], [13, 10]), 1, { start: [50, 50] });
    expect(at(agents, [103, 99])).toBe("ground start");
    expect(at(agents, [127, 104])).toBe("ground goal");
    expect(at(agents, [505, 510])).toBe("air start");
    expect(at(agents, [300, 300])).toBeNull();
  });

  it("have a handle beside them for the air agent that starts there", () => {
    const agents = pair([10, 10], [60, 60]);
    const air = spots(agents, toPixels).find(({ agent, handle }) => agent.kind === "air" && handle.end === "start")!;
    expect(air.attached).toBe(true);
    expect(at(agents, air.at)).toBe("air start");
    expect(at(agents, [100, 100])).toBe("ground start");
  });

  it("of a team that stand at one place can all be met", () => {
    let agents = pair([10, 10], [60, 60]);
    for (const id of ["air2", "air3"]) agents = joined(agents, { kind: "air", id, ...usualAircraft });
    for (const { agent, handle, at: point } of spots(agents, toPixels)) expect(at(agents, point)).toBe(`${agent.id} ${handle.end}`);
  });

  it("never cover each other, wherever they stand, and all can be met", () => {
    const random = draws(7);
    const upTo = (most: number) => Math.floor(random() * most);
    for (let trial = 0; trial < 300; ++trial) {
      const side = 1 + upTo(30); // cells of 10 pixels: from all at one place to some room
      const cell = (): [number, number] => [upTo(side), upTo(side)];
      let agents = pair(cell(), cell());
      const more = trial % 3 === 0 ? 0 : upTo(12);
      for (let i = 0; i < more; ++i) {
        const own = { start: random() < 0.5 ? null : cell(), goal: random() < 0.5 ? null : cell() };
        const id = `agent${upTo(1000)}`.slice(0, 1 + upTo(8)) + i;
        const air = { kind: "air", id, ...usualAircraft, ...own } as const;
        agents = joined(agents, random() < 0.5 ? air : { ...usualVehicle, kind: "ground", id, start: cell(), goal: cell() });
      }
      const all = spots(agents, toPixels);
      const two = agents.length === 2;
      const apart = two ? Math.min(...pairsOf(all).map(([a, b]) => between(a, b))) : Infinity;
      expect(apart).toBeGreaterThanOrEqual(0);
      if (!two) expect(pairsOf(all).filter(([a, b]) => overlap(a.box, b.box))).toEqual([]);
      for (const { agent, handle, at: point } of all) expect(at(agents, point)).toBe(`${agent.id} ${handle.end}`);
      if (!two) expect(all.filter(({ named, handle }) => !named && handle.end === "start")).toEqual([]);
    }
  });

  it("of a vehicle that starts beside another are not hidden by the aircraft of that one", () => {
    let agents = pair([10, 10], [60, 10]);
    agents = joined(agents, { ...usualVehicle, kind: "ground", id: "2", start: [11, 8], goal: [59, 8] });
    agents = joined(agents, { kind: "air", id: "air2", ...usualAircraft });
    const all = spots(agents, toPixels);
    expect(pairsOf(all).filter(([a, b]) => overlap(a.box, b.box))).toEqual([]);
    const first = all.find(({ agent, handle }) => agent.id === "1" && handle.end === "start")!;
    expect(first.at).toEqual([100, 100]);
  });

  it("stand at their places where there is room", () => {
    let agents = pair([0, 0], [40, 40]);
    agents = joined(agents, { ...usualVehicle, kind: "ground", id: "2", start: [5, 0], goal: [0, 5] });
    for (const { place, at: point, attached } of spots(agents, toPixels)) if (!attached) expect(point).toEqual(place);
  });

  it("of thousands keep their places where they have no room", () => {
    let agents = pair([0, 0], [40, 40]);
    agents = joined(agents, { ...usualVehicle, kind: "ground", id: "2", start: [5, 0], goal: [0, 5] });
    const vehicle = agents[0]!;
    const many = Array.from({ length: 5000 }, (_, i) => ({ ...vehicle, id: `v${i}`, start: [i % 70, i % 71] as [number, number] }));
    const all = spots(many as Agents, toPixels, { first: 4999 });
    expect(all.length).toBe(10000);
    expect(all.find(({ handle }) => handle.agent === 4999)!.named).toBe(true);
    for (const { named, handle, at: point, place } of all) {
      if (!named && handle.end === "start") expect(point).toEqual(place);
    }
  });

  it("keep badges off all that they cover", () => {
    const box = { left: 0, top: 0, right: 80, bottom: 20 };
    const wide = { ...spots(pair([0, 0], [9, 9]), toPixels)[0]!, box, at: [40, 10] as Point };
    const xs = keptClear([wide]).map(([x]) => x);
    expect([xs[0], xs.at(-1)]).toEqual([10, 70]);
    xs.slice(1).forEach((x, i) => expect(x - xs[i]!).toBeLessThanOrEqual(20));
  });
});

describe("what stands beside a place", () => {
  it("covers neither a marker nor what stands there already", () => {
    const taken = new Boxes();
    taken.add({ left: 60, top: 90, right: 140, bottom: 110 }); // a name at the place
    const made = Array.from({ length: 6 }, () => taken.take(beside([100, 100], 60, 22), 60, 22)!);
    made.forEach((one, i) => {
      expect(overlap(one, { left: 60, top: 90, right: 140, bottom: 110 })).toBe(false);
      made.slice(0, i).forEach((other) => expect(overlap(one, other)).toBe(false));
    });
  });

  it("is to the left where there is room", () => {
    expect(new Boxes().take(beside([100, 100], 60, 22), 60, 22)).toEqual({ left: 26, top: 89, right: 86, bottom: 111 });
  });
});

function pairsOf(all: readonly Spot[]): [Spot, Spot][] {
  return all.flatMap((one, i) => all.slice(0, i).map((other): [Spot, Spot] => [one, other]));
}

// Of the discs of a pair.
function between(a: Spot, b: Spot): number {
  const radius = ({ box }: Spot) => (box.right - box.left) / 2 - halo;
  return Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1]) - radius(a) - radius(b);
}
