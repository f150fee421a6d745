import { expect, it } from "vitest";
import { numberText, parsedNumber } from "../../src/domain/number_text";

it("takes a decimal comma as well as a point", () => {
  expect(["1,5", "1.5", " 0,25 ", ",5", ".5", "5,", "-12,5", "−3", "1e3", "007"].map(parsedNumber)).toEqual([
    1.5, 1.5, 0.25, 0.5, 0.5, 5, -12.5, -3, 1000, 7,
  ]);
});

it("takes nothing else for a number, and never leaves a mark out", () => {
  for (const text of ["", " ", "1.000,5", "1,000.5", "1,5,5", "1 000", "0x10", "Infinity", "NaN", "five", "1,5 m", ",", "-"]) {
    expect(parsedNumber(text), text).toBeNull();
  }
});

it("writes a number so that it is read as the same", () => {
  for (const value of [0, 0.1 + 0.2, 1 / 3, -179.99999, 1e5, 123456, 1e-7, 1e21]) {
    expect(parsedNumber(numberText(value))).toBeCloseTo(value, 3);
  }
});
