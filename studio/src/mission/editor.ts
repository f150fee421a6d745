// What people change about a mission: each change is a step that can be undone, and the plan follows it.
import { computed, signal } from "@preact/signals";
import type { Cell, Run } from "../domain/geometry";
import {
  type Choice,
  type Handle,
  type LayerName,
  type Mark,
  marked,
  type Mission,
  mostRemovals,
  withEnoughRemovals,
  withMark,
} from "../domain/mission";
import type { Tool } from "../domain/scene";
import { drawn } from "./edited";
import { endGesture, type History, redo, step, undo } from "./history";
import { PageState } from "./page_state";

export abstract class Editor extends PageState {
  readonly canUndo = computed(() => (this.history.value?.past.length ?? 0) > 0);
  readonly canRedo = computed(() => (this.history.value?.future.length ?? 0) > 0);
  readonly tool = signal<Tool>("move");

  // Brings what is shown up with the mission.
  protected abstract follow(): Promise<void>;
  // Goes to another step of the history.
  protected abstract travel(how: (history: History<Mission>) => History<Mission>): void;

  // A step that can be undone; steps of one gesture are undone together.
  change(how: (mission: Mission) => Mission, gesture: string | null = null): void {
    const history = this.history.value;
    if (!history) return;
    this.history.value = step(history, how(history.present), gesture);
    void this.follow();
  }

  endGesture(): void {
    if (this.history.value) this.history.value = endGesture(this.history.value);
  }

  undo(): void {
    this.travel(undo);
  }

  redo(): void {
    this.travel(redo);
  }

  // After a plan was stopped.
  planAgain(): void {
    void this.follow();
  }

  override toggleLayer(layer: LayerName): void {
    super.toggleLayer(layer);
    void this.follow();
  }

  // The map sees to it that the ground robot's markers stand on free cells.
  drag(handle: Handle, cell: Cell, done: boolean): void {
    const old = this.mission.value?.markers[handle];
    if (old?.[0] !== cell[0] || old?.[1] !== cell[1]) {
      this.change((mission) => ({ ...mission, markers: { ...mission.markers, [handle]: cell } }), `drag ${handle}`);
    }
    if (done) this.endGesture();
  }

  bringAircraftBack(): void {
    this.change((mission) => ({ ...mission, markers: { start: mission.markers.start, goal: mission.markers.goal } }));
  }

  draw(tool: "wall" | "erase", runs: readonly Run[]): void {
    const shown = this.shown.value;
    if (shown) this.change((mission) => drawn(mission, tool, runs, shown));
  }

  // `id` is an obstacle of the map shown. What has been drawn is not excluded but erased.
  mark(id: number, mark: Mark | null): void {
    const shown = this.shown.value;
    if (!shown) return;
    const key = this.keyOf(id);
    if (key === 0) return;
    const isDrawn = this.drawn.value.has(id);
    if (key < 0 && mark === "exclude") this.draw("erase", shown.map.cells.runsOf(id));
    else if (isDrawn && mark === "protect") this.markKey(key, null);
    else this.markKey(key, mark ?? (isDrawn ? "allow" : null));
    if (mark === "exclude") this.selected.value = null;
  }

  markKey(key: number, mark: Choice | null): void {
    const next = withMark(this.mission.value!, key, mark);
    if (marked(next, "force").length > mostRemovals) {
      return this.notify("bad", `No more than ${mostRemovals} obstacles can be removed.`);
    }
    this.change(() => withEnoughRemovals(next));
  }
}
