// What an obstacle is called.
import type { HeldMap } from "../mission/maps";
import { nounOf } from "../mission/words";

export interface ObstacleName {
  text: string;
  osm: { href: string; text: string } | null; // its page at OpenStreetMap
}

export function hasBuildings(map: HeldMap): boolean {
  return map.description.georeference !== null && map.cells.obstacles.some((one) => one.source_id !== 0);
}

export function nameOf(map: HeldMap, id: number): ObstacleName {
  const obstacle = map.cells.obstacle(id);
  const source = obstacle?.source_id ?? 0;
  if (!obstacle || source === 0) return { text: obstacle?.name || `Obstacle ${id}`, osm: null };
  const kind = source > 0 ? "way" : "relation";
  const number = Math.abs(source);
  const noun = nounOf(1, hasBuildings(map));
  return {
    text: obstacle.name || `${noun.charAt(0).toUpperCase()}${noun.slice(1)} ${id}`,
    osm: { href: `https://www.openstreetmap.org/${kind}/${number}`, text: `OSM ${number}` },
  };
}
