// What an obstacle is called: as on the map before anything was drawn, so that its name stays.
import type { ShownMap } from "../mission/maps";

export interface ObstacleName {
  text: string;
  osm: { href: string; text: string } | null; // its page at OpenStreetMap
}

// Only where a map is OpenStreetMap's, and not cut into sections, are obstacles sure to be buildings.
export function hasBuildings(shown: ShownMap): boolean {
  const { description, cells } = shown.base;
  if (description.obstacles.sections) return false;
  return description.georeference !== null && cells.obstacles.some((one) => one.source_id !== 0);
}

export function areBuildings(shown: ShownMap, ids: readonly number[]): boolean {
  return hasBuildings(shown) && ids.every((id) => (shown.map.cells.obstacle(id)?.source_id ?? 0) !== 0);
}

// Of an obstacle of the map shown.
export function nameOf(shown: ShownMap, id: number): ObstacleName {
  return nameOfKey(shown, shown.ids.toBase(id));
}

export function nameOfKey(shown: ShownMap, key: number): ObstacleName {
  if (key < 0) return { text: "Drawn wall", osm: null };
  const obstacle = shown.base.cells.obstacle(key);
  const source = obstacle?.source_id ?? 0;
  if (!obstacle || source === 0) return { text: obstacle?.name || `Obstacle ${key}`, osm: null };
  const kind = source > 0 ? "way" : "relation";
  const number = Math.abs(source);
  return {
    text: obstacle.name || `${hasBuildings(shown) ? "Building" : "Obstacle"} ${key}`,
    osm: { href: `https://www.openstreetmap.org/${kind}/${number}`, text: `OSM ${number}` },
  };
}
