import { describe, expect, it } from "vitest";
import { type Agents, changed, joined, pair } from "../../../src/domain/agents";
import { overlap, type Point } from "../../../src/domain/geometry";
import { spotAt, spots } from "../../../src/map/layers/marker_spots";
import { placed } from "../../../src/map/layers/team_markers";

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
    for (const id of ["air2", "air3"]) agents = joined(agents, { kind: "air", id, start: null, goal: null, speed: 1, breaches: null });
    for (const { agent, handle, at: point } of spots(agents, toPixels)) expect(at(agents, point)).toBe(`${agent.id} ${handle.end}`);
  });
});

describe("names in markers", () => {
  it("never cover each other, and stay near their places", () => {
    const wanted = Array.from({ length: 200 }, (_, i) => ({
      at: [(i * 37) % 400, (i * 53) % 300] as Point,
      width: 20 + (i % 5) * 8,
    }));
    const boxes = placed(wanted);
    const shown = boxes.filter((box) => box !== null);
    shown.forEach((one, i) => shown.slice(0, i).forEach((other) => expect(overlap(one, other)).toBe(false)));
    expect(boxes[0]).toEqual({ left: -10, top: -10, right: 10, bottom: 10 });
    expect(shown.length).toBeGreaterThan(60);
  });

  it("keep their places where there is room", () => {
    const wanted = [[0, 0], [40, 0], [0, 40]].map((point) => ({ at: point as Point, width: 20 }));
    expect(placed(wanted).map((box) => [box!.left + 10, box!.top + 10])).toEqual([[0, 0], [40, 0], [0, 40]]);
  });
});
