// The service no longer has the map: why, and how it gets it again.
import { isUpload } from "../mission/maps";
import { restoreFrom } from "../mission/opening";
import type { Studio } from "../mission/studio";
import { FileButton } from "./file_button";
import { Icon } from "./icons";
import { Name } from "./name";

export function LostMapCard({ studio }: { studio: Studio }) {
  const lost = studio.maps.lost.value;
  const { file } = lost ?? { file: null };
  const isShown = lost?.id === studio.page.mission.value?.map;
  return (
    <div class="lost-place" role="alert">
      {lost && (
        <div class="lost">
          <Icon name="warning" />
          <p>
            <strong>
              The server {isShown || file ? "no longer has" : "does not have"} the map “<Name of={lost.name} />”.
            </strong>{" "}
            {isUpload(lost.id) && "It keeps maps that are sent to it until it ends, or until others need the room. "}
            {isShown ? "Your mission is kept." : "The mission is opened once the map is there."}
          </p>
          <div class="lost-actions">
            {file && (
              <button type="button" class="button primary" onClick={() => void studio.maps.restore(file)}>
                Send it again
              </button>
            )}
            <FileButton
              primary={!file}
              label={`File of ${lost.name}`}
              onFiles={(files) => void restoreFrom(studio, files)}
            >
              Choose the file…
            </FileButton>
            {!isShown && (
              <button type="button" class="button" onClick={() => (studio.maps.lost.value = null)}>
                Leave it
              </button>
            )}
          </div>
        </div>
      )}
    </div>
  );
}
