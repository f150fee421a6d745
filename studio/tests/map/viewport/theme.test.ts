// Colours of teams, and of what the ground is, can be told apart, whatever colours the reader sees; they are the same in the
// style sheets and in pictures.
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { colourCount } from "../../../src/domain/agents";
import { looks } from "../../../src/domain/looks";
import { dark, light, type Theme } from "../../../src/map/viewport/theme";

type Triple = [number, number, number];
type Matrix = [Triple, Triple, Triple];

// What those see who lack one kind of cones: Machado, Oliveira and Fernandes (2009), in linear light.
const eyes: Record<string, Matrix> = {
  usual: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};
const luminance: Triple = [0.2126, 0.7152, 0.0722];
const greyscale: Matrix = [luminance, luminance, luminance]; // as a printer makes it

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

function distance(a: string, b: string, eye: Matrix): number {
  const [one, other] = [a, b].map((colour) => lab(times(eye, linear(colour)))) as [Triple, Triple];
  return Math.hypot(...one.map((c, k) => c - other[k]!));
}

function leastDistance(colours: readonly string[], eye: Matrix): number {
  return Math.min(...colours.flatMap((one, i) => colours.slice(0, i).map((other) => distance(one, other, eye))));
}

function contrast(a: string, b: string): number {
  const [one, other] = [a, b].map((hex) => {
    return linear(hex).reduce((sum, c, i) => sum + c * luminance[i]!, 0.05);
  });
  return Math.max(one! / other!, other! / one!);
}

describe.each(Object.entries({ light, dark }) as [string, Theme][])("colours of a team, %s", (_, theme) => {
  it.each(Object.entries(eyes))("are apart for eyes with %s vision", (_, eye) => {
    expect(leastDistance(theme.vehicles, eye)).toBeGreaterThan(0.07);
    expect(leastDistance(theme.fleet, eye)).toBeGreaterThan(0.07);
  });

  it("are as many as are given out, and carry figures", () => {
    expect(theme.vehicles).toHaveLength(colourCount.ground);
    expect(theme.fleet).toHaveLength(colourCount.air);
    for (const colour of theme.vehicles) expect(contrast(colour, theme.onVehicle)).toBeGreaterThan(4.5);
    for (const colour of theme.fleet) expect(contrast(colour, theme.onAir)).toBeGreaterThan(4.5);
  });
});

describe.each(Object.entries({ light, dark }) as [string, Theme][])("colours of the ground, %s", (_, theme) => {
  const { paper, street, removedTint, obstacles } = theme;
  const known = looks.filter((look) => look !== "unknown" && look !== "off_road");
  const closed = [removedTint, ...known.map((look) => obstacles[look].fill)];

  it.each(Object.entries({ ...eyes, greyscale }))("are apart for eyes with %s vision", (_, eye) => {
    expect(leastDistance(closed, eye)).toBeGreaterThan(0.05);
    for (const open of [paper, street]) {
      for (const colour of closed) expect(distance(open, colour, eye), `${open} ${colour}`).toBeGreaterThan(0.05);
    }
  });

  it("have patterns and edges that show in print", () => {
    for (const look of looks) expect(distance(obstacles[look].fill, obstacles[look].edge, greyscale), look).toBeGreaterThan(0.1);
    expect(distance(removedTint, theme.removed, greyscale)).toBeGreaterThan(0.2);
  });

  // As light as other ground in print, under dots that nothing else has.
  it("have dots off the roads, which are green for usual eyes", () => {
    const { fill, edge } = obstacles.off_road;
    const others = [...closed, paper, street];
    for (const other of others) expect(distance(fill, other, eyes.usual!), other).toBeGreaterThan(0.04);
    for (const eye of [...Object.values(eyes), greyscale]) expect(distance(fill, edge, eye)).toBeGreaterThan(0.2);
  });

  // Where nobody knows, it looks like what lies beyond the map, under a lattice that nothing else has.
  it.each(Object.entries({ ...eyes, greyscale }))("have a lattice on what is unknown, for eyes with %s vision", (_, eye) => {
    expect(obstacles.unknown.fill).toBe(theme.outside);
    expect(distance(obstacles.unknown.fill, obstacles.unknown.edge, eye)).toBeGreaterThan(0.35);
  });
});

describe.each(Object.entries({ light, dark }) as [string, Theme][])("bands of time, %s", (_, { reach, obstacles }) => {
  it.each(Object.entries({ ...eyes, greyscale }))("are each lighter than the one before, for eyes with %s vision", (_, eye) => {
    const lightness = reach.bands.map((colour) => lab(times(eye, linear(colour)))[0]);
    lightness.slice(1).forEach((later, i) => expect(later - lightness[i]!).toBeGreaterThan(0.05));
  });

  it("have a hatching of which one half shows on each of them, in print as well", () => {
    for (const band of reach.bands) {
      const halves = [reach.hatch, reach.hatchHalo].map((colour) => distance(band, colour, greyscale));
      expect(Math.max(...halves), band).toBeGreaterThan(0.15);
      for (const eye of Object.values(eyes)) expect(distance(band, reach.hatch, eye), band).toBeGreaterThan(0.08);
    }
    expect(distance(reach.unreached, reach.dot, greyscale)).toBeGreaterThan(0.3);
  });

  it("are not taken for obstacles", () => {
    for (const band of reach.bands) {
      for (const look of ["removable", "fixed", "water"] as const) {
        expect(distance(band, obstacles[look].fill, eyes.usual!), `${band} ${look}`).toBeGreaterThan(0.05);
      }
    }
  });
});

