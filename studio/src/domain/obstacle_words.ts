// What an obstacle is, in words, from what the source of the map says of it.
import type { Kind, Obstacle, Structure } from "./map";
import { filterText, type TagFilter } from "./tag_filter";
import { isUnknown } from "./unknown_ground";

const kinds: Record<Kind, string> = {
  unknown: "obstacle",
  building: "building",
  barrier: "wall or fence",
  water: "water",
  cliff: "cliff or ditch",
  forbidden: "forbidden ground",
  off_road: "ground off the roads",
};

export function kindWord(kind: Kind): string {
  return kinds[kind];
}

// "building", "hedge", "section of 2 buildings and a wall or fence".
export function whatItIs(obstacle: Obstacle): string {
  const { structures } = obstacle;
  if (structures && structures.length > 0) return `section of ${partsOf(structures)}`;
  if (isUnknown(obstacle)) return "unknown ground";
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
  const plurals: Partial<Record<Kind, string>> = { barrier: "walls or fences", cliff: "cliffs or ditches" };
  return plurals[kind] ?? `${kindWord(kind)}s`;
}

// Values of building=* that say what it is for, and not only how it is built.
const publicBuildings = new Set([
  ...["hospital", "school", "kindergarten", "university", "college", "museum", "government", "train_station"],
  ...["church", "chapel", "cathedral", "mosque", "synagogue", "temple", "shrine", "religious", "fire_station"],
]);

// What people use it for, as the source's tags say: "school", "place of worship", "heritage".
export function usesOf(obstacle: Obstacle): string[] {
  return [...new Set(tagsOfUse(obstacle).map(([use]) => use))];
}

// With the tags that say so.
function tagsOfUse(obstacle: Obstacle): [use: string, tag: TagFilter][] {
  if (!obstacle.tags?.length) return [];
  const said = ["amenity", "tourism", "historic", "building"].flatMap((key) =>
    valuesOf(obstacle, key)
      .filter((value) => (key === "building" ? publicBuildings.has(value) : value !== "yes"))
      .map((value): [string, TagFilter] => [value.replaceAll("_", " "), { key, values: [value] }]),
  );
  return valuesOf(obstacle, "heritage").length > 0 ? [...said, ["heritage", { key: "heritage", values: [] }]] : said;
}

export interface Use {
  name: string;
  obstacles: number; // how many of those that can be removed people use so
  rules: TagFilter[]; // which mean them
}

export function usesAmong(obstacles: readonly Obstacle[]): Use[] {
  const found = new Map<string, { ids: Set<number>; rules: Map<string, TagFilter> }>();
  for (const obstacle of obstacles) {
    if (!obstacle.destructible) continue;
    for (const [name, rule] of tagsOfUse(obstacle)) {
      const use = found.get(name) ?? { ids: new Set(), rules: new Map() };
      found.set(name, use);
      use.ids.add(obstacle.id);
      use.rules.set(filterText(rule), rule);
    }
  }
  const uses = [...found].map(([name, { ids, rules }]): Use => ({ name, obstacles: ids.size, rules: [...rules.values()] }));
  return uses.sort((a, b) => (a.name < b.name ? -1 : 1));
}

function valuesOf({ tags = [] }: Obstacle, key: string): string[] {
  const start = `${key}=`;
  return tags.filter((tag) => tag.startsWith(start) && tag !== `${start}no`).map((tag) => tag.slice(start.length));
}

// What else is to be said of an obstacle than what it is called, where the map says so.
export function factsOf(obstacle: Obstacle, called: string): string[] {
  if (obstacle.kind === undefined || obstacle.kind === "unknown") return [];
  const what = whatItIs(obstacle).replaceAll("_", " ");
  const isCalledSo = called.replace(/ \d+$/, "").toLowerCase() === what.toLowerCase(); // as those without a name are
  const uses = obstacle.destructible ? usesOf(obstacle).filter((use) => use !== what) : [];
  return isCalledSo ? uses : [what.charAt(0).toUpperCase() + what.slice(1), ...uses];
}

// Why it has to stay; null if it can be removed.
export function whyItStays(obstacle: Obstacle): string | null {
  if (obstacle.destructible) return null;
  if (isUnknown(obstacle)) return "There is no data of it: nobody knows what is there.";
  switch (obstacle.kind) {
    case "water":
      return "Water: nothing that is opened leads across it.";
    case "cliff":
      return "A cliff, a ditch, a city wall or a retaining wall: it cannot be removed.";
    case "forbidden":
      return "Forbidden ground, such as a motorway, a railway or private land: it cannot be opened.";
    case "off_road":
      return "Off the roads: a truck drives there only where something is removed.";
    default: {
      const uses = usesOf(obstacle);
      return uses.length > 0 ? `The map protects it (${uses.join(", ")}): it cannot be removed.` : "It cannot be removed.";
    }
  }
}
