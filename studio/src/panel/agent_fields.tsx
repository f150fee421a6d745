// What an agent is called and can do.
import { useId } from "preact/hooks";
import { type Agents, type Vehicle, vehiclesOf } from "../domain/agents";
import type { Studio } from "../mission/studio";
import { Battery } from "./battery";
import { Name } from "./name";
import { NumberField } from "./number_field";
import { Openings } from "./openings";
import { VehicleSize } from "./vehicle_size";

interface Props {
  studio: Studio;
  agents: Agents;
  index: number;
}

export function AgentFields({ studio, agents, index }: Props) {
  const agent = agents[index]!;
  const units = studio.page.units.value;
  const isLast = agent.kind === "ground" && vehiclesOf(agents).length === 1;
  return (
    <div class="fields">
      <NameField name={agent.id} onChange={(name) => studio.editor.renameAgent(index, name)} />
      <NumberField
        label="Speed"
        unit={units.metric ? "m/s" : "cells/step"}
        min={0.01}
        max={1000}
        value={agent.speed}
        onInput={(speed) => studio.editor.changeAgent(index, { speed }, `speed ${index}`)}
        onDone={() => studio.editor.endGesture()}
      />
      {agent.kind === "ground" ? (
        <>
          <OpensAtMost
            studio={studio}
            agents={agents}
            index={index}
            label={agents.length === 1 ? "Opens in its way" : "Opens at most"}
          />
          <Openings studio={studio} index={index} />
          <LeavesNotBefore studio={studio} agents={agents} index={index} />
          <VehicleSize
            label="Width"
            radius={agent.radius}
            units={units}
            onChange={(radius) => studio.editor.changeAgent(index, { radius })}
          />
        </>
      ) : (
        <>
          <OpensAtMost studio={studio} agents={agents} index={index} />
          <Openings studio={studio} index={index} />
          <Battery studio={studio} index={index} />
        </>
      )}
      <NumberField
        label="Weight in the sum"
        unit=""
        min={0}
        max={1_000_000_000}
        value={agent.weight}
        onInput={(weight) => studio.editor.changeAgent(index, { weight }, `weight ${index}`)}
        onDone={() => studio.editor.endGesture()}
      />
      <div class="agent-buttons">
        {agent.kind === "air" && (agent.start || agent.goal) && (
          <button type="button" class="button" onClick={() => studio.editor.bringAircraftBack(index)}>
            Put it to the first vehicle
          </button>
        )}
        <button
          type="button"
          class="button"
          disabled={isLast}
          title={isLast ? "The last vehicle stays" : undefined}
          onClick={() => studio.editor.removeAgent(index)}
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

export function LeavesNotBefore({ studio, agents, index, label = "Leaves not before" }: Props & { label?: string }) {
  const { readyAt } = agents[index] as Vehicle;
  return (
    <NumberField
      label={label}
      unit={studio.page.units.value.metric ? "s" : "steps"}
      min={0}
      max={100_000}
      value={readyAt}
      onInput={(given) => studio.editor.changeAgent(index, { readyAt: given }, `readyAt ${index}`)}
      onDone={() => studio.editor.endGesture()}
    />
  );
}

export function OpensAtMost({ studio, agents, index, label = "Opens at most" }: Props & { label?: string }) {
  const id = useId();
  const { breaches, kind } = agents[index]!;
  const counts = new Set([0, 1, 2, 3, 4, 5, 6, 7, 8, ...(breaches === null ? [] : [breaches])]);
  const set = (value: string) => studio.editor.changeAgent(index, { breaches: value === "" ? null : Number(value) });
  return (
    <div class="number-field">
      <label for={id}>{label}</label>
      <select
        id={id}
        value={breaches === null ? "" : String(breaches)}
        onChange={(event) => set(event.currentTarget.value)}
      >
        {kind === "air" && <option value="">any number</option>}
        {[...counts].map((count) => (
          <option key={count} value={String(count)}>
            {count}
          </option>
        ))}
      </select>
    </div>
  );
}
