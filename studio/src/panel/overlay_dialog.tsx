// What is laid over the map: a flood, debris, a closed street.
import type { KeptFile } from "../mission/kept_file";
import type { Overlays, OverlayState, OverlayUse } from "../mission/overlays";
import { useModal } from "./dialogs";
import { Icon } from "./icons";
import { Name } from "./name";
import { NumberField } from "./number_field";

const uses: { use: OverlayUse; name: string; text: string }[] = [
  { use: "water", name: "Water", text: "A flood. Nobody drives in it; bridges stay open." },
  { use: "debris", name: "Debris", text: "Lies on open ground. Each piece can be removed at once." },
  { use: "closed", name: "Closed", text: "A street or an area where nobody may drive, not over its bridges either." },
  { use: "wall", name: "Wall", text: "Stands on open ground. It can be destroyed." },
  { use: "free", name: "Free", text: "Opens what stands there: a house that is gone, a bridge that was laid." },
];

interface OverlayDialogProps {
  overlays: Overlays;
  importInstead: (file: KeptFile) => void;
}

export function OverlayDialog({ overlays, importInstead }: OverlayDialogProps) {
  const state = overlays.state.value;
  const dialog = useModal(state !== null);
  return (
    <dialog
      ref={dialog}
      class="dialog overlay-dialog"
      aria-labelledby="overlay-title"
      onCancel={(event) => {
        event.preventDefault();
        overlays.cancel();
      }}
    >
      {state && <OverlayForm overlays={overlays} state={state} importInstead={importInstead} />}
    </dialog>
  );
}

function OverlayForm({ overlays, state, importInstead }: OverlayDialogProps & { state: OverlayState }) {
  const { file, use, busy, failure } = state;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        const wrong = event.currentTarget.querySelector<HTMLElement>("[aria-invalid=true]");
        if (wrong) wrong.focus();
        else void overlays.finish();
      }}
    >
      <h2 id="overlay-title">
        Lay <Name of={file.name} /> over the map
      </h2>
      <fieldset class="overlay-choices" disabled={busy}>
        <legend>What is it?</legend>
        {uses.map((one) => (
          <label key={one.use} class="profile">
            <input type="radio" name="use" checked={one.use === use} onChange={() => overlays.choose({ use: one.use })} />
            <span>
              <strong>{one.name}</strong>
              {one.text}
            </span>
          </label>
        ))}
        <NumberField
          label="Lines without a width are"
          unit="m"
          min={0.1}
          max={1000}
          value={state.width}
          onInput={(width) => overlays.choose({ width })}
        />
      </fieldset>
      <div class="import-status" role={failure ? "alert" : "status"}>
        {busy && (
          <p>
            <progress aria-label="Progress" /> The map is made …
          </p>
        )}
        {failure && (
          <p class="import-failure">
            <Icon name="warning" /> {failure}
          </p>
        )}
      </div>
      <div class="import-buttons overlay-buttons">
        <button
          type="button"
          class="button overlay-import"
          disabled={busy}
          onClick={() => {
            overlays.cancel();
            importInstead(file);
          }}
        >
          Make a map of it
        </button>
        <button type="button" class="button" onClick={() => overlays.cancel()}>
          Cancel
        </button>
        <button class="button primary" disabled={busy}>
          Lay it over
        </button>
      </div>
    </form>
  );
}
