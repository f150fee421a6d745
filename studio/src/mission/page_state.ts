// What the page shows: a mission, its map and its plans. Enough for the viewer of a plan; the studio adds what can be
// done about it.
import { computed, signal, type Signal } from "@preact/signals";
import type { LayerName, Mark } from "../map/scene";
import { Clock } from "../play/clock";
import { replace, type History } from "./history";
import type { HeldMap } from "./maps";
import type { Mission } from "./mission";
import type { Results } from "./planner";
import type { Translation } from "./translate";
import { unitsOf, type Units } from "./units";

// A map with everything drawn on it, and how to find obstacles of the base map there.
export interface ShownMap {
  base: HeldMap;
  map: HeldMap;
  ids: Translation;
}

export interface Notice {
  tone: "info" | "bad";
  text: string;
}

export class PageState {
  readonly history: Signal<History<Mission> | null> = signal(null);
  readonly mission = computed(() => this.history.value?.present ?? null);
  readonly shown: Signal<ShownMap | null> = signal(null);
  readonly units: Signal<Units> = computed(() =>
    this.shown.value ? unitsOf(this.shown.value.base.description) : { metric: true, cell: 1, time: "seconds" },
  );
  readonly loading = signal(true); // a map is on its way
  readonly selected = signal<number | null>(null);
  readonly highlighted = signal<number | null>(null);
  readonly notice = signal<Notice | null>(null);
  readonly clock = new Clock();

  constructor(readonly results: Results) {}

  toggleLayer(layer: LayerName): void {
    const history = this.history.value;
    if (!history) return;
    const { layers } = history.present;
    const order: LayerName[] = ["before", "after", "paper"];
    const next = order.filter((name) => layers.includes(name) !== (name === layer));
    this.history.value = replace(history, { ...history.present, layers: next });
  }

  markOf(id: number): Mark | null {
    const key = this.shown.value?.ids.toBase(id) ?? 0;
    return this.mission.value?.marks.get(key) ?? null;
  }

  tell(tone: Notice["tone"], text: string): void {
    this.notice.value = { tone, text };
  }
}
