// Bands of time as pixels of a tile: a colour for each, hatched where a plan gains, dotted where nobody comes.
import { type Bands, gain } from "../../domain/bands";
import type { BandColours } from "../viewport/theme";
import { pixelOf } from "./pixel";
import { span, type TileId, tileSize } from "./tiles";

// RGBA of tileSize² pixels, clear where obstacles stand. Patterns go on from tile to tile, whose side is a multiple of theirs.
export function bandPixels(bands: Bands, tile: TileId, colours: BandColours): Uint32Array<ArrayBuffer> {
  const fills = [0, ...colours.bands.slice(0, bands.ends.length).map(pixelOf), pixelOf(colours.unreached)];
  const [dot, hatch, halo] = [colours.dot, colours.hatch, colours.hatchHalo].map(pixelOf) as [number, number, number];
  const pixels = new Uint32Array(tileSize * tileSize);
  const look = lookAt(bands, tile);
  for (let y = 0; y < tileSize; ++y) {
    for (let x = 0; x < tileSize; ++x) {
      const { band, gained } = look(x, y);
      if (band === 0) continue;
      const period = gained === gain.onlyNow ? 8 : 16;
      const across = (x + y) % period; // rising to the right
      const isDot = band === bands.unreached && x % 16 < 2 && y % 16 < 2;
      const mark = gained === gain.none || across >= 0.4 * period ? 0 : across < 0.22 * period ? hatch : halo;
      pixels[y * tileSize + x] = isDot ? dot : mark || fills[band]!;
    }
  }
  return pixels;
}

// What a pixel shows. Where it is several cells, the best of them, as in pictures.
function lookAt(bands: Bands, { level, column, row }: TileId): (x: number, y: number) => { band: number; gained: number } {
  const side = 2 ** -level; // cells
  const cells = span(level);
  const [left, top] = [column * cells, row * cells];
  const look = { band: 0, gained: 0 };
  return (x, y) => {
    look.band = look.gained = 0;
    const [fromX, fromY] = [left + Math.floor(x * side), top + Math.floor(y * side)];
    const [endX, endY] = [Math.min(fromX + Math.max(side, 1), bands.width), Math.min(fromY + Math.max(side, 1), bands.height)];
    for (let j = fromY; j < endY; ++j) {
      for (let i = j * bands.width + fromX; i < j * bands.width + endX; ++i) {
        const band = bands.after[i]!;
        if (band !== 0 && (look.band === 0 || band < look.band)) look.band = band;
        if (bands.gains[i]! > look.gained) look.gained = bands.gains[i]!;
      }
    }
    return look;
  };
}
