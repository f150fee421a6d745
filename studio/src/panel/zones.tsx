// The zones of the mission: who keeps out of which.
import { windowWords, type Zone, type ZoneKind, zoneWords } from "../domain/zone";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { IconButton, Section } from "./controls";
import { Name } from "./name";
import { NumberField } from "./number_field";

export function Zones({ page, studio }: { page: PageState; studio: Studio | null }) {
  const zones = page.mission.value?.zones ?? [];
  if (zones.length === 0) return null;
  return (
    <Section title="Zones">
      <ul class="zones">
        {zones.map((zone, i) => (
          <li key={i} class="zone" onPointerEnter={() => (page.pointedZone.value = i)} onPointerLeave={() => (page.pointedZone.value = null)}>
            <ZoneSample kind={zone.kind} />
            {studio ? <ZoneFields studio={studio} zone={zone} index={i} /> : <Name of={zoneWords(zone)} />}
            {!studio && windowWords(zone) !== "" && <span class="zone-agents">{windowWords(zone)}</span>}
            {zone.agents.length > 0 && <span class="zone-agents">for {zone.agents.join(", ")}</span>}
          </li>
        ))}
      </ul>
    </Section>
  );
}

function ZoneFields({ studio, zone, index }: { studio: Studio; zone: Zone; index: number }) {
  const which = `zone ${index + 1}`;
  return (
    <>
      <input
        type="text"
        class="zone-name"
        aria-label={`Name of ${which}`}
        autocomplete="off"
        placeholder={zoneWords({ ...zone, name: "" })}
        value={zone.name}
        onFocus={() => studio.zones.show(index)}
        onInput={(event) => studio.zones.rename(index, event.currentTarget.value)}
        onChange={() => studio.zones.endGesture()}
      />
      <select
        aria-label={`Who keeps out of ${which}`}
        value={zone.kind}
        onChange={(event) => studio.zones.setKind(index, event.currentTarget.value as ZoneKind)}
      >
        <option value="no_fly">aircraft</option>
        <option value="keep_out">vehicles</option>
      </select>
      <IconButton icon="close" kind="small" label={`Remove ${which}`} onClick={() => studio.zones.remove(index)} />
      <div class="zone-times">
        <ZoneTime studio={studio} zone={zone} index={index} end="from" />
        <ZoneTime studio={studio} zone={zone} index={index} end="until" />
      </div>
    </>
  );
}

// Left empty: it holds from the start, or for ever.
function ZoneTime({ studio, zone, index, end }: { studio: Studio; zone: Zone; index: number; end: "from" | "until" }) {
  return (
    <NumberField
      label={`Zone ${index + 1} holds ${end}`}
      unit={studio.page.units.value.metric ? "s" : "steps"}
      value={zone[end] ?? null}
      min={0}
      max={1e9}
      empty={end === "from" ? "start" : "end"}
      onInput={(time) => studio.zones.setTime(index, end, time)}
      onClear={() => studio.zones.setTime(index, end, undefined)}
      onDone={() => studio.zones.endGesture()}
    />
  );
}

// As on the map.
export function ZoneSample({ kind }: { kind: ZoneKind }) {
  return (
    <svg class={`zone-sample sample-${kind}`} width="20" height="16" aria-hidden="true">
      <rect x="1.5" y="1.5" width="17" height="13" />
    </svg>
  );
}
