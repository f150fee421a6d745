// Tiles that have been painted, the least recently seen given up first. Painting is spread over frames; until a tile is
// there, a coarser or an outdated one stands for it.
import type { Size } from "../../domain/geometry";
import { type Camera, toScreen, visibleBox } from "../viewport/camera";
import { boxOf, coarsestLevel, keyOf, levelFor, parentOf, partOf, type TileId, tilesOver } from "./tiles";

export interface Painter {
  paint(tile: TileId): ImageBitmap;
}

interface Entry {
  picture: ImageBitmap;
  painter: Painter; // by whom: another map or theme is another painter
}

const usualCapacity = 512; // tiles, in 128 MiB

export class TileCache {
  readonly #entries = new Map<string, Entry>(); // the least recently used first
  #capacity = usualCapacity;
  #painter: Painter | null = null;
  #missing: TileId[] = [];
  #isRested = true; // the last drawing has painted nothing itself

  // From now on tiles are made by this painter. Those of another map of the same size still serve until they are.
  use(painter: Painter, keepOld: boolean): void {
    this.#painter = painter;
    if (keepOld) return;
    for (const entry of this.#entries.values()) entry.picture.close();
    this.#entries.clear();
  }

  draw(context: CanvasRenderingContext2D, camera: Camera, view: Size, pixelRatio: number, map: Size): void {
    const coarsest = coarsestLevel(map);
    const level = levelFor(camera.scale * pixelRatio, coarsest);
    const tiles = tilesOver(visibleBox(camera, view), level, map);
    this.#capacity = Math.max(usualCapacity, 2 * tiles.length); // on a very large screen
    this.#missing = [];
    this.#isRested = true;
    for (const root of tilesOver({ left: 0, top: 0, right: map.width, bottom: map.height }, coarsest, map)) {
      if (!this.#isFresh(root)) this.#isRested = false, this.#paint(root);
      else this.#used(keyOf(root)); // never given up
    }
    for (const tile of tiles) {
      if (!this.#isFresh(tile)) this.#missing.push(tile);
      this.#drawTile(context, tile, camera, view, pixelRatio, coarsest);
    }
  }

  // Paints what the last drawing lacked until the time is `end`, one tile at least unless that drawing has painted; whether there
  // is more to draw.
  paintMissing(end: number): boolean {
    if (!this.#isRested && this.#missing.length > 0 && performance.now() >= end) return true;
    let painted = 0;
    while (this.#missing.length > 0 && (painted === 0 || performance.now() < end)) {
      this.#paint(this.#missing.shift()!);
      ++painted;
    }
    return painted > 0;
  }

  #isFresh(tile: TileId): boolean {
    return this.#entries.get(keyOf(tile))?.painter === this.#painter;
  }

  #used(key: string): Entry | undefined {
    const entry = this.#entries.get(key);
    if (!entry) return undefined;
    this.#entries.delete(key);
    this.#entries.set(key, entry);
    return entry;
  }

  #paint(tile: TileId): void {
    const key = keyOf(tile);
    this.#entries.get(key)?.picture.close();
    this.#entries.delete(key);
    this.#entries.set(key, { picture: this.#painter!.paint(tile), painter: this.#painter! });
    while (this.#entries.size > this.#capacity) {
      const [oldest, entry] = this.#entries.entries().next().value!;
      entry.picture.close();
      this.#entries.delete(oldest);
    }
  }

  #drawTile(
    context: CanvasRenderingContext2D,
    tile: TileId,
    camera: Camera,
    view: Size,
    pixelRatio: number,
    coarsest: number,
  ): void {
    const box = boxOf(tile);
    const [left, top] = toScreen(camera, view, [box.left, box.top]);
    const [right, bottom] = toScreen(camera, view, [box.right, box.bottom]);
    const snap = (at: number): number => Math.round(at * pixelRatio) / pixelRatio; // no seams between tiles
    const [x, y] = [snap(left), snap(top)];
    const [width, height] = [snap(right) - x, snap(bottom) - y];
    for (let stand = tile; stand.level >= coarsest; stand = parentOf(stand)) {
      const entry = this.#used(keyOf(stand));
      if (!entry) continue;
      const part = partOf(tile, stand);
      context.drawImage(entry.picture, part.x, part.y, part.size, part.size, x, y, width, height);
      return;
    }
  }
}
