// What is known about the obstacle that was clicked, and what may be said about it.
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Obstacle, Structure } from "../domain/map";
import { factsOf, kindWord, whyItStays } from "../domain/obstacle_words";
import { parseTagFilters } from "../domain/tag_filter";
import { area, duration } from "../domain/units";
import type { Marked } from "../map/map_view";
import { whyNobodyOpens } from "../mission/ability_words";
import { whyTooFar } from "../mission/flight_words";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { bestCorner, type Corner } from "./card_place";
import { IconButton } from "./controls";
import { Icon } from "./icons";
import { MarkButtons } from "./mark_buttons";
import { Name } from "./name";
import { nameOf, osmPage } from "./obstacle_words";
import { OsmLink } from "./osm_link";

interface CardProps {
  page: PageState;
  studio: Studio | null;
  marked: () => Marked | null; // what it should not hide
}

export function ObstacleCard({ page, studio, marked }: CardProps) {
  const id = page.selected.value;
  const shown = page.shown.value;
  const obstacle = id === null ? undefined : shown?.map.cells.obstacle(id);
  const card = useRef<HTMLElement>(null);
  const [corner, setCorner] = useState<Corner>("top right");
  const [below, setBelow] = useState(0); // the timeline
  const plan = page.results.plans.value.after?.plan;
  useLayoutEffect(() => {
    const all = card.current && marked(); // marked() makes the browser lay out the page
    if (!card.current || !all) return;
    const { offsetWidth: width, offsetHeight: height, offsetParent } = card.current;
    setBelow((offsetParent?.getBoundingClientRect().bottom ?? all.bottom) - all.bottom);
    setCorner((now) => bestCorner({ width, height }, all.view, all.points, now));
  }, [id, shown, plan]);
  if (!shown || !obstacle) return null;
  const units = page.units.value;
  const name = nameOf(shown, obstacle.id);
  const far = plan && whyTooFar(plan, obstacle.id, units);
  const agents = page.mission.value?.agents ?? [];
  const closed = obstacle.destructible && whyNobodyOpens(agents, { ...obstacle, id: shown.ids.toBase(obstacle.id) }, units);
  const removed = plan?.removed.find((one) => one.obstacle === obstacle.id);
  return (
    <aside ref={card} class="card" data-corner={corner} style={{ "--below": `${below}px` }} aria-label={`About ${name.text}`}>
      <div class="card-head">
        <h2>
          <Name of={name.text} />
        </h2>
        <IconButton icon="close" label="Close" onClick={() => (page.selected.value = null)} />
      </div>
      <p class="obstacle-facts">
        {[...factsOf(obstacle, name.text), area(obstacle.cells, units)].join(", ")}
        {!obstacle.structures && <OsmLink name={name} />}
      </p>
      {obstacle.structures && <Structures of={obstacle.structures} />}
      {obstacle.breach_time > 0 && <p>Opening it takes {duration(obstacle.breach_time, units)} longer.</p>}
      {removed && (
        <p>
          Opened at {duration(removed.cleared_at, units, true)}
          {removed.entered_at !== null && <>, entered at {duration(removed.entered_at, units, true)}</>}
          {removed.saves != null && removed.saves > 0 && <>; if it had to stay, {duration(removed.saves, units)} later</>}.
        </p>
      )}
      {far && <p>{far}</p>}
      {closed && <p>{closed}</p>}
      {!obstacle.destructible && <p>{whyItStays(obstacle)}</p>}
      {obstacle.destructible && studio && (
        <>
          <MarkButtons studio={studio} id={obstacle.id} name={name.text} large />
          <ProtectWhole studio={studio} obstacle={obstacle} />
        </>
      )}
    </aside>
  );
}


// All sections of a building that has a name, and whatever else is called so.
function ProtectWhole({ studio, obstacle }: { studio: Studio; obstacle: Obstacle }) {
  if (studio.page.ruleOf(obstacle.id)) return null;
  const names = new Set((obstacle.structures ?? []).map((one) => one.name ?? ""));
  return (
    <>
      {[...names].filter(isOneFilter).map((name) => (
        <button key={name} type="button" class="button" onClick={() => studio.editor.protectAll([{ key: "name", values: [name] }])}>
          <Icon name="protect" />
          <span>
            Protect all of <Name of={name} />
          </span>
        </button>
      ))}
    </>
  );
}

// A comma would begin another name.
function isOneFilter(name: string): boolean {
  return parseTagFilters(`name=${name}`)?.[0]?.values.join() === name && !name.includes(",");
}

const mostListed = 5;

// Of what a section is a part: opening it leaves the rest.
function Structures({ of }: { of: readonly Structure[] }) {
  const isMixed = new Set(of.map(({ kind }) => kind)).size > 1; // or else the line above says what they all are
  const told = of.filter((one) => isMixed || one.name || one.source_id);
  if (told.length === 0) return null;
  return (
    <ul class="structures" aria-label="Part of">
      {told.slice(0, mostListed).map((one, i) => (
        <li key={i}>
          {(one.name || isMixed) && <Name of={one.name || kindWord(one.kind)} />}
          <OsmLink name={{ text: one.name ?? kindWord(one.kind), osm: osmPage(one.source_id ?? 0) }} />
        </li>
      ))}
      {told.length > mostListed && <li>and {told.length - mostListed} more</li>}
    </ul>
  );
}
