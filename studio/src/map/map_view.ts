// The map on a canvas: shows scenes, and reports user actions. Draws only when something has changed.
import { cellOf, type Handle, handlesOf, isSameHandle } from "../domain/agents";
import type { Box, Cell, Point, Size } from "../domain/geometry";
import type { Obstacle } from "../domain/map";
import { isBrush, type Scene, type SceneEvents } from "../domain/scene";
import { duration, positionAt } from "../play/motion";
import { Gestures, type GestureTarget } from "./interaction/gestures";
import { Sketch } from "./interaction/sketch";
import { cellAt, nearestFree, onMap } from "./interaction/snap";
import { ZoneSketch } from "./interaction/zone_sketch";
import { LabelLayer } from "./labels/label_layer";
import { drawCross, drawGrid, drawGround, drawNothing } from "./layers/base_layer";
import { breachAt, drawEvents, roomBesideEvents } from "./layers/event_layer";
import { drawMarkers } from "./layers/marker_layer";
import { type Spot, spotAt, spots } from "./layers/marker_spots";
import { widthOfName } from "./layers/team_markers";
import { ObstacleLayer } from "./layers/obstacle_layer";
import { faint, PathLayer } from "./layers/path_layer";
import { agentsAt } from "./layers/playing_agents";
import { drawBases } from "./layers/recharge_layer";
import { drawRehearsalSigns, RehearsalLayer } from "./layers/rehearsal_layer";
import { drawScaleBar } from "./layers/scale_bar";
import { drawZones } from "./layers/zone_layer";
import { FeatureIndex } from "./tiles/ground_features";
import { TileCache } from "./tiles/tile_cache";
import { TilePainter } from "./tiles/tile_painter";
import { toMap, toScreen } from "./viewport/camera";
import type { Frame } from "./viewport/frame";
import { Surface } from "./viewport/surface";
import { Viewpoint } from "./viewport/viewpoint";

const fadeShare = 0.05; // of the mission: how long an obstacle takes to vanish
const frameTime = 8; // milliseconds to draw in, tiles that are missing included

export interface Marked {
  points: Point[]; // pixels of the map
  view: Size; // how large it is
  bottom: number; // pixels of the page
}

export class MapView implements GestureTarget {
  readonly #surface: Surface;
  readonly #viewpoint: Viewpoint;
  readonly #gestures: Gestures;
  readonly #tiles = new TileCache();
  readonly #obstacles = new ObstacleLayer();
  readonly #labels = new LabelLayer();
  readonly #paths = new PathLayer();
  readonly #rehearsal = new RehearsalLayer();
  readonly #sketch = new Sketch();
  readonly #outline = new ZoneSketch();

  #scene: Scene | null = null;
  #ground: FeatureIndex | null = null;
  #dragged: { spot: Spot; cell: Cell; before: Cell } | null = null;
  #spotsKnown: { key: unknown[]; all: readonly Spot[] } | null = null;
  #focused: Handle | null = null;
  #hovered: number | null = null;
  #passed: Cell | null = null;
  #held: Cell | null = null; // rubble

