import { describe, expect, it } from "vitest";
import type { Point } from "../../../src/domain/geometry";
import { spotAt, spots } from "../../../src/map/layers/marker_spots";

const toPixels = ([x, y]: Point): Point => [10 * x, 10 * y];

describe("markers", () => {
  it("are met where they are drawn, the nearest first", () => {
    const all = spots({ start: [10, 10], goal: [13, 10], air_start: [50, 50] }, toPixels);
    expect(spotAt(all, [103, 99])?.handle).toBe("start");
    expect(spotAt(all, [127, 104])?.handle).toBe("goal");
    expect(spotAt(all, [505, 510])?.handle).toBe("air_start");
    expect(spotAt(all, [300, 300])).toBeNull();
  });

  it("have a handle beside them for the air agent that starts there", () => {
    const all = spots({ start: [10, 10], goal: [60, 60] }, toPixels);
    const air = all.find(({ handle }) => handle === "air_start")!;
    expect(air.attached).toBe(true);
    expect(spotAt(all, air.at)?.handle).toBe("air_start");
    expect(spotAt(all, [100, 100])?.handle).toBe("start");
  });
});
