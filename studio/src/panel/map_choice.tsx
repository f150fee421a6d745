// Which map: one of the server's, or a file of one's own.
import { useRef } from "preact/hooks";
import { openFiles } from "../mission/opening";
import type { Studio } from "../mission/studio";
import { Icon } from "./icons";

export function MapChoice({ studio }: { studio: Studio }) {
  const input = useRef<HTMLInputElement>(null);
  const current = studio.mission.value?.map ?? "";
  const uploads = studio.uploads.value;
  // The server's list has everybody's uploads and drawings, too.
  const served = studio.mapList.value.filter((entry) => !entry.uploaded).map((entry) => entry.id);
  const listed = served.includes(current) || uploads.has(current) || current === "";
  return (
    <div class="map-choice">
      <label class="spoken" for="map-choice">
        Choose a map
      </label>
      <select id="map-choice" value={current} onChange={(event) => studio.choose(event.currentTarget.value)}>
        {current === "" && <option value="">No map</option>}
        {!listed && <option value={current}>{current}</option>}
        {served.map((id) => (
          <option key={id} value={id}>
            {titled(id)}
          </option>
        ))}
        {[...uploads].map(([id, file]) => (
          <option key={id} value={id}>
            {file.name}
          </option>
        ))}
      </select>
      <button
        type="button"
        class="button"
        title="A map, both files of a ROS map, a plan or a mission"
        onClick={() => input.current?.click()}
      >
        <Icon name="open" /> Open file…
      </button>
      <input
        ref={input}
        class="spoken"
        type="file"
        multiple
        tabIndex={-1}
        aria-label="File to open"
        onChange={(event) => {
          const files = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = "";
          if (files.length > 0) void openFiles(studio, files);
        }}
      />
    </div>
  );
}

export function nameOfMap(studio: Studio, id: string): string {
  return studio.uploads.value.get(id)?.name ?? titled(id);
}

// berlin-mitte.tif reads better as Berlin mitte.
function titled(id: string): string {
  const words = id.replace(/\.[a-z]+$/i, "").replaceAll(/[-_]+/g, " ");
  return words.replaceAll(/\b[a-z]/g, (letter) => letter.toUpperCase());
}
