// Ground of which nobody knows what is there: beyond the data of an import, or unseen by a robot.
import type { Obstacle } from "./map";

const unknownTag = "occupancy=unknown";

export function isUnknown({ tags }: Pick<Obstacle, "tags">): boolean {
  return tags?.includes(unknownTag) ?? false;
}

// How much of a map that is, from 0 to 1, and what it means for those who drive; null if everything is known.
export function unknownSentence(share: number, barsTheWay: boolean): string | null {
  if (!(share > 0)) return null;
  const percent = share < 0.001 ? "Less than 0.1" : (100 * share).toFixed(1);
  return `${percent} % of this map is unknown ground, without data: it ${barsTheWay ? "bars the way" : "counts as free"}.`;
}
