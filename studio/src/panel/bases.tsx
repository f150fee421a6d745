// Where an aircraft recharges: a list, and a way to set one on the map.
import { type Aircraft, mostBases } from "../domain/agents";
import { batteryShape } from "../map/layers/recharge_layer";
import type { Studio } from "../mission/studio";
import { IconButton } from "./controls";

interface Props {
  studio: Studio;
  index: number;
}

export function Bases({ studio, index }: Props) {
  const { bases } = studio.page.mission.value!.agents[index] as Aircraft;
  return (
    <div class="bases">
      <p>{bases.length === 0 ? "Recharges at its start and goal." : "Recharges only at these bases:"}</p>
      <ul>
        {bases.map((base, i) => (
          <li key={i}>
            <BaseSample />
            <button type="button" class="obstacle-name inline" onClick={() => studio.bases.show(base)}>
              {base.join()}
            </button>
            <IconButton
              icon="close"
              kind="small"
              label={`Remove base ${base.join()}`}
              onClick={() => studio.bases.remove(index, i)}
            />
          </li>
        ))}
      </ul>
      <button
        type="button"
        class="button"
        disabled={bases.length >= mostBases}
        title={bases.length >= mostBases ? `No more than ${mostBases}` : undefined}
        onClick={() => {
          studio.bases.begin(index);
          scrollTo({ top: 0 }); // on a phone the panel lies over the map
        }}
      >
        Add base
      </button>
    </div>
  );
}

// As on the map.
export function BaseSample() {
  return (
    <svg class="base-sample" viewBox="-9 -9 18 18" width="18" height="18" aria-hidden="true">
      <rect x="-8" y="-8" width="16" height="16" rx="3" />
      <path d={batteryShape} fill-rule="evenodd" />
    </svg>
  );
}