const text = (path: string) => readFileSync(new URL(`../../../${path}`, import.meta.url), "utf8");

// Colours by name, of the light half of a style sheet or of its dark one.
function variables(path: string, half: 0 | 1): Record<string, string> {
  const halves = text(path).split("prefers-color-scheme: dark");
  return Object.fromEntries([...halves[half]!.matchAll(/--([\w-]+): (#\w{6});/g)].map(([, name, value]) => [name!, value!]));
}

it.each([["light", light, 0], ["dark", dark, 1]] as const)("the style sheets have the same colours, %s", (_, theme, half) => {
  const ground = variables("src/style/ground.css", half);
  for (const look of looks) {
    expect([ground[`${look}-fill`], ground[`${look}-edge`]]).toEqual([theme.obstacles[look].fill, theme.obstacles[look].edge]);
  }
  const { bands, dot, unreached, hatch, hatchHalo } = theme.reach;
  bands.forEach((colour, i) => expect(ground[`band-${i + 1}`]).toBe(colour));
  const others = ["dot", "unreached", "hatch", "halo"].map((name) => ground[`band-${name}`]);
  expect(others).toEqual([dot, unreached, hatch, hatchHalo]);
  expect(variables("src/style/base.css", half)["removed-quiet"]).toBe(theme.removedTint);
  const agents = [...text("src/style/agents.css").split("prefers-color-scheme: dark")[half]!.matchAll(/\.agent-(ground|air)-(\d+) \{\s*--agent: (#\w{6})/g)];
  const colours = (kind: string) => agents.filter((one) => one[1] === kind).map((one) => [Number(one[2]), one[3]]);
  expect(colours("ground")).toEqual([...theme.vehicles.entries()]);
  expect(colours("air")).toEqual([...theme.fleet.entries()]);
});

// What is written on what, by the names of the style sheets: [texts, grounds].
const written: [string[], string[]][] = [
  [["ink", "faded", "accent"], ["panel", "raised", "field", "quiet", "outside", "accent-quiet", "lit"]],
  [["bad"], ["panel", "bad-quiet", "lit"]],
  [["accent-ink"], ["accent"]],
  [["on-breach"], ["breach"]],
];

it.each([["light", 0], ["dark", 1]] as const)("texts of the page can be read, %s", (_, half) => {
  const page = variables("src/style/base.css", half);
  for (const [inks, grounds] of written) {
    for (const ink of inks) {
      for (const ground of grounds) {
        expect.soft(contrast(page[ink]!, page[ground]!), `${ink} on ${ground}`).toBeGreaterThan(4.7);
      }
    }
  }
  const lanes = variables("src/play/timeline.css", half);
  for (const ink of ["lane-ink", "lane-faded"]) {
    expect.soft(contrast(lanes[ink]!, page["panel"]!), ink).toBeGreaterThan(4.7);
  }
  expect.soft(contrast(lanes["lane-on-breach"]!, lanes["lane-breach"]!)).toBeGreaterThan(4.7);
});

it.each([["light", light], ["dark", dark]] as const)("texts of the map can be read, %s", (_, theme) => {
  const pairs: [string, string][] = [
    [theme.onBreach, theme.breach],
    [theme.onGround, theme.ground],
    [theme.onAir, theme.air],
    [theme.ink, theme.card.slice(0, 7)],
    [theme.ink, theme.halo],
    [theme.fadedInk, theme.halo],
    [theme.waterName, theme.water],
    [theme.greenName, theme.green],
  ];
  for (const [ink, ground] of pairs) expect.soft(contrast(ink, ground), `${ink} on ${ground}`).toBeGreaterThan(4.7);
});

it("pictures have the colours of the light page", () => {
  const palette = text("../src/render/palette.hpp");
  const colours = Object.fromEntries([...palette.matchAll(/string_view (\w+) = "(#\w{6})"/g)].map(([, name, value]) => [name!, value!]));
  const lists = (name: string) => new RegExp(`${name}\\{([^}]*)\\}`).exec(palette)![1]!.split(",").map((one) => one.trim());
  const names = { removable: "obstacle", barrier: "barrier", fixed: "fixed_obstacle", water: "deep_water", cliff: "cliff", forbidden: "forbidden", off_road: "off_road", unknown: "unknown" };
  for (const look of looks) expect(colours[names[look]], look).toBe(light.obstacles[look].fill);
  for (const name of ["paper", "removed", "ground", "air"] as const) expect(colours[name], name).toBe(light[name]);
  expect(colours.removed_tint).toBe(light.removedTint);
  expect(lists("vehicles")).toEqual(light.vehicles.map((colour) => `"${colour}"`));
  expect(lists("bands")).toEqual(light.reach.bands.map((colour) => `"${colour}"`));
  expect([colours.street, colours.faded_ink, colours.removed, colours.halo]).toEqual([
    light.reach.unreached, light.reach.dot, light.reach.hatch, light.reach.hatchHalo,
  ]);
  expect(lists("fleet")).toEqual(["air", ...light.fleet.slice(1).map((colour) => `"${colour}"`)]);
});
