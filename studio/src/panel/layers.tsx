// Which layers the map shows, a legend of their lines, and the result of each.
import type { LayerName } from "../domain/mission";
import { basesOf } from "../domain/agents";
import { valueOf } from "../domain/plan";
import { durations } from "../domain/units";
import { zoneKinds, zoneWords } from "../domain/zone";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { counted, noWay, tooEarly } from "../mission/words";
import { BandList } from "./band_legend";
import { BaseSample } from "./bases";
import { Section } from "./controls";
import { areBuildings } from "./obstacle_words";
import { ZoneSample } from "./zones";

const layers: { name: LayerName; title: string }[] = [
  { name: "after", title: "After" },
  { name: "before", title: "Before" },
  { name: "paper", title: "Paper’s choice" },
];

export function Layers({ page, studio }: { page: PageState; studio: Studio | null }) {
  const mission = page.mission.value;
  const shown = page.shown.value;
  if (!mission || !shown) return null;
  const plans = page.results.plans.value;
  const team = page.looks.value.size > 0;
  const flies = mission.agents.some(({ kind }) => kind === "air");
  const units = page.objectiveUnits.value;
  const what = (name: LayerName) => {
    const plan = plans[name]?.plan;
    if (name === "before") return "nothing removed";
    if (!plan) return "…";
    const early = tooEarly(plan) > 0 ? ", entered too early" : "";
    if (plan.agents.length === 0) return noWay(plan);
    const ids = plan.removed.map((one) => one.obstacle);
    return `${counted(ids.length, areBuildings(shown, ids))} removed${early}`;
  };
  const value = (name: LayerName) => {
    // The plan itself says what would be without removals, before that way has been fetched.
    const outcome = plans[name]?.plan.after ?? (name === "before" && !team ? plans.after?.plan.before : undefined);
    return outcome ? valueOf(outcome, mission.objective) : undefined;
  };
  const none = (name: LayerName) => noWay((plans[name] ?? plans.after!).plan);
  const times = layers.map(({ name }) => value(name) ?? null).filter((time) => time !== null);
  const texts = new Map(durations(times, units).map((text, i) => [times[i]!, text]));
  return (
    <Section title="On the map" kind="layers">
      <ul class="layer-list">
        {layers.filter(({ name }) => !team || name !== "paper").map(({ name, title }) => {
          const reached = value(name);
          return (
            <li key={name}>
              <label class="layer">
                <input
                  type="checkbox"
                  checked={mission.layers.includes(name)}
                  onChange={() => (studio?.editor ?? page).toggleLayer(name)}
                />
                <LineSample name={name} flies={flies} />
                <span class="layer-name">
                  {title}
                  <span class="layer-what">{what(name)}</span>
                </span>
                {reached === undefined ? null : reached === null ? (
                  <span class="layer-value">{none(name)}</span>
                ) : (
                  <data class="layer-value" value={reached}>
                    {texts.get(reached)}
                  </data>
                )}
              </label>
            </li>
          );
        })}
        {page.reach.value && (page.bands.value || !mission.bands) && (
          <li>
            <label class="layer">
              <input type="checkbox" checked={mission.bands} onChange={() => page.toggleBands()} />
              <span class="sample sample-bands" aria-hidden="true" />
              <span class="layer-name">
                Bands of time
                <span class="layer-what">by when ground is reached</span>
              </span>
            </label>
          </li>
        )}
      </ul>
      <BandList page={page} />
      <p class="legend">
        <AgentSample kind="ground" name={team ? "vehicles, each in its colour" : "ground robot"} />
        {flies && <AgentSample kind="air" name="aircraft" />}
        <span>
          <svg width="16" height="14" aria-hidden="true">
            <rect class="sample-removed" x="1" y="1" width="14" height="12" />
          </svg>
          removed
        </span>
        {basesOf(mission.agents).length > 0 && (
          <span>
            <BaseSample />
            base
          </span>
        )}
        {zoneKinds.filter((kind) => mission.zones.some((zone) => zone.kind === kind)).map((kind) => (
          <span key={kind}>
            <ZoneSample kind={kind} />
            {zoneWords({ kind, name: "" }).toLowerCase()}
          </span>
        ))}
      </p>
    </Section>
  );
}

function LineSample({ name, flies }: { name: LayerName; flies: boolean }) {
  return (
    <svg class={`sample sample-${name}`} width="34" height="14" aria-hidden="true">
      <line x1="2" x2="32" y1="5" y2="5" />
      {flies && name !== "before" && <line class="sample-flight" x1="2" x2="32" y1="10" y2="10" />}
    </svg>
  );
}

function AgentSample({ kind, name }: { kind: "ground" | "air"; name: string }) {
  return (
    <span>
      <svg width="26" height="10" aria-hidden="true">
        <line class={`sample-${kind}`} x1="1" x2="25" y1="5" y2="5" />
      </svg>
      {name}
    </span>
  );
}
