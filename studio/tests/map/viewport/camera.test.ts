import { describe, expect, it } from "vitest";
import { mapBox } from "../../../src/domain/geometry";
import {
  evenly,
  fitted,
  isSeen,
  limited,
  maxScale,
  panned,
  toMap,
  toScreen,
  visibleBox,
  zoomed,
} from "../../../src/map/viewport/camera";
import { Glide } from "../../../src/map/viewport/glide";
import { draws } from "../../domain/picture";

const view = { width: 800, height: 600 };
const map = { width: 501, height: 301 };

describe("the camera", () => {
  it("leads from the map to the screen and back", () => {
    const draw = draws(1);
    for (let i = 0; i < 50; ++i) {
      const camera = { x: draw() * 500, y: draw() * 300, scale: 0.1 + draw() * 40 };
      const [x, y] = toMap(camera, view, toScreen(camera, view, [17, 4]));
      expect(x).toBeCloseTo(17);
      expect(y).toBeCloseTo(4);
    }
  });

  it("shows the whole map when it is fitted, and touches two of its sides", () => {
    const camera = fitted(mapBox(map), view, evenly(20));
    const [left, top] = toScreen(camera, view, [-0.5, -0.5]);
    const [right, bottom] = toScreen(camera, view, [500.5, 300.5]);
    expect([left, right]).toEqual([20, 780]);
    expect(top).toBeGreaterThan(20);
    expect(top + bottom).toBeCloseTo(600);
  });

  it("leaves room where something else is", () => {
    const camera = fitted(mapBox(map), view, { left: 300, top: 10, right: 0, bottom: 60 });
    expect(toScreen(camera, view, [-0.5, 150])[0]).toBeCloseTo(300);
    expect(toScreen(camera, view, [500.5, 150])[0]).toBeCloseTo(800);
    const [top, bottom] = [toScreen(camera, view, [0, -0.5])[1], toScreen(camera, view, [0, 300.5])[1]];
    expect(top - 10).toBeCloseTo(540 - bottom);
  });

  it("keeps the point under the pointer when it zooms", () => {
    const draw = draws(2);
    for (let i = 0; i < 50; ++i) {
      const camera = { x: 250, y: 150, scale: 2 + draw() * 4 };
      const at: [number, number] = [300 + 200 * draw(), 200 + 200 * draw()];
      const before = toMap(camera, view, at);
      const after = toMap(zoomed(camera, view, map, 0.8 + draw() * 2, at), view, at);
      expect(after[0]).toBeCloseTo(before[0]);
      expect(after[1]).toBeCloseTo(before[1]);
    }
  });

  it("never leaves the map and its scales", () => {
    const draw = draws(3);
    let camera = fitted(mapBox(map), view, evenly(0));
    const smallest = camera.scale * 0.7;
    for (let i = 0; i < 300; ++i) {
      camera = panned(camera, 2000 * (draw() - 0.5), 2000 * (draw() - 0.5));
      camera = zoomed(limited(camera, view, map), view, map, 4 ** (2 * draw() - 1), [800 * draw(), 600 * draw()]);
      expect(camera.scale).toBeLessThanOrEqual(maxScale);
      expect(camera.scale).toBeGreaterThanOrEqual(smallest - 1e-12);
      expect(camera.x).toBeGreaterThanOrEqual(-0.5);
      expect(camera.x).toBeLessThanOrEqual(500.5);
      expect(camera.y).toBeGreaterThanOrEqual(-0.5);
      expect(camera.y).toBeLessThanOrEqual(300.5);
    }
  });

  it("pans by pixels", () => {
    const camera = { x: 100, y: 100, scale: 4 };
    expect(toScreen(panned(camera, 8, -12), view, [100, 100])).toEqual([408, 288]);
    expect(visibleBox(camera, view)).toEqual({ left: 0, top: 25, right: 200, bottom: 175 });
  });

  it("glides to where it is sent, about the point under the pointer", () => {
    const from = { x: 250, y: 150, scale: 2 };
    const at: [number, number] = [600, 100];
    const to = zoomed(from, view, map, 3, at);
    const glide = new Glide(from, to, 1000);
    expect(glide.at(1000).x).toBeCloseTo(from.x);
    for (let now = 1000; !glide.ends(now); now += 10) {
      const [x, y] = toMap(glide.at(now), view, at);
      expect(x).toBeCloseTo(toMap(from, view, at)[0]);
      expect(y).toBeCloseTo(toMap(from, view, at)[1]);
    }
    expect(glide.at(5000)).toEqual(to);
    expect(new Glide(from, { ...from, x: 350 }, 0).at(110).x).toBeGreaterThan(250);
  });
});

it("what lies within the view, clear of its edge, is seen, and what fills it", () => {
  const seen = { left: 0, top: 0, right: 100, bottom: 100 };
  const box = (left: number, top: number, right: number, bottom: number) => isSeen({ left, top, right, bottom }, seen, 5);
  expect([box(10, 10, 20, 20), box(10, 10, 97, 20), box(-20, 10, 20, 20), box(120, 10, 130, 20)]).toEqual([true, false, false, false]);
  expect([box(-10, 10, 110, 20), box(-10, -10, 110, 110), box(-10, 98, 110, 120)]).toEqual([true, true, false]);
});
