// Keeps badges apart that would cover one another.
import type { Point } from "../../domain/geometry";

const rounds = 24;

// Places for badges, as near to their points as can be found quickly, so that any two are `distance` apart, and each is
// from the points of `fixed` too. Points that are far from all others stay.
export function spread(points: readonly Point[], fixed: readonly Point[], distance: number): Point[] {
  const places = points.map(([x, y]): Point => [x, y]);
  for (let round = 0; round < rounds; ++round) {
    let moved = false;
    places.forEach((place, i) => {
      for (const other of fixed) moved = push(place, other, distance, 1, i) || moved;
      for (let k = 0; k < i; ++k) {
        const before: Point = [...place];
        if (!push(place, places[k]!, distance, 0.5, i)) continue;
        push(places[k]!, before, distance, 0.5, i + Math.PI);
        moved = true;
      }
    });
    if (!moved) break;
  }
  return places;
}

// Moves a place away from another by a share of what is lacking; where both are the same, into the direction given.
function push(place: Point, other: Point, distance: number, share: number, direction: number): boolean {
  const [dx, dy] = [place[0] - other[0], place[1] - other[1]];
  const apart = Math.hypot(dx, dy);
  if (apart >= distance - 0.01) return false;
  const by = share * (distance - apart);
  const [ux, uy] = apart > 1e-6 ? [dx / apart, dy / apart] : [Math.cos(direction), Math.sin(direction)];
  place[0] += by * ux;
  place[1] += by * uy;
  return true;
}
