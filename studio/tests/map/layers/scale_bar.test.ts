import { describe, expect, it } from "vitest";
import { lengthText, roundLength } from "../../../src/map/layers/scale_bar";

describe("the scale bar", () => {
  it("is a round number of metres, and as long as fits", () => {
    for (let metresPerPixel = 0.001; metresPerPixel < 200; metresPerPixel *= 1.07) {
      const metres = roundLength(metresPerPixel, 120);
      expect(metres / metresPerPixel).toBeLessThanOrEqual(120 + 1e-9);
      expect(metres / metresPerPixel).toBeGreaterThan(120 / 2.51);
    }
  });

  it("formats lengths", () => {
    expect([0.05, 5, 200, 2000].map(lengthText)).toEqual(["5 cm", "5 m", "200 m", "2 km"]);
  });
});
