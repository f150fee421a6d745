import { describe, expect, it } from "vitest";
import {
  area,
  clockTime,
  difference,
  duration,
  durations,
  length,
  percent,
  percentUp,
  type Units,
  unitsOf,
} from "../../src/domain/units";

const city: Units = { metric: true, cell: 2.4, time: "seconds", seconds: 1 };
const grid: Units = { metric: false, cell: 1, time: "steps", seconds: 1 };
const plain = (text: string) => text.replaceAll(/[\u00a0\u202f]/g, " ");

describe("units", () => {
  it("are metres where the map has a scale", () => {
    expect(unitsOf({ cell_size: 2.4, georeference: null })).toEqual(city);
    expect(unitsOf({ cell_size: 1, georeference: null })).toEqual(grid);
    const place = { crs: "", center: [13, 52] as [number, number], to_lon_lat: [] };
    expect(unitsOf({ cell_size: 1, georeference: place }).metric).toBe(true);
  });

  it("take a plan in cells for one at 1 m/s", () => {
    const units = unitsOf({ cell_size: 2.4, georeference: null }, { inSeconds: false, speeds: [1, undefined] });
    expect(plain(duration(100, units))).toBe("4 min");
    expect(plain(clockTime(100, units))).toBe("4:00");
    const seconds = (inSeconds: boolean, ...speeds: number[]) =>
      unitsOf({ cell_size: 2.4, georeference: null }, { inSeconds, speeds }).seconds;
    expect(seconds(false, 1, 2)).toBe(1);
    expect(seconds(true, 1, 1)).toBe(1); // a cell a second
    expect(unitsOf({ cell_size: 1, georeference: null }, { inSeconds: false, speeds: [1, 1] })).toEqual(grid);
  });

  it.each([
    [0, "0 s", "0 s"],
    [-114.02, "−1 min 54 s", "−1:54"],
    [0.4994, "0.5 s", "0.5 s"],
    [8.456, "8.46 s", "8.46 s"],
    [42.34, "42.3 s", "42.3 s"],
    [59.96, "1 min", "1:00"],
    [119.7, "2 min", "2:00"],
    [975.05, "16 min 15 s", "16:15"],
    [3599.6, "1 h 0 min", "1:00:00"],
    [7325, "2 h 2 min", "2:02:05"],
    [7355, "2 h 3 min", "2:02:35"],
    [7199, "2 h 0 min", "1:59:59"],
  ])("format %d seconds", (time, long, short) => {
    expect(plain(duration(time, city))).toBe(long);
    expect(plain(clockTime(time, city))).toBe(short);
  });

  it("tell times apart that stand beside each other", () => {
    const texts = (...times: number[]) => durations(times, city).map(plain);
    expect(texts(6252, 6225)).toEqual(["1 h 44 min 12 s", "1 h 43 min 45 s"]);
    expect(texts(6252, 6900)).toEqual(["1 h 44 min", "1 h 55 min"]);
    expect(texts(6252, 6252)).toEqual(["1 h 44 min", "1 h 44 min"]);
    expect(texts(3600, 3612, 860)).toEqual(["1 h 0 min", "1 h 0 min 12 s", "14 min 20 s"]);
  });

  it("subtract as one sees them", () => {
    const later = (earlier: number, time: number) => plain(difference(earlier, time, city));
    expect(later(860.4, 930.6)).toBe("1 min 11 s");
    expect(later(42.34, 65.2)).toBe("22.7 s");
    expect(later(6252, 6225 + 52)).toBe("25 s");
    expect(later(3552, 4210)).toBe("10 min 48 s");
    expect(later(860.1, 860.3)).toBe("0.2 s"); // no difference is seen
    expect(plain(difference(12.341, 17.5, grid))).toBe("5.16 steps");
  });

  it("format steps where times are those", () => {
    expect(plain(duration(406.2713, grid))).toBe("406.3 steps");
    expect(clockTime(406.2713, grid)).toBe("406.3");
  });

  it("format sizes", () => {
    expect(plain(area(1000, city))).toBe("5760 m²");
    expect(plain(area(2357, city))).toBe("13 576 m²");
    expect(plain(area(1, grid))).toBe("1 cell");
    expect(plain(length(3, grid))).toBe("3 cells");
  });

  it("format shares", () => {
    expect(plain(percent(0.2229))).toBe("22 %");
    expect(plain(percent(0.0312))).toBe("3.1 %");
    expect(plain(percent(0.00001))).toBe("less than 0.01 %");
  });

  it("never promise more than is proven", () => {
    expect(plain(percentUp(0.0015336))).toBe("0.16 %");
    expect(plain(percentUp(0.0015))).toBe("0.15 %");
    expect(plain(percentUp(0.0312))).toBe("3.2 %");
    expect(plain(percentUp(1e-7))).toBe("0.01 %");
    for (let share = 1e-6; share < 1; share *= 1.07) {
      expect(parseFloat(percentUp(share)) / 100).toBeGreaterThanOrEqual(share * (1 - 1e-9));
    }
  });
});
