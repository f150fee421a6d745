// How the mission is planned, and what the two agents can do.
import { useId } from "preact/hooks";
import { type Aircraft, hasPaperMethod, ofPair, type Vehicle, vehiclesOf } from "../domain/agents";
import type { Mission } from "../domain/mission";
import type { Studio } from "../mission/studio";
import { LeavesNotBefore, OpensAtMost } from "./agent_fields";
import { Battery } from "./battery";
import { Segmented } from "./controls";
import { NumberField } from "./number_field";
import { Openings } from "./openings";
import { ProtectAll } from "./protect_all";
import { VehicleSize } from "./vehicle_size";

type NumberMember = "breachTime" | "breachTimePerCell" | "rubble";

export function Settings({ studio }: { studio: Studio }) {
  const mission = studio.page.mission.value;
  if (!mission) return null;
  const units = studio.page.units.value;
  const { metric } = units;
  const set = (part: Partial<Mission>) => studio.editor.change((old) => ({ ...old, ...part }));
  const number = (member: NumberMember, scale = 1) => ({
    value: mission[member] / scale,
    onInput: (value: number) => studio.editor.change((old) => ({ ...old, [member]: value * scale }), member),
    onDone: () => studio.editor.endGesture(),
  });
  const two = ofPair(mission.agents);
  const speed = { unit: metric ? "m/s" : "cells/step", min: 0.01, max: 1000 };
  const time = { min: 0, max: 100_000 };
  const speedOf = (agent: Vehicle | Aircraft) => ({
    value: agent.speed,
    onInput: (value: number) => studio.editor.changeAgent(mission.agents.indexOf(agent), { speed: value }, `${agent.kind} speed`),
    onDone: () => studio.editor.endGesture(),
  });
  const fieldsOf = (agent: Vehicle | Aircraft) => ({ studio, agents: mission.agents, index: mission.agents.indexOf(agent) });
  return (
    <details class="section settings">
      <summary>
        <h2>Mission settings</h2>
      </summary>
      {hasPaperMethod(mission) && (
        <Segmented
          legend="Method"
          choices={[
            { value: "exact", label: "Best found" },
            { value: "paper", label: "The paper’s method (2018)" },
          ]}
          value={mission.method}
          onChange={(method) => set({ method })}
        />
      )}
      <Segmented
        legend="What counts"
        choices={[
          { value: "makespan", label: "Last arrival" },
          { value: "ground-makespan", label: two ? "Robot’s arrival" : "Last vehicle’s" },
          { value: "flowtime", label: "Sum of arrivals" },
        ]}
        value={mission.objective}
        onChange={(objective) => set({ objective })}
      />
      <div class="fields">
        {two && <NumberField label="Ground robot’s speed" {...speed} {...speedOf(two.ground)} />}
        {two && <NumberField label="Aircraft’s speed" {...speed} {...speedOf(two.air)} />}
        <NumberField label="Time to open one" unit={metric ? "s" : "steps"} {...time} {...number("breachTime")} />
        <NumberField
          label={metric ? "… and for each m²" : "… and for each cell"}
          unit={metric ? "s" : "steps"}
          {...time}
          {...number("breachTimePerCell", units.cell * units.cell)}
        />
        <NumberField label="Rubble delay" unit={metric ? "s" : "steps"} {...time} {...number("rubble")} />
        {two && (
          <VehicleSize
            label="Ground robot’s width"
            radius={two.ground.radius}
            units={units}
            onChange={(radius) => studio.editor.changeAgent(mission.agents.indexOf(two.ground), { radius })}
          />
        )}
        {two && <LeavesNotBefore label="Robot leaves not before" {...fieldsOf(two.ground)} />}
        {two && <OpensAtMost label="Aircraft opens at most" {...fieldsOf(two.air)} />}
        {two && <Openings studio={studio} index={mission.agents.indexOf(two.air)} title="What the aircraft opens" />}
        {two && <Battery studio={studio} index={mission.agents.indexOf(two.air)} title="Aircraft’s battery" />}
        {(vehiclesOf(mission.agents).length > 1 || !mission.collisions) && <TeamFields studio={studio} />}
        <ProtectAll studio={studio} />
      </div>
      {two && <AircraftPlace studio={studio} aircraft={two.air} />}
    </details>
  );
}

// What several vehicles need to agree on.
function TeamFields({ studio }: { studio: Studio }) {
  const { atGoal, collisions } = studio.page.mission.value!;
  const id = useId();
  return (
    <>
      <label class="switch" title="Each drives as if it were alone, and two may be in one place">
        <input
          type="checkbox"
          checked={!collisions}
          onChange={(event) => {
            const pass = event.currentTarget.checked;
            studio.editor.change((old) => ({ ...old, collisions: !pass }));
          }}
        />
        <span>Vehicles pass through each other</span>
      </label>
      {collisions ? <Room studio={studio} /> : <Unreached studio={studio} />}
      <div class="number-field">
        <label for={id}>Who has arrived</label>
        <select
          id={id}
          value={atGoal}
          onChange={(event) => {
            const chosen = event.currentTarget.value === "leave" ? "leave" : "stay";
            studio.editor.change((old) => ({ ...old, atGoal: chosen }));
          }}
        >
          <option value="stay">stays there</option>
          <option value="leave">vanishes</option>
        </select>
      </div>
    </>
  );
}

function Room({ studio }: { studio: Studio }) {
  const units = studio.page.units.value;
  return (
    <NumberField
      label="Room between vehicles"
      unit={units.metric ? "m" : "cells"}
      min={0}
      max={32 * units.cell}
      value={studio.page.mission.value!.separation * units.cell}
      onInput={(value) => studio.editor.change((old) => ({ ...old, separation: value / units.cell }), "separation")}
      onDone={() => studio.editor.endGesture()}
    />
  );
}

// Empty: each vehicle has to arrive.
function Unreached({ studio }: { studio: Studio }) {
  const set = (unreached: number | null) => studio.editor.change((old) => ({ ...old, unreached }), "unreached");
  return (
    <NumberField
      label="A place not reached counts as"
      unit={studio.page.units.value.metric ? "s" : "steps"}
      min={1}
      max={100_000_000}
      value={studio.page.mission.value!.unreached}
      empty="no plan"
      onInput={set}
      onClear={() => set(null)}
      onDone={() => studio.editor.endGesture()}
    />
  );
}

function AircraftPlace({ studio, aircraft }: { studio: Studio; aircraft: Aircraft }) {
  const index = studio.page.mission.value!.agents.indexOf(aircraft);
  return (
    <p class="aircraft-place">
      {aircraft.start || aircraft.goal ? (
        <button type="button" class="button" onClick={() => studio.editor.bringAircraftBack(index)}>
          Put the aircraft back to the robot’s start and goal
        </button>
      ) : (
        "To start or land the aircraft elsewhere, pull its small marker off the start or the goal."
      )}
    </p>
  );
}
