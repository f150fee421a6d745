// How far an aircraft can fly and where it recharges, folded away: most missions do not ask.
import { type Aircraft, canRecharge, isLimited } from "../domain/agents";
import { duration, length, percent, type Units } from "../domain/units";
import type { Studio } from "../mission/studio";
import { Bases } from "./bases";
import { NumberField } from "./number_field";

interface Props {
  studio: Studio;
  index: number;
  title?: string;
}

export function Battery({ studio, index, title = "Battery" }: Props) {
  const units = studio.page.units.value;
  const aircraft = studio.page.mission.value!.agents[index] as Aircraft;
  const { range, endurance, reserve, recharge } = aircraft;
  const { unit, seconds } = units.metric ? { unit: "min", seconds: 60 } : { unit: "steps", seconds: 1 };
  const set = (part: Partial<Aircraft>) => studio.editor.changeAgent(index, part, `${Object.keys(part).join()} ${index}`);
  const onDone = () => studio.editor.endGesture();
  return (
    <details class="fold">
      <summary>
        {title}: {batteryWords(aircraft, units)}
      </summary>
      <div class="fields">
        <NumberField
          label="Range"
          unit={units.metric ? "m" : "cells"}
          min={1}
          max={1_000_000}
          value={range}
          onInput={(value) => set({ range: value })}
          onClear={() => set({ range: null })}
          onDone={onDone}
        />
        <NumberField
          label="Endurance"
          unit={unit}
          min={0.1}
          max={100_000}
          value={endurance === null ? null : endurance / seconds}
          onInput={(value) => set({ endurance: value * seconds })}
          onClear={() => set({ endurance: null })}
          onDone={onDone}
        />
        {isLimited(aircraft) && (
          <NumberField
            label="Kept in reserve"
            unit="%"
            min={0}
            max={99}
            value={100 * reserve}
            onInput={(value) => set({ reserve: value / 100 })}
            onDone={onDone}
          />
        )}
        {isLimited(aircraft) && (
          <NumberField
            label="Recharges in"
            unit={unit}
            min={0.1}
            max={100_000}
            value={recharge === null ? null : recharge / seconds}
            empty="flies once"
            onInput={(value) => set({ recharge: value * seconds })}
            onClear={() => set({ recharge: null })}
            onDone={onDone}
          />
        )}
        {canRecharge(aircraft) && <Bases studio={studio} index={index} />}
      </div>
    </details>
  );
}

function batteryWords(aircraft: Aircraft, units: Units): string {
  const { range, endurance, reserve, recharge } = aircraft;
  const limits = [
    ...(range === null ? [] : [length(range / units.cell, units)]),
    ...(endurance === null ? [] : [duration(endurance / units.seconds, units)]),
  ];
  if (limits.length === 0) return "no limit";
  const kept = reserve > 0 ? [`${percent(reserve)} in reserve`] : [];
  const charged = recharge !== null && canRecharge(aircraft) ? [`recharges in ${duration(recharge / units.seconds, units)}`] : [];
  return [...limits, ...kept, ...charged].join(", ");
}
