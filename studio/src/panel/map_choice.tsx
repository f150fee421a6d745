// Which map: one of the server's, or a file of one's own.
import { plainName } from "../domain/plain_name";
import { openFiles } from "../mission/opening";
import type { Studio } from "../mission/studio";
import { FileButton } from "./file_button";
import { Icon } from "./icons";

export function MapChoice({ studio }: { studio: Studio }) {
  const current = studio.page.mission.value?.map ?? "";
  const uploads = studio.maps.uploads.value;
  // The server's list has everybody's uploads and drawings, too.
  const served = studio.maps.list.value.filter((entry) => !entry.uploaded).map((entry) => entry.id);
  const listed = served.includes(current) || uploads.has(current) || current === "";
  return (
    <div class="map-choice">
      <label class="spoken" for="map-choice">
        Choose a map
      </label>
      <select id="map-choice" value={current} onChange={(event) => studio.maps.choose(event.currentTarget.value)}>
        {current === "" && <option value="">No map</option>}
        {!listed && <option value={current}>{current}</option>}
        {served.map((id) => (
          <option key={id} value={id}>
            {titled(id)}
          </option>
        ))}
        {[...uploads].map(([id, file]) => (
          <option key={id} value={id}>
            {plainName(file.name)}
          </option>
        ))}
      </select>
      <FileButton
        title={`${filesTaken(studio)}, a plan or a mission`}
        label="File to open"
        onFiles={(files) => void openFiles(studio, files)}
      >
        <Icon name="open" /> Open file…
      </FileButton>
    </div>
  );
}

// What can be opened beside plans and missions.
export function filesTaken({ client }: Studio): string {
  if (client.imports) return "A map, map data of a city (.osm.pbf, .osm, .geojson), both files of a ROS map";
  return "A map of MovingAI's format (other maps, and map data of a city, need waybreaker serve)";
}

export function nameOfMap(studio: Studio, id: string): string {
  return studio.maps.uploads.value.get(id)?.name ?? titled(id);
}

// berlin-mitte.tif reads better as Berlin mitte.
function titled(id: string): string {
  const words = id.replace(/\.[a-z]+$/i, "").replaceAll(/[-_]+/g, " ");
  return words.replaceAll(/\b[a-z]/g, (letter) => letter.toUpperCase());
}
