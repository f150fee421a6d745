// Extracts of map data as docs/server.md has them (sources), and the windows that people choose on them.
import type { Box, Point, Size } from "./geometry";

export type LonLat = [lon: number, lat: number];

export interface Source {
  id: string;
  name: string;
  bytes: number;
  bounds: [west: number, south: number, east: number, north: number];
  buildings: number;
  columns: number;
  rows: number;
  built: number[]; // the share of each part that is built up, row by row from the north
  densest: { center: LonLat; size: number };
  places: { name: string; at: LonLat }[]; // the most important first
}

export type Profile = "rover" | "truck" | "walker" | "paper";

// What is asked to be imported.
export interface ImportRequest {
  source: string;
  center: LonLat;
  size: number; // metres on a side
  cell: number; // metres
  profile: Profile;
  section: number | "none"; // metres
  unknown_free?: boolean; // ground without data is free
}

export const leastWindow = 10; // metres
export const mostWindow = 100_000;

const metresPerDegree = 111_320; // of latitude

// The extract on a plane: metres east and south of its north-western corner. Good enough to choose on.
export class Extract {
  readonly size: Size;
  readonly #perLongitude: number;

  constructor(readonly source: Source) {
    const [west, south, east, north] = source.bounds;
    this.#perLongitude = metresPerDegree * Math.cos((((south + north) / 2) * Math.PI) / 180);
    this.size = { width: (east - west) * this.#perLongitude, height: (north - south) * metresPerDegree };
  }

  toPlane([lon, lat]: LonLat): Point {
    const [west, , , north] = this.source.bounds;
    return [(lon - west) * this.#perLongitude, (north - lat) * metresPerDegree];
  }

  toLonLat([x, y]: Point): LonLat {
    const [west, , , north] = this.source.bounds;
    const rounded = (degrees: number) => Math.round(degrees * 1e5) / 1e5; // to a metre
    return [rounded(west + x / this.#perLongitude), rounded(north - y / metresPerDegree)];
  }

  // The nearest place for a window of that side that lies on the extract, or in its middle if it is larger.
  placed([x, y]: Point, side: number): Point {
    const within = (at: number, length: number) =>
      side >= length ? length / 2 : Math.min(Math.max(at, side / 2), length - side / 2);
    return [within(x, this.size.width), within(y, this.size.height)];
  }

  // The largest window that is of use.
  get mostSide(): number {
    return Math.min(mostWindow, Math.max(leastWindow, Math.ceil(Math.max(this.size.width, this.size.height))));
  }

  // Whether more than a trace of a window lies beyond the data.
  reachesBeyond({ center, size }: Pick<ImportRequest, "center" | "size">): boolean {
    const [x, y] = this.toPlane(center);
    return Math.min(x, y, this.size.width - x, this.size.height - y) < 0.495 * size;
  }

  // Names of places in view, and where; less important ones where they do not touch others.
  placesIn(view: Box): { name: string; at: Point }[] {
    const side = view.right - view.left;
    const shown: { name: string; at: Point; reach: number }[] = [];
    for (const { name, at } of this.source.places) {
      const [x, y] = this.toPlane(at);
      const reach = (name.length * side) / 90; // half the width of the text
      if (x - reach < view.left || x + reach > view.right || y < view.top || y > view.bottom) continue;
      const touches = shown.some((one) => Math.abs(one.at[0] - x) < one.reach + reach && Math.abs(one.at[1] - y) < side / 20);
      if (!touches) shown.push({ name, at: [x, y], reach });
    }
    return shown;
  }

  // Parts by how much they are built up, from little to much: rectangles as the data of an SVG path.
  shades(count: number): string[] {
    const { built, columns, rows } = this.source;
    const [width, height] = [this.size.width / columns, this.size.height / rows];
    const most = Math.max(...built, 1e-9);
    const paths = Array<string>(count).fill("");
    built.forEach((share, i) => {
      if (share <= 0) return;
      const shade = Math.min(Math.floor((Math.sqrt(share / most)) * count), count - 1);
      const [x, y] = [(i % columns) * width, Math.floor(i / columns) * height];
      paths[shade] += `M${x.toFixed(1)} ${y.toFixed(1)}h${width.toFixed(1)}v${height.toFixed(1)}h${(-width).toFixed(1)}z`;
    });
    return paths;
  }
}

// Whether all that is drawn and typed has a number: JSON has none for what is not finite.
export function isWhole({ bounds, built, densest, places }: Source): boolean {
  const numbers = [...bounds, ...built, ...densest.center, densest.size, ...places.flatMap(({ at }) => at)];
  return numbers.every((one) => Number.isFinite(one));
}

// What is shown first: where the data is built up most.
export function usualImport(source: Source): ImportRequest {
  const { center, size } = source.densest;
  return { source: source.id, center, size, cell: 2.4, profile: "rover", section: 20 };
}

export function cellsOf({ size, cell }: ImportRequest): number {
  return Math.round(size / cell);
}

// Of such data one knows where it ends; what else is sent is GeoJSON.
export function isOpenStreetMap({ name }: Source): boolean {
  return !/\.(geo)?json(\.gz)?$/i.test(name);
}
