// In which corner of the map a card hides least of what the plan is about.
import type { Box, Point, Size } from "../domain/geometry";

export const corners = ["top right", "bottom right", "top left", "bottom left"] as const;
export type Corner = (typeof corners)[number];

// What stands in the corners already: pixels from the sides of the map to the card, as the style sheet has them.
const insets: Record<Corner, [across: number, down: number]> = {
  "top right": [14, 14],
  "bottom right": [14, 76],
  "top left": [14, 64],
  "bottom left": [64, 46],
};
const around = 18; // pixels: points are markers and badges

// The one it is in already, if it hides nothing there.
export function bestCorner(card: Size, view: Size, points: readonly Point[], now: Corner): Corner {
  const hidden = (corner: Corner) => {
    const { left, top, right, bottom } = boxOf(card, view, corner);
    return points.filter(([x, y]) => x > left && x < right && y > top && y < bottom).length;
  };
  if (hidden(now) === 0) return now;
  return corners.reduce((best, corner) => (hidden(corner) < hidden(best) ? corner : best));
}

function boxOf(card: Size, view: Size, corner: Corner): Box {
  const [across, down] = insets[corner];
  const left = corner.endsWith("left") ? across : view.width - across - card.width;
  const top = corner.startsWith("top") ? down : view.height - down - card.height;
  return { left: left - around, top: top - around, right: left + card.width + around, bottom: top + card.height + around };
}
