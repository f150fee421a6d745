// The places of a mission that can be dragged. An air marker without a place of its own sits beside the ground one as a
// small handle, by which it can be pulled off.
import type { Point } from "../../domain/geometry";
import { cellOf, type Handle, handles, isAir, type Markers } from "../../domain/mission";

export interface Spot {
  handle: Handle;
  at: Point; // pixels
  attached: boolean; // an air marker that sits with the ground one
}

const reach = 24; // pixels around a marker within which a finger meets it

// Where markers are drawn; `toPixels` as the camera has it.
export function spots(markers: Markers, toPixels: (point: Point) => Point): Spot[] {
  return handles.map((handle) => {
    const [x, y] = toPixels(cellOf(markers, handle));
    const attached = isAir(handle) && markers[handle] === undefined;
    return { handle, at: attached ? [x + 17, y - 17] : [x, y], attached };
  });
}

export function spotAt(all: readonly Spot[], [x, y]: Point): Spot | null {
  let best: Spot | null = null;
  let distance = reach;
  for (const spot of all) {
    const away = Math.hypot(spot.at[0] - x, spot.at[1] - y);
    if (away >= distance) continue;
    best = spot;
    distance = away;
  }
  return best;
}
