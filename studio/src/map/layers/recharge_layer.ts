// Where aircraft recharge: a plate with a battery on it, told by its shape and not by its colour.
import { basesOf } from "../../domain/agents";
import type { Scene } from "../../domain/scene";
import { type Frame, place } from "../viewport/frame";

const half = 8; // pixels

// A battery around the origin, to be filled by the even-odd rule: its case, what is in it, its pole.
export const batteryShape = "M-5.5-4H4.5V4H-5.5ZM-4-2.5V2.5H3V-2.5ZM-3-1.5H0.5V1.5H-3ZM4.5-1.5H6V1.5H4.5Z";

export function drawBases(frame: Frame, { agents }: Scene): void {
  const { context, theme } = frame;
  const bases = basesOf(agents);
  if (bases.length === 0) return;
  const battery = new Path2D(batteryShape);
  for (const base of bases) {
    context.save();
    context.translate(...place(frame, base));
    context.beginPath();
    context.roundRect(-half, -half, 2 * half, 2 * half, 3);
    context.strokeStyle = theme.halo;
    context.lineWidth = 5;
    context.stroke();
    context.fillStyle = theme.card;
    context.fill();
    context.strokeStyle = theme.airLine;
    context.lineWidth = 2;
    context.stroke();
    context.fillStyle = theme.airLine;
    context.fill(battery, "evenodd");
    context.restore();
  }
}