  constructor(
    canvas: HTMLCanvasElement,
    private readonly events: SceneEvents,
  ) {
    this.#surface = new Surface(canvas, {
      resized: () => this.#viewpoint.refit(),
      themed: () => this.#newTiles(true),
      draw: (now, whole) => this.#draw(now, whole),
    });
    this.#viewpoint = new Viewpoint(this.#surface);
    this.#gestures = new Gestures(canvas, this);
  }

  show(scene: Scene): void {
    const before = this.#scene;
    this.#scene = scene;
    if (scene.background !== before?.background || scene.map !== before?.map) {
      this.#ground = new FeatureIndex(scene.background, scene.map);
    }
    if (scene.cells !== before?.cells || scene.background !== before?.background) {
      const edited = before !== null && samePlace(before, scene);
      this.#newTiles(edited);
      this.#viewpoint.lookAt(scene.map, edited);
    } else if (scene.ruled !== before.ruled || scene.bands !== before.bands) {
      this.#newTiles(true);
    }
    if (scene.agents !== before?.agents) this.#keepFocusInView();
    if (scene.tool !== "zone" && this.#outline.corners.length > 0) this.#setOutline(() => this.#outline.drop());
    if (scene.tool === "base" && before?.tool !== "base") this.#surface.takeKeys(); // whoever asked for it is in a list
    if (scene.followed) this.#viewpoint.follow(scene.followed, before?.followed == null);
    this.#surface.ask();
  }

  fit(): void {
    this.#viewpoint.fit();
  }

  zoom(factor: number, at?: Point): void {
    this.zoomBy(factor, at ?? null, true);
  }

  // Shows a point, or an obstacle (its number): as near as it takes to see which one it is.
  centerOn(what: number | Point): void {
    if (typeof what !== "number") return this.#viewpoint.centerOn(what);
    const bounds = this.#scene?.cells.obstacle(what)?.bounds;
    if (bounds) this.#viewpoint.centerOnBox(boxOf(bounds));
  }

  // Moves the map to an obstacle (its number), or so that all points are seen, unless it is seen already.
  bringIntoView(what: number | readonly Point[]): void {
    const bounds = typeof what === "number" ? this.#scene?.cells.obstacle(what)?.bounds : undefined;
    const box = typeof what === "number" ? bounds && boxOf(bounds) : boxAround(what);
    if (!box || this.#viewpoint.sees(box)) return;
    if (typeof what === "number") this.#viewpoint.centerOnBox(box);
    else this.#viewpoint.showAll(box);
  }

  // The marker that has the keyboard's focus.
  focusMarker(handle: Handle | null): void {
    this.#focused = handle;
    this.#keepFocusInView();
    this.#surface.ask();
  }

  // Where markers, breaches and the selected obstacle are: what should stay in sight.
  marked(): Marked | null {
    const scene = this.#scene;
    if (!scene) return null;
    const { view, bottom } = this.#surface;
    const bounds = scene.selected === null ? undefined : scene.cells.obstacle(scene.selected)?.bounds;
    const cells: Point[] = [
      ...handlesOf(scene.agents).map((handle) => cellOf(scene.agents, handle)),
      ...(scene.layers.at(-1)?.plan.removed ?? []).map(({ at }) => at),
      ...(bounds ? [[(bounds[0] + bounds[2]) / 2, (bounds[1] + bounds[3]) / 2] as Point] : []),
    ];
    return { points: cells.map((cell) => toScreen(this.#viewpoint.destination, view, cell)), view, bottom };
  }

  destroy(): void {
    this.#gestures.destroy();
    this.#surface.destroy();
  }

  // Callbacks of Gestures.

  grab(at: Point): "pan" | "drag" | "draw" {
    const scene = this.#scene;
    if (!scene) return "pan";
    if (isBrush(scene.tool)) return "draw";
    const spot = scene.editable && scene.tool === "move" ? spotAt(this.#spots(), at) : null;
    if (!spot) return "pan";
    const cell = cellOf(scene.agents, spot.handle);
    this.#dragged = { spot, cell, before: cell };
    this.#viewpoint.hold(); // the map keeps still under the marker, whatever comes up around it
    this.#surface.cursor = "grabbing";
    this.#surface.ask();
    return "drag";
  }

  panBy(dx: number, dy: number): void {
    this.#viewpoint.panBy(dx, dy);
  }

  zoomBy(factor: number, at: Point | null, gliding: boolean): void {
    this.#viewpoint.zoomBy(factor, at, gliding);
  }

  point(at: Point | null): void {
    const scene = this.#scene;
    if (!scene) return;
    const spot = at && scene.editable && scene.tool === "move" ? spotAt(this.#spots(), at) : null;
    const obstacle = at && !spot ? this.#obstacleAt(at) : null;
    this.#surface.cursor = scene.tool !== "move" ? "crosshair" : spot ? "grab" : obstacle ? "pointer" : "";
    if (scene.tool === "zone") this.#outline.hover(at && this.#toMap(at));
    else if (isBrush(scene.tool)) this.#sketch.hover(at);
    if (scene.tool !== "move") this.#surface.ask();
    if (scene.bands) this.#passOver(at && cellAt(this.#toMap(at)));
    if (obstacle === this.#hovered) return;
    this.#hovered = obstacle;
    this.events.hover(obstacle);
  }

  click(at: Point): void {
    if (this.#scene?.tool === "zone") return this.#setCorner(at);
    if (this.#scene?.tool === "base") return this.events.base(onMap(this.#scene.cells, cellAt(this.#toMap(at))));
    if (this.#scene?.tool !== "move") return;
    this.events.select(this.#obstacleAt(at), cellAt(this.#toMap(at)));
  }

  // The second click of two has closed an outline, or set a base.
  doubleClick(at: Point, outwards: boolean): void {
    if (this.#scene?.tool !== "zone" && this.#scene?.tool !== "base") this.zoomBy(outwards ? 0.5 : 2, at, true);
  }

  dragTo(at: Point, done: boolean): void {
    const scene = this.#scene;
    const dragged = this.#dragged;
    if (!scene || !dragged) return;
    const point = this.#toMap(at);
    const { handle, agent } = dragged.spot;
    const cell = agent.kind === "air" ? onMap(scene.cells, cellAt(point)) : nearestFree(scene.cells, point);
    const moved = cell[0] !== dragged.cell[0] || cell[1] !== dragged.cell[1];
    dragged.cell = cell;
    if (done) this.#dragged = null;
    if (done) this.#surface.cursor = "grab";
    if (moved || done) this.events.drag(handle, cell, done);
    this.#surface.ask();
  }

  drawTo(at: Point, done: boolean): void {
    const scene = this.#scene;
    if (!scene || !isBrush(scene.tool)) return;
    if (scene.tool === "rubble") return this.#holdRubble(scene, at, done);
    this.#sketch.add(this.#toMap(at), this.#viewpoint.camera.scale);
    if (done) {
      const runs = this.#sketch.finish(scene.tool, scene.cells);
      if (runs.length > 0) this.events.draw(scene.tool, runs);
    }
    this.#surface.ask();
  }

  // A marker that was not moved was clicked.
  abandon(): void {
    if (this.#dragged && this.#dragged.cell === this.#dragged.before) this.events.choose(this.#dragged.spot.handle.agent);
    if (this.#dragged && this.#dragged.cell !== this.#dragged.before) {
      this.events.drag(this.#dragged.spot.handle, this.#dragged.before, true);
    }
    this.#dragged = null;
    if (this.#held) this.events.drop(null, true);
    this.#held = null;
    this.#sketch.drop();
    this.#surface.ask();
  }

  ask(at: Point | null): boolean {
    const scene = this.#scene;
    if (!scene) return false;
    const { width, height } = this.#surface.view;
    const place = at ?? [width / 2, height / 2];
    const frame = { camera: this.#viewpoint.camera, view: this.#surface.view };
    const plan = scene.layers.at(-1)?.plan;
    const agents = plan && scene.time !== null ? agentsAt(frame, plan, scene.time, place) : [];
    const obstacle = breachAt(frame, scene, this.#spots(), place) ?? this.#obstacleAt(place);
    return this.events.ask({ cell: onMap(scene.cells, cellAt(this.#toMap(place))), obstacle, agents }, place);
  }

  choose(): void {
    this.click([this.#surface.view.width / 2, this.#surface.view.height / 2]);
  }

  takeBack(): void {
    if (this.#scene?.tool === "zone") this.#setOutline(() => this.#outline.takeBack());
  }

  escape(): void {
    if (this.#outline.corners.length > 0) return this.#setOutline(() => this.#outline.drop());
    if (this.#scene?.tool === "base") return this.events.base(null);
    this.events.select(null, null);
  }

  #passOver(cell: Cell | null): void {
    if (cell?.join() === this.#passed?.join()) return;
    this.#passed = cell;
    this.events.passOver(cell);
  }

  #setCorner(at: Point): void {
    this.#setOutline(() => this.#outline.add(this.#toMap(at), this.#viewpoint.camera.scale));
  }

  // `change` gives an outline that is closed.
  #setOutline(change: () => Point[] | null | void): void {
    const closed = change();
    this.events.outline(closed ?? this.#outline.corners, Boolean(closed));
    this.#surface.ask();
  }

  #holdRubble(scene: Scene, at: Point, done: boolean): void {
    const cell = onMap(scene.cells, cellAt(this.#toMap(at)));
    const isSame = this.#held?.join() === cell.join();
    this.#held = done ? null : cell;
    this.#sketch.hover(done ? null : at);
    if (done || !isSame) this.events.drop(cell, done);
    this.#surface.ask();
  }

  #keepFocusInView(): void {
    const spot = this.#scene && this.#focused && this.#spots().find(({ handle }) => isSameHandle(handle, this.#focused));
    if (!spot) return;
    const { width, height } = this.#surface.view;
    const [x, y] = spot.at;
    if (Math.min(x, y, width - x, height - y) < 30) this.centerOn(cellOf(this.#scene!.agents, spot.handle));
  }

  #toMap(at: Point): Point {
    return toMap(this.#viewpoint.camera, this.#surface.view, at);
  }

  #obstacleAt(at: Point): number | null {
    return this.#scene!.cells.at(...cellAt(this.#toMap(at))) || null;
  }

  // Asked for with each move of the pointer, of teams of thousands too.
  #spots(): readonly Spot[] {
    const { agents, chosen } = this.#scene!;
    const { context, view } = this.#surface;
    const camera = this.#viewpoint.camera;
    const key = [agents, chosen, camera, view.width, view.height];
    if (!this.#spotsKnown || key.some((part, i) => part !== this.#spotsKnown!.key[i])) {
      const all = spots(agents, (point) => toScreen(camera, view, point), {
        widthOf: (id) => widthOfName(context, id),
        first: chosen,
      });
      this.#spotsKnown = { key, all };
    }
    return this.#spotsKnown.all;
  }

  #newTiles(keepOld: boolean): void {
    if (!this.#scene || !this.#ground) return this.#surface.ask();
    const { map, cells, ruled, bands } = this.#scene;
    const { theme, pixelRatio } = this.#surface;
    this.#tiles.use(new TilePainter(map, cells, ruled, this.#ground, theme, pixelRatio, bands), keepOld);
    this.#surface.ask();
  }

  #draw(now: number, whole: boolean): void {
    const scene = this.#scene;
    if (!scene) return drawNothing(this.#surface);
    const until = whole ? Infinity : performance.now() + frameTime;
    this.#viewpoint.advance(now);
    const { context, view, pixelRatio, theme, still } = this.#surface;
    const frame: Frame = { context, camera: this.#viewpoint.camera, view, pixelRatio, theme, now, still };
    const top = scene.layers.at(-1);
    const fadeSpan = top ? Math.max(duration(top.plan) * fadeShare, 1e-9) : 1;
    drawGround(frame, scene, this.#tiles);
    drawGrid(frame, scene);
    this.#obstacles.draw(frame, scene, fadeSpan);
    drawZones(frame, scene);
    if (scene.rehearsed) this.#rehearsal.draw(frame, scene, scene.rehearsed);
    else this.#paths.draw(frame, scene);
    const moreLabels = this.#labels.draw(frame, scene, roomBesideEvents(frame, scene, this.#spots()));
    drawBases(frame, scene);
    frame.context.globalAlpha = scene.old ? faint : 1;
    drawEvents(frame, scene, this.#spots(), fadeSpan);
    frame.context.globalAlpha = 1;
    if (scene.rehearsed) drawRehearsalSigns(frame, scene, scene.rehearsed);
    drawMarkers(frame, scene, this.#spots(), this.#dragged?.spot.handle ?? this.#focused);
    this.#sketch.draw(frame, scene);
    if (scene.tool === "zone") this.#outline.draw(frame, theme.ink);
    if (this.#surface.hasKeyboard) drawCross(frame);
    drawScaleBar(frame, scene.map);
    const moreTiles = this.#tiles.paintMissing(until);
    if (whole && (moreTiles || moreLabels)) return this.#draw(now, true);
    if (moreTiles || moreLabels || this.#viewpoint.isGliding || (!still && pulses(scene))) this.#surface.ask();
  }
}

function boxOf([left, top, right, bottom]: Obstacle["bounds"]): Box {
  return { left: left - 0.5, top: top - 0.5, right: right + 0.5, bottom: bottom + 0.5 };
}

function boxAround(points: readonly Point[]): Box {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return boxOf([Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)]);
}

// Whether one map is an edit of the other: then the view stays where it is.
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
