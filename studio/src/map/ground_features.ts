// The ground below the obstacles: which of its features are where, in which order and how wide.
import type { Background, Feature, Point } from "../api/answers";
import type { Box } from "./camera";

export interface StreetStyle {
  metres: number;
  rank: number; // those of higher rank lie above, and are seen from farther away
  onFoot: boolean;
}

const streets: Record<string, StreetStyle> = {
  motorway: { metres: 22, rank: 8, onFoot: false },
  trunk: { metres: 20, rank: 8, onFoot: false },
  primary: { metres: 17, rank: 7, onFoot: false },
  secondary: { metres: 14, rank: 6, onFoot: false },
  tertiary: { metres: 11, rank: 5, onFoot: false },
  residential: { metres: 8, rank: 4, onFoot: false },
  unclassified: { metres: 8, rank: 4, onFoot: false },
  living_street: { metres: 7, rank: 4, onFoot: false },
  pedestrian: { metres: 7, rank: 3, onFoot: false },
  service: { metres: 4, rank: 2, onFoot: false },
  track: { metres: 3, rank: 1, onFoot: true },
  footway: { metres: 2, rank: 1, onFoot: true },
  cycleway: { metres: 2, rank: 1, onFoot: true },
  path: { metres: 2, rank: 1, onFoot: true },
  steps: { metres: 2, rank: 1, onFoot: true },
};

export function streetStyle(street: string): StreetStyle {
  return streets[street.replace(/_link$/, "")] ?? streets.unclassified!;
}

// Whether a street is drawn at so many pixels per metre: a city seen whole would be all alleys.
export function streetShows(style: StreetStyle, pixelsPerMetre: number): boolean {
  const least = [0, 0.35, 0.25, 0.12, 0.06, 0.03, 0, 0, 0];
  return pixelsPerMetre >= (least[style.rank] ?? 0);
}

export function boundsOf(parts: Point[][]): Box {
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

export function overlap(a: Box, b: Box): boolean {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

const bucket = 64; // cells on a side

// Finds the features of a part of the map, in the order of drawing.
export class FeatureIndex {
  readonly features: readonly Feature[];
  readonly bounds: readonly Box[];
  readonly #buckets = new Map<string, number[]>();

  constructor(background: Background) {
    this.features = background.features
      .filter((feature) => feature.kind !== "place" && feature.points.some((part) => part.length > 0))
      .sort((a, b) => drawingOrder(a) - drawingOrder(b));
    this.bounds = this.features.map((feature) => boundsOf(feature.points));
    this.bounds.forEach((box, i) => {
      for (const key of keysOver(box)) {
        const entry = this.#buckets.get(key);
        if (entry) entry.push(i);
        else this.#buckets.set(key, [i]);
      }
    });
  }

  over(box: Box): number[] {
    const found = new Set<number>();
    for (const key of keysOver(box)) {
      for (const i of this.#buckets.get(key) ?? []) {
        if (overlap(this.bounds[i]!, box)) found.add(i);
      }
    }
    return [...found].sort((a, b) => a - b);
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

function* keysOver(box: Box): Generator<string> {
  for (let y = Math.floor(box.top / bucket); y <= Math.floor(box.bottom / bucket); ++y) {
    for (let x = Math.floor(box.left / bucket); x <= Math.floor(box.right / bucket); ++x) yield `${x} ${y}`;
  }
}
