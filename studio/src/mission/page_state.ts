// What the page shows: a mission, its map and its plans. Enough for the viewer of a plan; the studio adds what can be
// done about it.
import { computed, effect, signal, type Signal } from "@preact/signals";
import type { LayerName, Mark } from "../map/scene";
import { Clock } from "../play/clock";
import { replace, type History } from "./history";
import type { HeldMap } from "./maps";
import { asksTheSame, type Mission } from "./mission";
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
  actions: readonly { label: string; act: () => void }[];
}

const moment = 300; // ms

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

  // Whether what is shown answers an older question, and has for a moment: what follows the mouse does so within it.
  readonly old = signal(false);

  constructor(readonly results: Results) {
    const isOld = computed(() => {
      const answered = results.answered.value?.of;
      const mission = this.mission.value;
      return Boolean(answered && mission && !asksTheSame(answered, mission));
    });
    let timer: ReturnType<typeof setTimeout>;
    effect(() => {
      void results.answered.value; // each answer is another moment
      clearTimeout(timer);
      if (!isOld.value) this.old.value = false;
      else timer = setTimeout(() => (this.old.value = true), moment);
    });
  }

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

  tell(tone: Notice["tone"], text: string, actions: Notice["actions"] = []): void {
    this.notice.value = { tone, text, actions };
  }
}
