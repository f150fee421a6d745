// The service no longer has the map: why, and how it gets it again.
import { useRef } from "preact/hooks";
import { isUpload } from "../mission/maps";
import { restoreFrom } from "../mission/opening";
import type { Studio } from "../mission/studio";
import { Icon } from "./icons";

export function LostMapCard({ studio }: { studio: Studio }) {
  const input = useRef<HTMLInputElement>(null);
  const lost = studio.lost.value;
  const { file } = lost ?? { file: null };
  const isShown = lost?.id === studio.mission.value?.map;
  return (
    <div class="lost-place" role="alert">
      {lost && (
        <div class="lost">
          <Icon name="warning" />
          <p>
            <strong>
              The server {isShown || file ? "no longer has" : "does not have"} the map “{lost.name}”.
            </strong>{" "}
            {isUpload(lost.id) && "It keeps maps that are sent to it until it ends, or until others need the room. "}
            {isShown ? "Your mission is kept." : "The mission is opened once the map is there."}
          </p>
          <div class="lost-actions">
            {file && (
              <button type="button" class="button primary" onClick={() => void studio.restore(file)}>
                Send it again
              </button>
            )}
            <button type="button" class={file ? "button" : "button primary"} onClick={() => input.current?.click()}>
              Choose the file…
            </button>
            {!isShown && (
              <button type="button" class="button" onClick={() => (studio.lost.value = null)}>
                Leave it
              </button>
            )}
          </div>
          <input
            ref={input}
            class="spoken"
            type="file"
            multiple
            tabIndex={-1}
            aria-label={`File of ${lost.name}`}
            onChange={(event) => {
              const files = [...(event.currentTarget.files ?? [])];
              event.currentTarget.value = "";
              if (files.length > 0) void restoreFrom(studio, files);
            }}
          />
        </div>
      )}
    </div>
  );
}
