// The map on a canvas: shows scenes, and tells what people do to them. Draws only when something has changed.
import type { Cell, Point } from "../api/answers";
import { duration, positionAt } from "../play/motion";
import { type Camera, fitted, limited, panned, type Size, toMap, toScreen, wholeMap, zoomed } from "./camera";
import { drawEvents } from "./event_layer";
import { drawCross, drawGrid, drawGround } from "./base_layer";
import type { Frame } from "./frame";
import { Glide } from "./glide";
import { Gestures, type GestureTarget } from "./gestures";
import { FeatureIndex } from "./ground_features";
import { LabelLayer } from "./label_layer";
import { drawMarkers } from "./marker_layer";
import { cellOf, isAir, type Spot, spotAt, spots } from "./markers";
import { ObstacleLayer } from "./obstacle_layer";
import { PathLayer } from "./path_layer";
import { drawScaleBar } from "./scale_bar";
import type { Handle, Scene, SceneEvents } from "./scene";
import { cellAt, nearestFree, onMap } from "./snap";
import { Sketch } from "./sketch";
import { dark, light, type Theme } from "./theme";
import { TileCache } from "./tile_cache";
import { TilePainter } from "./tile_painter";

const fadeShare = 0.05; // of the mission: how long an obstacle takes to vanish
const frameTime = 8; // milliseconds to draw in, tiles that are missing included

export class MapView implements GestureTarget {
  readonly #context: CanvasRenderingContext2D;
  readonly #gestures: Gestures;
  readonly #resizing: ResizeObserver;
  readonly #listening = new AbortController();
  readonly #darkness = matchMedia("(prefers-color-scheme: dark)");
  readonly #stillness = matchMedia("(prefers-reduced-motion: reduce)");
  readonly #tiles = new TileCache();
  readonly #obstacles = new ObstacleLayer();
  readonly #labels = new LabelLayer();
  readonly #paths = new PathLayer();
  readonly #sketch = new Sketch();

