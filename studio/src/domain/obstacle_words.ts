// What an obstacle is, in words, from what the source of the map says of it.
import type { Kind, Obstacle, Structure } from "./map";

const kinds: Record<Kind, string> = {
  unknown: "obstacle",
  building: "building",
  barrier: "wall or fence",
  water: "water",
  cliff: "step of the ground",
  forbidden: "forbidden ground",
};

export function kindWord(kind: Kind): string {
  return kinds[kind];
}

// "building", "hedge", "section of 2 buildings and a wall or fence".
export function whatItIs(obstacle: Obstacle): string {
  const { structures } = obstacle;
  if (structures && structures.length > 0) return `section of ${partsOf(structures)}`;
  const barrier = valuesOf(obstacle, "barrier")[0];
  return barrier && barrier !== "yes" ? barrier : kindWord(obstacle.kind ?? "unknown");
}

function partsOf(structures: readonly Structure[]): string {
  const counts = new Map<Kind, number>();
  for (const { kind } of structures) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  const parts = [...counts].map(([kind, count]) => (count === 1 ? `a ${kindWord(kind)}` : `${count} ${pluralOf(kind)}`));
  return parts.length < 2 ? parts.join("") : `${parts.slice(0, -1).join(", ")} and ${parts.at(-1)}`;
}

function pluralOf(kind: Kind): string {
  return kind === "barrier" ? "walls or fences" : `${kindWord(kind)}s`;
}

// Values of building=* that say what it is for, and not only how it is built.
const publicBuildings = new Set([
  ...["hospital", "school", "kindergarten", "university", "college", "museum", "government", "train_station"],
  ...["church", "chapel", "cathedral", "mosque", "synagogue", "temple", "shrine", "religious", "fire_station"],
]);

// What people use it for, as the source's tags say: "school", "place of worship", "heritage".
export function usesOf(obstacle: Obstacle): string[] {
  const values = ["amenity", "tourism", "historic"].flatMap((key) => valuesOf(obstacle, key));
  const buildings = valuesOf(obstacle, "building").filter((value) => publicBuildings.has(value));
  const words = [...values.filter((value) => value !== "yes"), ...buildings].map((value) => value.replaceAll("_", " "));
  if (valuesOf(obstacle, "heritage").length > 0) words.push("heritage");
  return [...new Set(words)];
}

// Which of those that can be removed people use for what, by name of the use.
export function obstaclesByUse(obstacles: readonly Obstacle[]): Map<string, number[]> {
  const found = new Map<string, number[]>();
  for (const obstacle of obstacles) {
    if (!obstacle.destructible) continue;
    for (const use of usesOf(obstacle)) found.set(use, [...(found.get(use) ?? []), obstacle.id]);
  }
  return new Map([...found].sort(([a], [b]) => (a < b ? -1 : 1)));
}

function valuesOf({ tags = [] }: Obstacle, key: string): string[] {
  return tags.filter((tag) => tag.startsWith(`${key}=`)).map((tag) => tag.slice(key.length + 1));
}

// Why it has to stay; null if it can be removed.
export function whyItStays(obstacle: Obstacle): string | null {
  if (obstacle.destructible) return null;
  switch (obstacle.kind) {
    case "water":
      return "Water: nothing that is opened leads across it.";
    case "cliff":
      return "A step of the ground, such as a cliff, a retaining wall or a ditch: it cannot be removed.";
    case "forbidden":
      return "Forbidden ground, such as a motorway, a railway or private land: it cannot be opened.";
    default: {
      const uses = usesOf(obstacle);
      return uses.length > 0 ? `The map protects it (${uses.join(", ")}): it cannot be removed.` : "It cannot be removed.";
    }
  }
}
