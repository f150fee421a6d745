// The camera on its way from one place to another.
import type { Camera } from "./camera";

const milliseconds = 220;

export class Glide {
  constructor(
    private readonly from: Camera,
    readonly to: Camera,
    private readonly since: number,
  ) {}

  ends(now: number): boolean {
    return now - this.since >= milliseconds;
  }

  at(now: number): Camera {
    const { from, to } = this;
    const share = Math.min(Math.max((now - this.since) / milliseconds, 0), 1);
    if (share === 1) return to;
    const eased = 1 - (1 - share) ** 3;
    const scale = from.scale * (to.scale / from.scale) ** eased;
    // The point that the zoom is about stays where it is on the way.
    const way = from.scale === to.scale ? eased : (1 / from.scale - 1 / scale) / (1 / from.scale - 1 / to.scale);
    return { x: from.x + (to.x - from.x) * way, y: from.y + (to.y - from.y) * way, scale };
  }
}
