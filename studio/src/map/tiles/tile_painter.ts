// Paints one tile: ground features first, or bands of time in their place, obstacles above.
import type { Bands } from "../../domain/bands";
import type { CellMap } from "../../domain/cell_map";
import type { Ruled } from "../../domain/looks";
import type { Feature, MapDescription } from "../../domain/map";
import type { Theme } from "../viewport/theme";
import { bandPixels } from "./band_pixels";
import { FeatureIndex, streetShows, streetStyle } from "./ground_features";
import { ObstacleLooks, obstaclePixels } from "./obstacle_pixels";
import { boxOf, type TileId, tileSize } from "./tiles";

export class TilePainter {
  readonly #looks: ObstacleLooks;
  readonly #paths = new Map<number, Path2D>();
  readonly #tile = new OffscreenCanvas(tileSize, tileSize);
  readonly #raster = new OffscreenCanvas(tileSize, tileSize);

  constructor(
    private readonly map: MapDescription,
    private readonly cells: CellMap,
    ruled: Ruled,
    private readonly ground: FeatureIndex,
    private readonly theme: Theme,
    private readonly pixelRatio: number,
    private readonly bands: Bands | null = null,
  ) {
    this.#looks = new ObstacleLooks(cells, ruled);
  }

  paint(tile: TileId): ImageBitmap {
    const context = this.#tile.getContext("2d", { alpha: false })!;
    context.fillStyle = this.theme.paper;
    context.fillRect(0, 0, tileSize, tileSize);
    this.#paintGround(context, tile);
    if (this.bands) this.#put(context, bandPixels(this.bands, tile, this.theme.reach));
    this.#put(context, obstaclePixels(this.cells, this.#looks, tile, this.theme.obstacles));
    return this.#tile.transferToImageBitmap();
  }

  #put(context: OffscreenCanvasRenderingContext2D, pixels: Uint32Array<ArrayBuffer>): void {
    const image = new ImageData(new Uint8ClampedArray(pixels.buffer), tileSize, tileSize);
    this.#raster.getContext("2d")!.putImageData(image, 0, 0);
    context.drawImage(this.#raster, 0, 0);
  }

  #paintGround(context: OffscreenCanvasRenderingContext2D, tile: TileId): void {
    const box = boxOf(tile);
    const scale = tileSize / (box.right - box.left);
    const seen = this.ground.over({
      left: box.left - 20 / this.map.cell_size, // as wide as a street may be
      top: box.top - 20 / this.map.cell_size,
      right: box.right + 20 / this.map.cell_size,
      bottom: box.bottom + 20 / this.map.cell_size,
    });
    context.save();
    context.scale(scale, scale);
    context.translate(-box.left, -box.top);
    context.lineJoin = "round";
    context.lineCap = "round";
    const streets: number[] = [];
    for (const i of seen) {
      const feature = this.ground.features[i]!;
      if (feature.kind === "street" && feature.shape === "line") streets.push(i);
      else this.#paintStreets(context, streets.splice(0), scale), this.#paintFeature(context, feature, i, scale);
    }
    this.#paintStreets(context, streets, scale);
    context.restore();
  }

  #paintFeature(context: OffscreenCanvasRenderingContext2D, feature: Feature, i: number, scale: number): void {
    const path = this.#pathOf(i);
    const { theme } = this;
    const colour = { green: theme.green, water: theme.water, street: theme.street, rail: theme.rail, place: "" };
    if (feature.shape === "area") {
      context.fillStyle = colour[feature.kind];
      context.fill(path, "evenodd");
    } else if (feature.kind === "rail") {
      context.strokeStyle = theme.rail;
      context.lineWidth = Math.max((1.5 / this.map.cell_size), (0.9 * this.pixelRatio) / scale);
      context.stroke(path);
    } else {
      context.strokeStyle = colour[feature.kind];
      context.lineWidth = Math.max(6 / this.map.cell_size, (1.5 * this.pixelRatio) / scale); // a stream's guess
      context.stroke(path);
    }
  }

  // All edges before all surfaces, so that crossings are open.
  #paintStreets(context: OffscreenCanvasRenderingContext2D, streets: number[], scale: number): void {
    const { theme, map } = this;
    const pixelsPerMetre = scale / map.cell_size / this.pixelRatio;
    const shown = streets.filter((i) => streetShows(streetStyle(this.ground.features[i]!.class), pixelsPerMetre));
    const width = (i: number): number => {
      const style = streetStyle(this.ground.features[i]!.class);
      const least = style.onFoot ? 0.8 : 0.6 + 0.25 * style.rank;
      return Math.max(style.metres / map.cell_size, (least * this.pixelRatio) / scale);
    };
    for (const i of shown) {
      if (streetStyle(this.ground.features[i]!.class).onFoot) continue;
      context.strokeStyle = theme.streetEdge;
      context.lineWidth = width(i) + (1.6 * this.pixelRatio) / scale;
      context.stroke(this.#pathOf(i));
    }
    for (const i of shown) {
      const onFoot = streetStyle(this.ground.features[i]!.class).onFoot;
      context.strokeStyle = onFoot ? theme.path : theme.street;
      context.lineWidth = width(i);
      context.stroke(this.#pathOf(i));
    }
  }

  #pathOf(i: number): Path2D {
    let path = this.#paths.get(i);
    if (path) return path;
    path = new Path2D();
    const feature = this.ground.features[i]!;
    for (const part of feature.points) {
      part.forEach(([x, y], k) => (k === 0 ? path!.moveTo(x, y) : path!.lineTo(x, y)));
      if (feature.shape === "area") path.closePath();
    }
    this.#paths.set(i, path);
    return path;
  }
}
