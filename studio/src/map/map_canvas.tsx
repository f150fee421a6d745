// The map as part of the page: the canvas, and for the keyboard a button for each marker, moved with the arrow keys.
import type { ReadonlySignal } from "@preact/signals";
import { effect, useComputed } from "@preact/signals";
import { useEffect, useId, useRef } from "preact/hooks";
import { type Agents, cellOf, type Handle, handlesOf, isPair } from "../domain/agents";
import type { Cell } from "../domain/geometry";
import type { Scene, SceneEvents } from "../domain/scene";
import { nearestFree, onMap } from "./interaction/snap";
import "./map.css";
import { MapView } from "./map_view";

export interface MapCanvasProps {
  scene: ReadonlySignal<Scene | null>; // null: nothing to show yet
  events: SceneEvents;
  label?: string; // what the map shows, for those who do not see it
  view?: (view: MapView | null) => void; // called with the view, for buttons that zoom, fit or centre
}

const names = { ground: { start: "Ground start", goal: "Ground goal" }, air: { start: "Air start", goal: "Air goal" } };

function nameOf(agents: Agents, { agent, end }: Handle): string {
  const { id, kind } = agents[agent]!;
  return isPair(agents) ? names[kind][end] : `${end === "start" ? "Start" : "Goal"} of ${id}`;
}

export function MapCanvas({ scene, events, label = "Map", view: onView }: MapCanvasProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<MapView | null>(null);
  const latest = useRef(events);
  latest.current = events;
  const help = useId();

  useEffect(() => {
    const made = new MapView(canvas.current!, {
      drag: (handle, cell, done) => latest.current.drag(handle, cell, done),
      select: (obstacle, at) => latest.current.select(obstacle, at),
      hover: (obstacle) => latest.current.hover(obstacle),
      passOver: (cell) => latest.current.passOver(cell),
      choose: (agent) => latest.current.choose(agent),
      draw: (tool, runs) => latest.current.draw(tool, runs),
      outline: (corners, done) => latest.current.outline(corners, done),
      base: (at) => latest.current.base(at),
      drop: (at, done) => latest.current.drop(at, done),
      ask: (what, at) => latest.current.ask(what, at),
    });
    view.current = made;
    // At once: an effect of the component would come a frame later, and what is drawn another one.
    const unfollow = effect(() => {
      if (scene.value) made.show(scene.value);
    });
    onView?.(made);
    return () => {
      unfollow();
      onView?.(null);
      view.current = null;
      made.destroy();
    };
  }, []);

  return (
    <div class="map-view">
      <canvas
        ref={canvas}
        class="map-canvas"
        tabIndex={0}
        role="application"
        aria-roledescription="map"
        aria-label={label}
        aria-describedby={help}
      />
      <p id={help} class="map-help">
        Arrow keys move the map, plus and minus zoom, 0 shows all of it, Enter selects the obstacle in the middle, or
        says by when the ground there is reached, Escape selects none, and in a rehearsal the context menu says what can happen there. While a zone is drawn, Enter sets a
        corner in the middle, Enter again at the same place closes the zone, Backspace takes the last corner back. While bases are set, Enter sets one in the middle, Escape ends it. Tab leads to the markers, which arrow keys move by a cell, with Shift by ten.
      </p>
      <MarkerButtons scene={scene} events={events} focus={(handle) => view.current?.focusMarker(handle)} />
      <div class="map-zoom" role="group" aria-label="Zoom">
        <ZoomButton name="Zoom in" shape="M10 4v12M4 10h12" act={() => view.current?.zoom(1.6)} />
        <ZoomButton name="Zoom out" shape="M4 10h12" act={() => view.current?.zoom(1 / 1.6)} />
        <ZoomButton
          name="Show the whole map"
          shape="M4 7.5V4h3.5M12.5 4H16v3.5M16 12.5V16h-3.5M7.5 16H4v-3.5"
          act={() => view.current?.fit()}
        />
      </div>
    </div>
  );
}

function ZoomButton({ name, shape, act }: { name: string; shape: string; act: () => void }) {
  return (
    <button type="button" aria-label={name} title={name} onClick={act}>
      <svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true">
        <path d={shape} fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" />
      </svg>
    </button>
  );
}

interface MarkerButtonsProps {
  scene: ReadonlySignal<Scene | null>;
  events: SceneEvents;
  focus: (handle: Handle | null) => void;
}

// Not to be seen: the view draws a ring around the marker whose button has the focus.
function MarkerButtons({ scene, events, focus }: MarkerButtonsProps) {
  const agents = useComputed(() => (scene.value?.editable ? scene.value.agents : null)).value; // not once a frame
  if (!agents) return null;
  return (
    <div class="map-markers" role="group" aria-label="Markers">
      {handlesOf(agents).map((handle) => {
        const [x, y] = cellOf(agents, handle);
        return (
          <button
            key={`${handle.agent} ${handle.end}`}
            type="button"
            aria-label={`${nameOf(agents, handle)}, column ${x}, row ${y}. Arrow keys move it.`}
            onFocus={() => focus(handle)}
            onBlur={() => focus(null)}
            onKeyDown={(event) => {
              const now = scene.peek();
              const cell = now && moved(now, handle, event);
              if (!cell) return;
              event.preventDefault();
              events.drag(handle, cell, true);
            }}
          />
        );
      })}
    </div>
  );
}

const steps: Record<string, Cell> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// Where a key takes a marker; past obstacles for the ground agent, which cannot stand on them.
function moved(scene: Scene, handle: Handle, event: KeyboardEvent): Cell | null {
  const step = steps[event.key];
  if (!step || event.ctrlKey || event.metaKey || event.altKey) return null;
  const length = event.shiftKey ? 10 : 1;
  const [x, y] = cellOf(scene.agents, handle);
  const to: Cell = [x + length * step[0], y + length * step[1]];
  if (scene.agents[handle.agent]!.kind === "air") return onMap(scene.cells, to);
  const { cells } = scene;
  while (cells.at(...to) !== 0) {
    to[0] += step[0];
    to[1] += step[1];
  }
  return nearestFree(cells, onMap(cells, to));
}
