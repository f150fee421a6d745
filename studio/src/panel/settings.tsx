// How the mission is planned, and what the two agents can do.
import type { Mission } from "../domain/mission";
import { length, type Units } from "../domain/units";
import type { Studio } from "../mission/studio";
import { NumberField, Segmented } from "./controls";
import { ProtectAll } from "./protect_all";

type NumberMember = "groundSpeed" | "airSpeed" | "breachTime" | "breachTimePerCell";

export function Settings({ studio }: { studio: Studio }) {
  const mission = studio.mission.value;
  if (!mission) return null;
  const units = studio.units.value;
  const { metric } = units;
  const set = (part: Partial<Mission>) => studio.change((old) => ({ ...old, ...part }));
  const number = (member: NumberMember, scale = 1) => ({
    value: mission[member] / scale,
    onInput: (value: number) => studio.change((old) => ({ ...old, [member]: value * scale }), member),
    onDone: () => studio.endGesture(),
  });
  const speed = { unit: metric ? "m/s" : "cells/step", min: 0.01, max: 1000, step: "any" as const };
  const time = { min: 0, max: 100_000, step: "any" as const };
  const apart = mission.markers.air_start !== undefined || mission.markers.air_goal !== undefined;
  return (
    <details class="section settings">
      <summary>
        <h2>Mission settings</h2>
      </summary>
      <Segmented
        legend="Method"
        choices={[
          { value: "exact", label: "Best found" },
          { value: "paper", label: "The paper’s method (2018)" },
        ]}
        value={mission.method}
        onChange={(method) => set({ method })}
      />
      <Segmented
        legend="What counts"
        choices={[
          { value: "makespan", label: "Last arrival" },
          { value: "ground-makespan", label: "Robot’s arrival" },
          { value: "flowtime", label: "Sum of arrivals" },
        ]}
        value={mission.objective}
        onChange={(objective) => set({ objective })}
      />
      <div class="fields">
        <NumberField label="Ground robot’s speed" {...speed} {...number("groundSpeed")} />
        <NumberField label="Aircraft’s speed" {...speed} {...number("airSpeed")} />
        <NumberField label="Time to open one" unit={metric ? "s" : "steps"} {...time} {...number("breachTime")} />
        <NumberField
          label={metric ? "… and for each m²" : "… and for each cell"}
          unit={metric ? "s" : "steps"}
          {...time}
          {...number("breachTimePerCell", units.cell * units.cell)}
        />
        <RobotSize radius={mission.radius} units={units} onChange={(radius) => set({ radius })} />
        <ProtectAll studio={studio} />
      </div>
      <p class="aircraft-place">
        {apart ? (
          <button type="button" class="button" onClick={() => studio.bringAircraftBack()}>
            Put the aircraft back to the robot’s start and goal
          </button>
        ) : (
          "To start or land the aircraft elsewhere, pull its small marker off the start or the goal."
        )}
      </p>
    </details>
  );
}

const usualRadii = [0, 0.5, 1, 1.5, 2, 3, 4];

function RobotSize({ radius, units, onChange }: { radius: number; units: Units; onChange: (radius: number) => void }) {
  const radii = usualRadii.includes(radius) ? usualRadii : [...usualRadii, radius].sort((a, b) => a - b);
  const wide = (r: number) =>
    units.metric ? `${Number((2 * r * units.cell).toPrecision(3))} m` : length(2 * r, units);
  return (
    <div class="number-field">
      <label for="robot-size">Ground robot’s width</label>
      <select id="robot-size" value={String(radius)} onChange={(event) => onChange(Number(event.currentTarget.value))}>
        {radii.map((r) => (
          <option key={r} value={String(r)}>
            {r === 0 ? "a point" : wide(r)}
          </option>
        ))}
      </select>
    </div>
  );
}
