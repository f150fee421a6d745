// The ground below the obstacles: which of its features are where, in which order and how wide.
import { type Box, intersection, mapBox, overlap, type Point, type Size } from "../../domain/geometry";
import type { Background, Feature } from "../../domain/map";

export interface StreetStyle {
  metres: number;
  rank: number; // those of higher rank lie above, and are seen from farther away
  onFoot: boolean;
}

const usual: StreetStyle = { metres: 8, rank: 4, onFoot: false };

const streets = new Map<string, StreetStyle>([
  ["motorway", { metres: 22, rank: 8, onFoot: false }],
  ["trunk", { metres: 20, rank: 8, onFoot: false }],
  ["primary", { metres: 17, rank: 7, onFoot: false }],
  ["secondary", { metres: 14, rank: 6, onFoot: false }],
  ["tertiary", { metres: 11, rank: 5, onFoot: false }],
  ["residential", usual],
  ["living_street", { metres: 7, rank: 4, onFoot: false }],
  ["pedestrian", { metres: 7, rank: 3, onFoot: false }],
  ["service", { metres: 4, rank: 2, onFoot: false }],
  ["track", { metres: 3, rank: 1, onFoot: true }],
  ["footway", { metres: 2, rank: 1, onFoot: true }],
  ["cycleway", { metres: 2, rank: 1, onFoot: true }],
  ["path", { metres: 2, rank: 1, onFoot: true }],
  ["steps", { metres: 2, rank: 1, onFoot: true }],
]);

export function streetStyle(street: string): StreetStyle {
  return streets.get(street.replace(/_link$/, "")) ?? usual;
}

// Whether a street is drawn at so many pixels per metre: a city seen whole would be all alleys.
export function streetShows(style: StreetStyle, pixelsPerMetre: number): boolean {
  const least = [0, 0.35, 0.25, 0.12, 0.06, 0.03, 0, 0, 0];
  return pixelsPerMetre >= (least[style.rank] ?? 0);
}

export function boundsOf(parts: readonly Point[][]): Box {
  const box = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  for (const part of parts) {
    for (const [x, y] of part) {
      box.left = Math.min(box.left, x);
      box.top = Math.min(box.top, y);
      box.right = Math.max(box.right, x);
      box.bottom = Math.max(box.bottom, y);
    }
  }
  return box;
}

// A street or a kind of green may lie all over the city in parts: those in view can be drawn without the others.
function pieces(feature: Feature): Feature[] {
  const parts = feature.points.filter((part) => part.length > 1);
  const groups = feature.shape === "area" ? nested(parts) : parts.map((part) => [part]);
  return groups.map((points) => ({ ...feature, points }));
}

// Rings with those within them, which are their holes, and islands there.
export function nested(rings: readonly Point[][]): Point[][][] {
  const extent = ({ left, top, right, bottom }: Box): number => (right - left) * (bottom - top);
  const groups: { box: Box; rings: Point[][] }[] = [];
  const known = rings.map((ring) => ({ ring, box: boundsOf([ring]) })).sort((a, b) => extent(b.box) - extent(a.box));
  for (const { ring, box } of known) {
    const group = groups.find((one) => contains(one.box, box));
    if (group) group.rings.push(ring);
    else groups.push({ box, rings: [ring] });
  }
  return groups.map((group) => group.rings);
}

function contains(a: Box, b: Box): boolean {
  return a.left <= b.left && a.top <= b.top && a.right >= b.right && a.bottom >= b.bottom;
}

const bucket = 64; // cells on a side

// Finds the features of a part of the map, in the order of drawing.
export class FeatureIndex {
  readonly features: readonly Feature[];
  readonly bounds: readonly Box[];
  readonly #buckets = new Map<string, number[]>();

  constructor(
    background: Background,
    private readonly map: Size,
  ) {
    this.features = background.features
      .filter((feature) => feature.kind !== "place")
      .flatMap(pieces)
      .sort((a, b) => drawingOrder(a) - drawingOrder(b));
    this.bounds = this.features.map((feature) => boundsOf(feature.points));
    this.bounds.forEach((box, i) => {
      for (const key of this.#keysOver(box)) {
        const entry = this.#buckets.get(key);
        if (entry) entry.push(i);
        else this.#buckets.set(key, [i]);
      }
    });
  }

  over(box: Box): number[] {
    const found = new Set<number>();
    for (const key of this.#keysOver(box)) {
      for (const i of this.#buckets.get(key) ?? []) {
        if (overlap(this.bounds[i]!, box)) found.add(i);
      }
    }
    return [...found].sort((a, b) => a - b);
  }

  // Only on the map: features of the file may reach far beyond it.
  *#keysOver(box: Box): Generator<string> {
    const { left, top, right, bottom } = intersection(box, mapBox(this.map));
    for (let y = Math.floor(top / bucket); y <= Math.floor(bottom / bucket); ++y) {
      for (let x = Math.floor(left / bucket); x <= Math.floor(right / bucket); ++x) yield `${x} ${y}`;
    }
  }
}

function drawingOrder(feature: Feature): number {
  switch (feature.kind) {
    case "green":
      return 0;
    case "water":
      return 1;
    case "street":
      return 2 + streetStyle(feature.class).rank;
    default:
      return 20;
  }
}
