import { expect, it } from "vitest";
import { Bands } from "../../../src/domain/bands";
import { bandPixels } from "../../../src/map/tiles/band_pixels";
import { pixelOf } from "../../../src/map/tiles/pixel";
import { tileSize } from "../../../src/map/tiles/tiles";

const colours = { bands: ["#010000", "#020000"], unreached: "#030000", dot: "#040000", hatch: "#050000", hatchHalo: "#060000" };
const names = new Map([[0, "."], ...["1", "2", "u", "d", "h", "H"].map((name, i) => [pixelOf(`#0${i + 1}0000`), name] as const)]);

// `gains` and `after`: a digit for each cell.
function bandsOf(after: string[], gains: string[]): Bands {
  const runs = (rows: string[]) => [...rows.join("")].flatMap((digit) => [Number(digit), 1]);
  const [width, height] = [after[0]!.length, after.length];
  return Bands.of({ format: "waybreaker-reach/1", width, height, bands: [5, 10], sooner: 0.5, before: [], after: runs(after), gains: runs(gains) })!;
}

function picture(bands: Bands, level: number, width: number, height: number, column = 0): string[] {
  const pixels = bandPixels(bands, { level, column, row: 0 }, colours);
  const row = (y: number) => Array.from({ length: width }, (_, x) => names.get(pixels[y * tileSize + x]!) ?? "?").join("");
  return Array.from({ length: height }, (_, y) => row(y));
}

it("have a colour for each band, and none where obstacles stand or the map ends", () => {
  const bands = bandsOf(["1120", "1022"], ["0000", "0000"]);
  expect(picture(bands, 0, 5, 3)).toEqual(["112..", "1.22.", "....."]);
  expect(picture(bands, 1, 10, 4)).toEqual(["111122....", "111122....", "11..2222..", "11..2222.."]);
  expect(picture(bands, 6, 2, 1, 1)).toEqual([".."]); // the tile beside the map
});

it("show in overview the best of the cells that a pixel is", () => {
  expect(picture(bandsOf(["0210", "3320"], ["0000", "0000"]), -1, 3, 2)).toEqual(["21.", "..."]);
  const hatched = picture(bandsOf(["02", "33"], ["00", "02"]), -1, 1, 1);
  expect(hatched).toEqual(["h"]);
});

it("are hatched more densely where ground is reached only now than where it is sooner, and dotted where it is not", () => {
  const bands = bandsOf(["1123"], ["1200"]);
  expect(picture(bands, 4, 64, 2)).toEqual([
    `hhhhHHH${"1".repeat(9)}${"hhHH1111".repeat(2)}${"2".repeat(16)}dd${"u".repeat(14)}`,
    `hhhHHH${"1".repeat(9)}h${"hHH1111h".repeat(2)}${"2".repeat(16)}dd${"u".repeat(14)}`,
  ]);
});

it("go on from tile to tile", () => {
  const width = 2 * tileSize;
  const bands = bandsOf(["1".repeat(width)], ["2".repeat(width)]);
  expect(picture(bands, 0, tileSize, 1, 1)).toEqual(picture(bands, 0, tileSize, 1, 0));
});
