// Where the map is looked at from, as people move it and the page does.
import { type Box, mapBox, type Point, type Size } from "../../domain/geometry";
import { type Camera, evenly, fitted, isSeen, limited, maxScale, panned, toScreen, visibleBox, wholeMap, zoomed } from "./camera";
import { Glide } from "./glide";
import type { Surface } from "./surface";

const closer = 2.5; // than all of the map: from where one follows
const margin = 24; // pixels at the edge of the map: what is there is hardly seen
const clear = 3; // pixels a cell, from which on it is plain which obstacle is meant

export class Viewpoint {
  #map: Size | null = null;
  #camera: Camera = { x: 0, y: 0, scale: 1 };
  #untouched = true; // people have not moved the map: it stays fitted while the page takes shape
  #glide: Glide | null = null;

  constructor(private readonly surface: Surface) {}

  get camera(): Camera {
    return this.#camera;
  }

  // Where the camera will be once it is at rest.
  get destination(): Camera {
    return this.#glide?.to ?? this.#camera;
  }

  get isGliding(): boolean {
    return this.#glide !== null;
  }

  // Looks at a map; at all of it, unless it is the one before, edited.
  lookAt(map: Size, isEdited: boolean): void {
    this.#map = map;
    if (isEdited) return;
    this.#untouched = true;
    this.fit();
  }

  // Keeps the map where it is, whatever room it gets.
  hold(): void {
    this.#untouched = false;
  }

  refit(): void {
    if (this.#untouched) this.fit();
  }

  fit(): void {
    if (!this.#map || this.#isHidden()) return;
    const camera = wholeMap(this.#map, this.surface.view);
    if (this.#untouched) this.#camera = camera;
    else this.#glideTo(camera);
    this.#untouched = true;
    this.surface.ask();
  }

  panBy(dx: number, dy: number): void {
    this.#move((camera) => panned(camera, dx, dy));
  }

  // `at`: the pixel that stays; null: the middle.
  zoomBy(factor: number, at: Point | null, gliding: boolean): void {
    const { view } = this.surface;
    const kept = at ?? [view.width / 2, view.height / 2];
    const zoom = (from: Camera) => zoomed(from, view, this.#map!, factor, kept);
    if (gliding && this.#map) this.#glideTo(zoom(this.destination));
    else this.#move(zoom);
  }

  centerOn([x, y]: Point): void {
    this.#glideTo({ ...this.#camera, x, y });
  }

  // As near as it takes to see what it is.
  centerOnBox(box: Box): void {
    const whole = this.#around(box, 4);
    this.#glideTo({ ...whole, scale: Math.min(whole.scale, Math.max(this.#camera.scale, clear)) });
  }

  sees(box: Box): boolean {
    const camera = this.destination;
    return isSeen(box, visibleBox(camera, this.surface.view), margin / camera.scale);
  }

  // No nearer than now.
  showAll(box: Box): void {
    const whole = this.#around(box, 6);
    this.#glideTo({ ...whole, scale: Math.min(whole.scale, this.destination.scale) });
  }

  // Near enough to see where it drives when it begins, and then as little as keeps it away from the edge.
  follow(at: Point, begins: boolean): void {
    const { view } = this.surface;
    if (!this.#map || this.#isHidden() || (this.#glide && !begins)) return;
    if (begins) {
      const near = closer * fitted(mapBox(this.#map), view, evenly(0)).scale;
      return this.#glideTo({ x: at[0], y: at[1], scale: Math.max(this.#camera.scale, Math.min(near, maxScale)) });
    }
    const [x, y] = toScreen(this.#camera, view, at);
    const off = (place: number, size: number) => Math.min(0, place - size / 3) + Math.max(0, place - (2 * size) / 3);
    this.panBy(-off(x, view.width), -off(y, view.height));
  }

  advance(now: number): void {
    if (this.#glide) this.#camera = this.#glide.at(now);
    if (this.#glide?.ends(now)) this.#glide = null;
  }

  #around(box: Box, share: number): Camera {
    const { view } = this.surface;
    return fitted(box, view, evenly(Math.min(view.width, view.height) / share));
  }

  #isHidden(): boolean {
    return this.surface.view.width === 0;
  }

  #move(change: (camera: Camera) => Camera): void {
    if (!this.#map || this.#isHidden()) return;
    this.#glide = null;
    this.#untouched = false;
    this.#camera = limited(change(this.#camera), this.surface.view, this.#map);
    this.surface.ask();
  }

  #glideTo(to: Camera): void {
    if (!this.#map || this.#isHidden()) return;
    this.#untouched = false;
    const kept = limited(to, this.surface.view, this.#map);
    if (this.surface.still) this.#camera = kept;
    else this.#glide = new Glide(this.#camera, kept, performance.now());
    this.surface.ask();
  }
}