  #scene: Scene | null = null;
  #ground: FeatureIndex | null = null;
  #camera: Camera = { x: 0, y: 0, scale: 1 };
  #view: Size = { width: 0, height: 0 };
  #untouched = true; // people have not moved the map: it stays fitted while the page takes shape
  #glide: Glide | null = null;
  #frame: number | null = null;
  #dragged: { spot: Spot; cell: Cell; before: Cell } | null = null;
  #focused: Handle | null = null;
  #hovered: number | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly events: SceneEvents,
  ) {
    this.#context = canvas.getContext("2d", { alpha: false })!;
    this.#gestures = new Gestures(canvas, this);
    this.#resizing = new ResizeObserver(() => this.#resize());
    this.#resizing.observe(canvas);
    const signal = this.#listening.signal;
    this.#darkness.addEventListener("change", () => this.#newTiles(true), { signal });
    this.#stillness.addEventListener("change", () => this.#draw(), { signal });
    canvas.addEventListener("focus", () => this.#draw(), { signal });
    canvas.addEventListener("blur", () => this.#draw(), { signal });
  }

  show(scene: Scene): void {
    const before = this.#scene;
    this.#scene = scene;
    if (scene.background !== before?.background) this.#ground = new FeatureIndex(scene.background);
    if (scene.cells !== before?.cells || scene.background !== before?.background) {
      const edited = before !== null && samePlace(before, scene);
      this.#newTiles(edited);
      if (!edited) this.#untouched = true;
      if (!edited) this.fit();
    }
    if (scene.markers !== before?.markers) this.#keepFocusInView();
    this.#draw();
  }

  fit(): void {
    if (!this.#scene || this.#view.width === 0) return;
    const camera = wholeMap(this.#scene.map, this.#view);
    if (this.#untouched) this.#camera = camera;
    else this.#glideTo(camera);
    this.#untouched = true;
    this.#draw();
  }

  zoom(factor: number, at?: Point): void {
    this.zoomBy(factor, at ?? null, true);
  }

  // Shows an obstacle (its number) or a point, no nearer than people are already.
  centerOn(what: number | Point): void {
    const scene = this.#scene;
    if (!scene) return;
    if (typeof what !== "number") {
      this.#glideTo({ ...this.#camera, x: what[0], y: what[1] });
      return;
    }
    const bounds = scene.cells.obstacle(what)?.bounds;
    if (!bounds) return;
    const [left, top, right, bottom] = bounds;
    const box = { left: left - 0.5, top: top - 0.5, right: right + 0.5, bottom: bottom + 0.5 };
    const whole = fitted(box, this.#view, Math.min(this.#view.width, this.#view.height) / 4);
    this.#glideTo({ ...whole, scale: Math.min(whole.scale, Math.max(this.#camera.scale, 3)) });
  }

  // The marker that has the keyboard's focus.
  focusMarker(handle: Handle | null): void {
    this.#focused = handle;
    this.#keepFocusInView();
    this.#draw();
  }

  destroy(): void {
    this.#gestures.destroy();
    this.#resizing.disconnect();
    this.#listening.abort();
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
  }

  // What Gestures tells.

  grab(at: Point): "pan" | "drag" | "draw" {
    const scene = this.#scene;
    if (!scene) return "pan";
    if (scene.tool !== "move") return "draw";
    const spot = scene.editable ? spotAt(this.#spots(), at) : null;
    if (!spot) return "pan";
    const cell = cellOf(scene.markers, spot.handle);
    this.#dragged = { spot, cell, before: cell };
    this.#untouched = false; // the map keeps still under the marker, whatever comes up around it
    this.canvas.style.cursor = "grabbing";
    this.#draw();
    return "drag";
  }

  panBy(dx: number, dy: number): void {
    this.#move((camera) => panned(camera, dx, dy));
  }

  zoomBy(factor: number, at: Point | null, gliding: boolean): void {
    if (!this.#scene) return;
    const middle: Point = [this.#view.width / 2, this.#view.height / 2];
    const from = this.#glide?.to ?? this.#camera;
    const to = zoomed(from, this.#view, this.#scene.map, factor, at ?? middle);
    if (gliding) this.#glideTo(to);
    else this.#move((camera) => zoomed(camera, this.#view, this.#scene!.map, factor, at ?? middle));
  }

  point(at: Point | null): void {
    const scene = this.#scene;
    if (!scene) return;
    const spot = at && scene.editable && scene.tool === "move" ? spotAt(this.#spots(), at) : null;
    const obstacle = at && !spot ? this.#obstacleAt(at) : null;
    this.canvas.style.cursor = scene.tool !== "move" ? "crosshair" : spot ? "grab" : obstacle ? "pointer" : "";
    if (scene.tool !== "move") this.#sketch.hover(at);
    if (scene.tool !== "move") this.#draw();
    if (obstacle === this.#hovered) return;
    this.#hovered = obstacle;
    this.events.hover(obstacle);
  }

  click(at: Point): void {
    if (this.#scene?.tool !== "move") return;
    const obstacle = this.#obstacleAt(at);
    this.events.select(obstacle, obstacle === null ? null : cellAt(this.#toMap(at)));
  }

  dragTo(at: Point, done: boolean): void {
    const scene = this.#scene;
    const dragged = this.#dragged;
    if (!scene || !dragged) return;
    const point = this.#toMap(at);
    const { handle } = dragged.spot;
    const cell = isAir(handle) ? onMap(scene.cells, cellAt(point)) : nearestFree(scene.cells, point);
    const moved = cell[0] !== dragged.cell[0] || cell[1] !== dragged.cell[1];
    dragged.cell = cell;
    if (done) this.#dragged = null;
    if (done) this.canvas.style.cursor = "grab";
    if (moved || done) this.events.drag(handle, cell, done);
    this.#draw();
  }

  drawTo(at: Point, done: boolean): void {
    const scene = this.#scene;
    if (!scene || scene.tool === "move") return;
    this.#sketch.add(this.#toMap(at), this.#camera.scale);
    if (done) {
      const runs = this.#sketch.finish(scene.tool, scene.cells);
      if (runs.length > 0) this.events.draw(scene.tool, runs);
    }
    this.#draw();
  }

  abandon(): void {
    if (this.#dragged && this.#dragged.cell !== this.#dragged.before) {
      this.events.drag(this.#dragged.spot.handle, this.#dragged.before, true);
    }
    this.#dragged = null;
    this.#sketch.drop();
    this.#draw();
  }

  choose(): void {
    this.click([this.#view.width / 2, this.#view.height / 2]);
  }

  escape(): void {
    this.events.select(null, null);
  }

  #keepFocusInView(): void {
    const spot = this.#scene && this.#spots().find(({ handle }) => handle === this.#focused);
    if (!spot) return;
    const { width, height } = this.#view;
    const [x, y] = spot.at;
    if (Math.min(x, y, width - x, height - y) < 30) this.centerOn(cellOf(this.#scene!.markers, spot.handle));
  }

  #toMap(at: Point): Point {
    return toMap(this.#camera, this.#view, at);
  }

  #obstacleAt(at: Point): number | null {
    return this.#scene!.cells.at(...cellAt(this.#toMap(at))) || null;
  }

  #spots(): Spot[] {
    return spots(this.#scene!.markers, (point) => toScreen(this.#camera, this.#view, point));
  }

  #move(change: (camera: Camera) => Camera): void {
    if (!this.#scene) return;
    this.#glide = null;
    this.#untouched = false;
    this.#camera = limited(change(this.#camera), this.#view, this.#scene.map);
    this.#draw();
  }

  #glideTo(to: Camera): void {
    if (!this.#scene) return;
    this.#untouched = false;
    const kept = limited(to, this.#view, this.#scene.map);
    if (this.#stillness.matches) this.#camera = kept;
    else this.#glide = new Glide(this.#camera, kept, performance.now());
    this.#draw();
  }

  #theme(): Theme {
    return this.#darkness.matches ? dark : light;
  }

  #newTiles(keepOld: boolean): void {
    if (!this.#scene || !this.#ground) return;
    const { map, cells } = this.#scene;
    this.#tiles.use(new TilePainter(map, cells, this.#ground, this.#theme(), devicePixelRatio), keepOld);
    this.#draw();
  }

  #resize(): void {
    const box = this.canvas.getBoundingClientRect();
    this.#view = { width: box.width, height: box.height };
    this.canvas.width = Math.round(box.width * devicePixelRatio);
    this.canvas.height = Math.round(box.height * devicePixelRatio);
    if (this.#untouched) this.fit();
    this.#render(performance.now()); // at once: a resized canvas is blank
  }

  #draw(): void {
    this.#frame ??= requestAnimationFrame((now) => {
      this.#frame = null;
      this.#render(now);
    });
  }

  #render(now: number): void {
    const scene = this.#scene;
    if (!scene || this.#view.width === 0) return;
    const begin = performance.now();
    if (this.#glide) this.#camera = this.#glide.at(now);
    if (this.#glide?.ends(now)) this.#glide = null;
    const frame: Frame = {
      context: this.#context,
      camera: this.#camera,
      view: this.#view,
      pixelRatio: devicePixelRatio,
      theme: this.#theme(),
      now,
      still: this.#stillness.matches,
    };
    const top = scene.layers.at(-1);
    const fadeSpan = top ? Math.max(duration(top.plan) * fadeShare, 1e-9) : 1;
    this.#context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    drawGround(frame, scene, this.#tiles);
    drawGrid(frame, scene);
    this.#obstacles.draw(frame, scene, fadeSpan);
    this.#labels.draw(frame, scene);
    this.#paths.draw(frame, scene);
    drawEvents(frame, scene, fadeSpan);
    drawMarkers(frame, scene.markers, this.#dragged?.spot.handle ?? this.#focused, scene.editable);
    this.#sketch.draw(frame, scene);
    if (this.canvas.matches(":focus-visible")) drawCross(frame);
    drawScaleBar(frame, scene.map.cell_size);
    if (this.#tiles.paintMissing(begin + frameTime) || this.#glide || (!frame.still && pulses(scene))) this.#draw();
  }
}

// Whether one map is an edit of the other: then people keep looking at the same place.
function samePlace(a: Scene, b: Scene): boolean {
  const key = ({ map }: Scene): string =>
    JSON.stringify([map.width, map.height, map.cell_size, map.georeference?.center, map.title]);
  return key(a) === key(b);
}

// Whether an agent waits just now: that is shown by a ring that moves.
function pulses({ time, layers }: Scene): boolean {
  const agents = layers.at(-1)?.plan.agents ?? [];
  return time !== null && agents.some((agent) => positionAt(agent, time)?.state === "waiting");
}
