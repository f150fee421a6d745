// What the chosen agent of a team is called and can do.
import { useId } from "preact/hooks";
import { type Agents, type Aircraft, vehiclesOf } from "../domain/agents";
import type { Studio } from "../mission/studio";
import { Name } from "./name";
import { NumberField } from "./number_field";
import { VehicleSize } from "./vehicle_size";

interface Props {
  studio: Studio;
  agents: Agents;
  index: number;
}

export function AgentFields({ studio, agents, index }: Props) {
  const agent = agents[index]!;
  const units = studio.units.value;
  const number = (member: "speed" | "readyAt", value: number) => ({
    value,
    onInput: (given: number) => studio.changeAgent(index, { [member]: given }, `${member} ${index}`),
    onDone: () => studio.endGesture(),
  });
  const isLast = agent.kind === "ground" && vehiclesOf(agents).length === 1;
  return (
    <div class="fields">
      <NameField name={agent.id} onChange={(name) => studio.renameAgent(index, name)} />
      <NumberField
        label="Speed"
        unit={units.metric ? "m/s" : "cells/step"}
        min={0.01}
        max={1000}
        {...number("speed", agent.speed)}
      />
      {agent.kind === "ground" ? (
        <>
          <NumberField
            label="Leaves not before"
            unit={units.metric ? "s" : "steps"}
            min={0}
            max={100_000}
            {...number("readyAt", agent.readyAt)}
          />
          <VehicleSize
            label="Width"
            radius={agent.radius}
            units={units}
            onChange={(radius) => studio.changeAgent(index, { radius })}
          />
        </>
      ) : (
        <AircraftFields studio={studio} aircraft={agent} index={index} />
      )}
      <div class="agent-buttons">
        {agent.kind === "air" && (agent.start || agent.goal) && (
          <button type="button" class="button" onClick={() => studio.bringAircraftBack(index)}>
            Put it to the first vehicle
          </button>
        )}
        <button
          type="button"
          class="button"
          disabled={isLast}
          title={isLast ? "The last vehicle stays" : undefined}
          onClick={() => studio.removeAgent(index)}
        >
          Remove <Name of={agent.id} />
        </button>
      </div>
    </div>
  );
}

function NameField({ name, onChange }: { name: string; onChange: (name: string) => void }) {
  const id = useId();
  return (
    <div class="number-field">
      <label for={id}>Name</label>
      <input
        id={id}
        class="agent-input"
        maxLength={40}
        value={name}
        onChange={(event) => onChange(event.currentTarget.value)}
      />
    </div>
  );
}

function AircraftFields({ studio, aircraft, index }: { studio: Studio; aircraft: Aircraft; index: number }) {
  const id = useId();
  const { breaches } = aircraft;
  const counts = new Set([0, 1, 2, 3, 4, 5, 6, 7, 8, ...(breaches === null ? [] : [breaches])]);
  const set = (value: string) => studio.changeAgent(index, { breaches: value === "" ? null : Number(value) });
  return (
    <div class="number-field">
      <label for={id}>Opens at most</label>
      <select
        id={id}
        value={breaches === null ? "" : String(breaches)}
        onChange={(event) => set(event.currentTarget.value)}
      >
        <option value="">any number</option>
        {[...counts].map((count) => (
          <option key={count} value={String(count)}>
            {count}
          </option>
        ))}
      </select>
    </div>
  );
}
