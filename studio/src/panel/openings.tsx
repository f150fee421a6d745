// What an agent opens, and how long that takes it, folded away unless something is said of it.
import { useEffect, useState } from "preact/hooks";
import { mostReach } from "../domain/abilities";
import { isSpecialist, mayBreach, type Vehicle } from "../domain/agents";
import { numberText } from "../domain/number_text";
import { abilityWords, onlyWords } from "../mission/ability_words";
import type { Studio } from "../mission/studio";
import { IconButton } from "./controls";
import { Name } from "./name";
import { NumberField } from "./number_field";

interface Props {
  studio: Studio;
  index: number;
  title?: string;
}

export function Openings({ studio, index, title = "What it opens" }: Props) {
  const { agents } = studio.page.mission.value!;
  const agent = agents[index]!;
  const isSaid = isSpecialist(agent);
  const [open, setOpen] = useState(isSaid);
  useEffect(() => {
    if (isSaid) setOpen(true);
  }, [isSaid]);
  if (!mayBreach(agent)) return null;
  return (
    <details class="fold" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        {title}: {abilityWords(agent, studio.page.units.value)}
      </summary>
      <div class="fields" role="group" aria-label={title}>
        <Times studio={studio} index={index} />
        <Choice studio={studio} index={index} />
        {agent.kind === "ground" && agents.length > 1 && <Reach studio={studio} index={index} />}
      </div>
    </details>
  );
}

function changes({ editor }: Studio, index: number) {
  const set = (part: Partial<Vehicle>) => editor.changeAgent(index, part, `${Object.keys(part).join()} ${index}`);
  return { set, onDone: () => editor.endGesture() };
}

// In place of those of the rules, which hold where nothing is said.
function Times({ studio, index }: Props) {
  const mission = studio.page.mission.value!;
  const { breachTime, breachTimePerCell } = mission.agents[index]!;
  const { metric, cell } = studio.page.units.value;
  const { set, onDone } = changes(studio, index);
  const time = { unit: metric ? "s" : "steps", min: 0, max: 100_000, onDone };
  const size = cell * cell;
  return (
    <>
      <NumberField
        label="Its own time to open one"
        {...time}
        value={breachTime}
        empty={numberText(mission.breachTime)}
        onInput={(value) => set({ breachTime: value })}
        onClear={() => set({ breachTime: null })}
      />
      <NumberField
        label={metric ? "… and for each m²" : "… and for each cell"}
        {...time}
        value={breachTimePerCell === null ? null : breachTimePerCell / size}
        empty={numberText(mission.breachTimePerCell / size)}
        onInput={(value) => set({ breachTimePerCell: value * size })}
        onClear={() => set({ breachTimePerCell: null })}
      />
    </>
  );
}

function Choice({ studio, index }: Props) {
  const { mostArea, only } = studio.page.mission.value!.agents[index]!;
  const { metric, cell } = studio.page.units.value;
  const { set, onDone } = changes(studio, index);
  return (
    <>
      <NumberField
        label="Opens up to"
        unit={metric ? "m²" : "cells"}
        min={Number(numberText(cell * cell))}
        max={1_000_000_000}
        value={mostArea}
        onInput={(value) => set({ mostArea: value })}
        onClear={() => set({ mostArea: null })}
        onDone={onDone}
      />
      {only && (
        <p class="only-these">
          <Name of={onlyWords(only)} />
          <IconButton icon="close" kind="small" label="Let it open others as well" onClick={() => set({ only: null })} />
        </p>
      )}
    </>
  );
}

function Reach({ studio, index }: Props) {
  const { reach } = studio.page.mission.value!.agents[index] as Vehicle;
  const { metric, cell } = studio.page.units.value;
  const { set, onDone } = changes(studio, index);
  return (
    <NumberField
      label="Reach"
      unit={metric ? "m" : "cells"}
      min={0}
      max={mostReach * cell}
      value={reach * cell}
      onInput={(value) => set({ reach: value / cell })}
      onDone={onDone}
    />
  );
}
