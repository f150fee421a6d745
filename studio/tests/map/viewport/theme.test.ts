// Colours of teams can be told apart, whatever colours the reader sees.
import { describe, expect, it } from "vitest";
import { colourCount } from "../../../src/domain/agents";
import { dark, light, type Theme } from "../../../src/map/viewport/theme";

type Triple = [number, number, number];
type Matrix = [Triple, Triple, Triple];

// What those see who lack one kind of cones: Machado, Oliveira and Fernandes (2009), in linear light.
const eyes: Record<string, Matrix> = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};

function linear(hex: string): Triple {
  return [1, 3, 5].map((i) => {
    const c = parseInt(hex.slice(i, i + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  }) as Triple;
}

const times = (matrix: Matrix, [a, b, c]: Triple) => matrix.map(([x, y, z]) => x * a + y * b + z * c) as Triple;

// Oklab (Ottosson 2020), in which distances are about as large as they look.
function lab(colour: Triple): Triple {
  const cones: Matrix = [
    [0.4122214708, 0.5363325363, 0.0514459929],
    [0.2119034982, 0.6806995451, 0.1073969566],
    [0.0883024619, 0.2817188376, 0.6299787005],
  ];
  const axes: Matrix = [
    [0.2104542553, 0.793617785, -0.0040720468],
    [1.9779984951, -2.428592205, 0.4505937099],
    [0.0259040371, 0.7827717662, -0.808675766],
  ];
  return times(axes, times(cones, colour.map((c) => Math.min(Math.max(c, 0), 1)) as Triple).map(Math.cbrt) as Triple);
}

function leastDistance(colours: readonly string[], eye: Matrix): number {
  const seen = colours.map((colour) => lab(times(eye, linear(colour))));
  const apart = seen.flatMap((one, i) => seen.slice(0, i).map((other) => Math.hypot(...one.map((c, k) => c - other[k]!))));
  return Math.min(...apart);
}

function contrast(a: string, b: string): number {
  const [one, other] = [a, b].map((hex) => {
    const [red, green, blue] = linear(hex);
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05;
  });
  return Math.max(one! / other!, other! / one!);
}

describe.each(Object.entries({ light, dark }) as [string, Theme][])("colours of a team, %s", (_, theme) => {
  it.each(Object.entries(eyes))("are apart for eyes with %s vision", (_, eye) => {
    expect(leastDistance(theme.vehicles, eye)).toBeGreaterThan(0.06);
  });

  it("are as many as are given out, and carry figures", () => {
    expect(theme.vehicles).toHaveLength(colourCount.ground);
    expect(theme.fleet).toHaveLength(colourCount.air);
    for (const colour of theme.vehicles) expect(contrast(colour, theme.onVehicle)).toBeGreaterThan(4.5);
    for (const colour of theme.fleet) expect(contrast(colour, theme.onAir)).toBeGreaterThan(4.5);
  });
});
