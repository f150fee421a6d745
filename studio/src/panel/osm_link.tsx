// To an obstacle's page at OpenStreetMap: a plain link, nothing is fetched before it is followed.
import type { ObstacleName } from "./obstacle_words";

export function OsmLink({ name }: { name: ObstacleName }) {
  if (!name.osm) return null;
  return (
    <a class="osm-link" href={name.osm.href} target="_blank" rel="noreferrer">
      {name.osm.text}
    </a>
  );
}
