// Importing a map from map data: where, for whom, how fine.
import { useMemo } from "preact/hooks";
import { cellsOf, Extract, type ImportRequest, isOpenStreetMap, leastWindow, type Profile } from "../domain/extract";
import type { Importer, ImportState } from "../mission/importer";
import { Segmented } from "./controls";
import { useModal } from "./dialogs";
import { ExtractMap } from "./extract_map";
import { Icon } from "./icons";
import { Name } from "./name";
import { NumberField } from "./number_field";
import { Shielded } from "./shielded";

const profiles: { profile: Profile; name: string; text: string }[] = [
  { profile: "rover", name: "Rover", text: "A small robot on wheels: pavements and open ground, no motorways, railways or steps." },
  { profile: "truck", name: "Truck", text: "2.55 m wide, 4 m high, 40 t: stays on roads, tracks and car parks, and crosses what is removed." },
  { profile: "walker", name: "Walker", text: "A robot with legs: takes steps and stiles as well." },
  { profile: "paper", name: "Buildings only", text: "Nothing but buildings bars the way, as in the paper of 2018." },
];

export function ImportDialog({ importer }: { importer: Importer }) {
  const state = importer.state.value;
  const dialog = useModal(state !== null);
  return (
    <dialog
      ref={dialog}
      class="dialog import-dialog"
      aria-labelledby="import-title"
      onCancel={(event) => {
        event.preventDefault();
        importer.cancel();
      }}
    >
      {state && <ImportForm importer={importer} state={state} />}
    </dialog>
  );
}

function ImportForm({ importer, state }: { importer: Importer; state: ImportState }) {
  const { source, request, stage, failure } = state;
  const busy = stage === "sending" || stage === "importing";
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        const wrong = event.currentTarget.querySelector<HTMLElement>("[aria-invalid=true]");
        if (wrong) wrong.focus();
        else void importer.finish();
      }}
    >
      <h2 id="import-title">
        Make a map from <Name of={state.name} />
      </h2>
      {source && request && (
        <Shielded onFailure={() => importer.fail()}>
          <fieldset class="import-choices" disabled={busy}>
            <Window importer={importer} source={source} request={request} />
            <Vehicle importer={importer} request={request} />
          </fieldset>
        </Shielded>
      )}
      <div class="import-status" role={failure ? "alert" : "status"}>
        {busy && (
          <p>
            <progress aria-label="Progress" /> {stage === "sending" ? "The server reads the file …" : "The map is made …"}
          </p>
        )}
        {failure && (
          <p class="import-failure">
            <Icon name="warning" /> {failure}
          </p>
        )}
      </div>
      <div class="import-buttons">
        <button type="button" class="button" onClick={() => importer.cancel()}>
          Cancel
        </button>
        {stage !== "failed" && (
          <button class="button primary" disabled={stage !== "choosing"}>
            Import
          </button>
        )}
      </div>
    </form>
  );
}

interface WindowProps {
  importer: Importer;
  source: NonNullable<ImportState["source"]>;
  request: ImportRequest;
}

function Window({ importer, source, request }: WindowProps) {
  const extract = useMemo(() => new Extract(source), [source]);
  const set = (part: Partial<ImportRequest>) => importer.choose(part);
  const degrees = { unit: "°", min: -180, max: 180 };
  const [lon, lat] = request.center;
  const cells = cellsOf(request);
  return (
    <div class="import-window">
      <p>
        {source.buildings.toLocaleString("en")} buildings; the stronger the shade, the closer they stand. Drag the window, or
        its corner.
      </p>
      <ExtractMap extract={extract} request={request} onChange={set} />
      <div class="import-fields">
        <NumberField label="Longitude" {...degrees} value={lon} onInput={(to) => set({ center: [to, lat] })} />
        <NumberField label="Latitude" {...degrees} min={-80} max={80} value={lat} onInput={(to) => set({ center: [lon, to] })} />
        <NumberField
          label="Side"
          unit="m"
          min={leastWindow}
          max={extract.mostSide}
          value={request.size}
          onInput={(size) => set({ size })}
        />
        <NumberField
          label="Size of a cell"
          unit="m"
          min={0.1}
          max={100}
          value={request.cell}
          onInput={(cell) => set({ cell })}
        />
      </div>
      <p class="import-note">
        {cells} × {cells} cells
      </p>
      {request.profile !== "paper" && isOpenStreetMap(source) && extract.reachesBeyond(request) && (
        <Beyond request={request} set={set} />
      )}
    </div>
  );
}

// The window reaches beyond the data.
function Beyond({ request, set }: { request: ImportRequest; set: (part: Partial<ImportRequest>) => void }) {
  return (
    <label class="import-beyond">
      <input
        type="checkbox"
        checked={request.unknown_free ?? false}
        onChange={(event) => set({ unknown_free: event.currentTarget.checked })}
      />
      <span>The window reaches beyond the data. Nobody knows what is there, so it bars the way. Drive there all the same</span>
    </label>
  );
}

function Vehicle({ importer, request }: { importer: Importer; request: ImportRequest }) {
  const set = (part: Partial<ImportRequest>) => importer.choose(part);
  const whole = request.section === "none";
  return (
    <div class="import-vehicle">
      <fieldset class="profiles">
        <legend>Who drives</legend>
        {profiles.map(({ profile, name, text }) => (
          <label key={profile} class="profile">
            <input
              type="radio"
              name="profile"
              checked={request.profile === profile}
              onChange={() => set({ profile, section: profile === "paper" ? "none" : 20 })}
            />
            <span>
              <strong>{name}</strong>
              {text}
            </span>
          </label>
        ))}
      </fieldset>
      <Segmented
        legend="What one opening clears"
        choices={[
          { value: "square", label: "A piece" },
          { value: "whole", label: "A whole building" },
        ]}
        value={whole ? "whole" : "square"}
        onChange={(value) => set({ section: value === "whole" ? "none" : 20 })}
      />
      {request.section !== "none" && (
        <NumberField
          label="Pieces are squares of"
          unit="m"
          min={request.cell}
          max={1000}
          value={request.section}
          onInput={(section) => set({ section })}
        />
      )}
    </div>
  );
}
