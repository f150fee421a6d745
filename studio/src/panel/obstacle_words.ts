// What an obstacle is called: as on the map before anything was drawn, so that its name stays.
import type { Obstacle } from "../domain/map";
import { whatItIs } from "../domain/obstacle_words";
import { isUnknown } from "../domain/unknown_ground";
import type { ShownMap } from "../mission/maps";

export interface ObstacleName {
  text: string;
  osm: { href: string; text: string } | null; // its page at OpenStreetMap
}

// Only where a map is OpenStreetMap's, and not cut into sections, are obstacles sure to be buildings; or where it says so.
export function hasBuildings(shown: ShownMap): boolean {
  const { description, cells } = shown.base;
  if (description.obstacles.sections) return false;
  if (cells.obstacles.some((one) => one.kind !== undefined)) {
    return cells.obstacles.every((one) => !one.destructible || one.kind === "building");
  }
  return description.georeference !== null && cells.obstacles.some((one) => one.source_id !== 0);
}

export function areBuildings(shown: ShownMap, ids: readonly number[]): boolean {
  const isBuilding = (id: number) => {
    const obstacle = shown.map.cells.obstacle(id);
    return obstacle?.kind === undefined ? (obstacle?.source_id ?? 0) !== 0 : obstacle.kind === "building";
  };
  return hasBuildings(shown) && ids.every(isBuilding);
}

// Of an obstacle of the map shown.
export function nameOf(shown: ShownMap, id: number): ObstacleName {
  return nameOfKey(shown, shown.ids.toBase(id));
}

export function nameOfKey(shown: ShownMap, key: number): ObstacleName {
  if (key < 0) return { text: "Drawn wall", osm: null };
  const obstacle = shown.base.cells.obstacle(key);
  return {
    text: obstacle?.name || `${obstacle ? nounFor(shown, obstacle) : "Obstacle"} ${key}`,
    osm: osmPage(obstacle?.source_id ?? 0),
  };
}

function nounFor(shown: ShownMap, obstacle: Obstacle): string {
  if (obstacle.structures) return "Section";
  const { kind } = obstacle;
  if (!isUnknown(obstacle) && (kind === undefined || kind === "unknown")) return obstacle.source_id !== 0 && hasBuildings(shown) ? "Building" : "Obstacle";
  const what = whatItIs(obstacle).replaceAll("_", " ");
  return what.charAt(0).toUpperCase() + what.slice(1);
}

// Of an id of OpenStreetMap: ways positive, relations negative; null for 0.
export function osmPage(source: number): ObstacleName["osm"] {
  if (source === 0) return null;
  const number = Math.abs(source);
  return { href: `https://www.openstreetmap.org/${source > 0 ? "way" : "relation"}/${number}`, text: `OSM ${number}` };
}
