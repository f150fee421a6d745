// The page: map, timeline over it, and the panel beside it (below it on a narrow screen).
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useMemo, useRef } from "preact/hooks";
import type { TabToken } from "../api/token";
import { objectiveOf, valueOf } from "../domain/plan";
import type { Scene, SceneEvents } from "../domain/scene";
import { duration } from "../domain/units";
import { MapCanvas } from "../map/map_canvas";
import type { MapView } from "../map/map_view";
import type { PageState } from "../mission/page_state";
import { sceneOf } from "../mission/scene_of";
import type { Studio } from "../mission/studio";
import { counted } from "../mission/words";
import { Timeline } from "../play/timeline";
import { AgentList } from "./agent_list";
import { Choices } from "./choices";
import { TokenDialog } from "./dialogs";
import { DropTarget } from "./drop_target";
import { GroundLegend } from "./ground_legend";
import { Header } from "./header";
import { HeadlineSection } from "./headline";
import { ImportDialog } from "./import_dialog";
import { Layers } from "./layers";
import { LostMapCard } from "./lost_map";
import { MapChoice, nameOfMap } from "./map_choice";
import { MapNotes } from "./map_notes";
import { Attribution, Gone, Invitation, NoticeBar } from "./messages";
import { ObstacleCard } from "./obstacle_card";
import { areBuildings } from "./obstacle_words";
import { type Asked, MishapMenu } from "./mishap_menu";
import { dropRubble, mishapsAt } from "./mishaps";
import { OverlayDialog } from "./overlay_dialog";
import { Printed } from "./printed";
import { RehearsalCaption, RehearsalResult } from "./rehearsal_result";
import { Rehearse } from "./rehearse";
import { Removals } from "./removals";
import { RemovedTable } from "./removed_table";
import { Search } from "./search";
import { Settings } from "./settings";
import { TakeAlong } from "./take_along";
import { Tools } from "./tools";
import { Zones } from "./zones";

interface AppProps {
  page: PageState;
  studio?: Studio | null; // none where a plan is only viewed
  token?: TabToken | null;
}

export function App({ page, studio = null, token = null }: AppProps) {
  const view = useRef<MapView | null>(null);
  useSignalEffect(() => {
    document.title = titleOf(page, studio);
  });
  return (
    <div class={`page ${studio ? "" : "viewer"} ${page.old.value ? "old" : ""}`}>
      <MapArea page={page} studio={studio} onView={(made) => (view.current = made)} />
      <main class="panel">
        <Header studio={studio} />
        {studio ? <MapChoice studio={studio} /> : <p class="map-title">{page.shown.value?.base.description.title}</p>}
        <Search page={page} show={(what) => view.current?.centerOn(what)} />
        {studio && <Invitation studio={studio} />}
        <MapNotes page={page} />
        {studio && page.rehearsed.value ? (
          <RehearsalResult studio={studio} />
        ) : (
          <HeadlineSection page={page} studio={studio} />
        )}
        {studio && <Rehearse studio={studio} />}
        <Removals page={page} studio={studio} />
        {!page.rehearsed.value && <RemovedTable page={page} studio={studio} />}
        <AgentList page={page} studio={studio} />
        <Zones page={page} studio={studio} />
        {studio && <Choices studio={studio} />}
        <Layers page={page} studio={studio} />
        {studio && <Settings studio={studio} />}
        {studio && <TakeAlong studio={studio} />}
      </main>
      <Printed linked={studio !== null} />
      <NoticeBar page={page} />
      {studio && <DropTarget studio={studio} />}
      {studio && <ImportDialog importer={studio.importer} />}
      {studio && (
        <OverlayDialog overlays={studio.overlays} importInstead={(file) => void studio.importer.begin(file)} />
      )}
      {token && <TokenDialog token={token} />}
    </div>
  );
}

// What the tab is called, so that one finds the mission again among others.
function titleOf(page: PageState, studio: Studio | null): string {
  const { base } = page.shown.value ?? {};
  const plan = page.results.plans.value.after?.plan;
  if (!base) return "waybreaker";
  const place = studio ? nameOfMap(studio, base.description.id) : base.description.title;
  const reached = plan && valueOf(plan.after, objectiveOf(plan));
  if (reached == null) return `${place} – waybreaker`;
  const ids = plan!.removed.map((one) => one.obstacle);
  const removed = counted(ids.length, areBuildings(page.shown.value!, ids));
  return `${place}: ${duration(reached, page.objectiveUnits.value)}, ${removed} removed – waybreaker`;
}

interface MapAreaProps {
  page: PageState;
  studio: Studio | null;
  onView: (view: MapView | null) => void;
}

function MapArea({ page, studio, onView }: MapAreaProps) {
  const asked = useSignal<Asked | null>(null);
  const scene = useComputed<Scene | null>(() => sceneOf(page, studio));
  const events = useMemo<SceneEvents>(
    () => ({
      drag: (handle, cell, done) => studio?.editor.drag(handle, cell, done),
      select: (obstacle, at) => {
        page.selected.value = obstacle;
        page.pointed.value = at && { cell: at, isChosen: true };
      },
      hover: (obstacle) => (page.highlighted.value = obstacle),
      passOver: (cell) => (page.pointed.value = cell && { cell, isChosen: false }),
      choose: (agent) => (page.chosenAgent.value = agent),
      draw: (tool, runs) => studio?.editor.draw(tool, runs),
      outline: (corners, done) => studio?.zones.outline(corners, done),
      base: (at) => studio?.bases.set(at),
      drop: (at, done) => studio && dropRubble(studio, at, done),
      ask: (what, at) => {
        const isAny = studio !== null && mishapsAt(studio, what).length > 0;
        asked.value = isAny ? { what, at } : null;
        return isAny;
      },
    }),
    [page, studio],
  );
  const view = useRef<MapView | null>(null);
  const take = (made: MapView | null) => onView((view.current = made));
  useSignalEffect(() => {
    if (page.sight.value) view.current?.bringIntoView(page.sight.value.what);
  });
  const plan = page.played.value;
  const title = page.shown.value?.base.description.title;
  return (
    <section class="map-area" aria-label="Map">
      {studio && <Tools studio={studio} />}
      <div class="map-box">
        <MapCanvas scene={scene} events={events} label={title ? `Map of ${title}` : "Map"} view={take} />
        {studio && <Gone studio={studio} />}
        {studio && <LostMapCard studio={studio} />}
        <GroundLegend page={page} />
        <Attribution page={page} />
        {studio && <MishapMenu studio={studio} asked={asked} />}
      </div>
      <ObstacleCard page={page} studio={studio} marked={() => view.current?.marked() ?? null} />
      {studio && <RehearsalCaption studio={studio} />}
      <div class="timeline-box">
        {plan && plan.agents.length > 0 && (
          <Timeline
            plan={plan}
            clock={page.clock}
            formatTime={(time) => duration(time, page.units.value, true)}
            moments={page.rehearsed.value?.moments}
          />
        )}
      </div>
    </section>
  );
}
