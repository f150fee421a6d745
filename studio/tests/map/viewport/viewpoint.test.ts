// What moves the map, and what leaves it be. Nothing glides for those who want no motion.
import { beforeEach, expect, it } from "vitest";
import { toScreen } from "../../../src/map/viewport/camera";
import type { Surface } from "../../../src/map/viewport/surface";
import { Viewpoint } from "../../../src/map/viewport/viewpoint";

const map = { width: 1000, height: 1000 };
let surface: { view: { width: number; height: number }; still: boolean; ask(): void };
let viewpoint: Viewpoint;

beforeEach(() => {
  surface = { view: { width: 500, height: 500 }, still: true, ask: () => undefined };
  viewpoint = new Viewpoint(surface as unknown as Surface);
  viewpoint.lookAt(map, false);
});

it("shows all of a map until somebody moves it", () => {
  const first = viewpoint.camera;
  surface.view = { width: 250, height: 250 };
  viewpoint.refit();
  expect(viewpoint.camera.scale).toBeLessThan(first.scale);
  viewpoint.zoomBy(4, [0, 0], true);
  const { camera } = viewpoint;
  surface.view = { width: 500, height: 500 };
  viewpoint.refit();
  expect(viewpoint.camera).toEqual(camera);
});

it("stays where it is over an edited map, and shows all of another", () => {
  const whole = viewpoint.camera;
  viewpoint.zoomBy(4, null, true);
  const { camera } = viewpoint;
  viewpoint.lookAt(map, true);
  expect(viewpoint.camera).toEqual(camera);
  viewpoint.lookAt(map, false);
  expect(viewpoint.camera).toEqual(whole);
});

it("sees what it has been moved to", () => {
  viewpoint.zoomBy(8, [0, 0], true);
  const far = { left: 900, right: 910, top: 900, bottom: 910 };
  expect(viewpoint.sees(far)).toBe(false);
  viewpoint.centerOnBox(far);
  expect(viewpoint.sees(far)).toBe(true);
  expect(toScreen(viewpoint.camera, surface.view, [905, 905])).toEqual([expect.closeTo(250), expect.closeTo(250)]);
});

it("keeps whom it follows off the edge, and moves no more than that takes", () => {
  viewpoint.follow([500, 500], true);
  const begun = viewpoint.camera;
  viewpoint.follow([501, 500], false);
  expect(viewpoint.camera).toEqual(begun);
  viewpoint.follow([500 + 400 / begun.scale, 500], false);
  expect(toScreen(viewpoint.camera, surface.view, [500 + 400 / begun.scale, 500])[0]).toBeCloseTo((2 * 500) / 3);
});

it("glides to where it is sent, and is there in the end", () => {
  surface.still = false;
  const { camera } = viewpoint;
  viewpoint.zoomBy(4, null, true);
  expect([viewpoint.isGliding, viewpoint.camera]).toEqual([true, camera]);
  const { destination } = viewpoint;
  viewpoint.advance(Infinity);
  expect([viewpoint.isGliding, viewpoint.camera]).toEqual([false, destination]);
});
