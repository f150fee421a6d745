import { expect, it } from "vitest";
import { Bands } from "../../src/domain/bands";
import type { Units } from "../../src/domain/units";
import { bandLines, bandsHere, gainsNothing } from "../../src/mission/band_words";
import { reach } from "../domain/reach_document";

const city: Units = { metric: true, cell: 2, time: "seconds", seconds: 1 };
const plain = (text: string) => text.replaceAll("\u00a0", " ");

it("list all that is to be seen, with its share of the ground", () => {
  const said = bandLines(Bands.of(reach)!, city).map(({ look, band, text, share }) => `${look} ${band}: ${plain(text)}, ${plain(share)}`);
  expect(said).toEqual([
    "band 1: reached by 1 min 40 s, 44 %",
    "band 2: reached by 3 min 20 s, 89 %",
    "unreached 0: not reached, 11 %",
    "sooner 0: 10 s or more sooner, 11 %",
    "only-now 0: reached only now, 33 %",
  ]);
  const inbound = bandLines(Bands.of({ ...reach, inbound: true, gains: [0, 10] })!, city);
  expect(inbound.map(({ text }) => plain(text))).toEqual(["at the goal by 1 min 40 s", "at the goal by 3 min 20 s", "not reached"]);
});

it("say where nothing is gained", () => {
  expect([reach, { ...reach, gains: [0, 10] }].map((one) => gainsNothing(Bands.of(one)!))).toEqual([false, true]);
});

it("tell of a place", () => {
  const bands = Bands.of(reach)!;
  const here = (x: number, y: number, of = bands) => plain(bandsHere(of, [x, y], city));
  expect(here(0, 0)).toBe("Here by 1 min 40 s");
  expect(here(1, 1)).toBe("Here by 1 min 40 s, before by 3 min 20 s");
  expect(here(3, 0)).toBe("Here only now, by 3 min 20 s");
  expect(here(2, 0)).toBe("Here only now, by 3 min 20 s"); // an obstacle stood there
  expect(here(4, 1)).toBe("Here not reached");
  expect([here(2, 1), here(9, 9)]).toEqual(["", ""]);
  expect(here(0, 0, Bands.of({ ...reach, inbound: true })!)).toBe("From here by 1 min 40 s");
});
