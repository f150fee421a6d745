// What the page shows: a mission, its map and its plans. All that the viewer of a plan has; a studio can change it.
import { computed, effect, signal, type Signal } from "@preact/signals";
import { cellOf, looksOf } from "../domain/agents";
import type { Bands } from "../domain/bands";
import type { Cell, Point } from "../domain/geometry";
import { asksTheSame, defaults, type LayerName, type Mark, type Mission, shownPer } from "../domain/mission";
import type { Plan } from "../domain/plan";
import type { Reach } from "../domain/reach";
import type { Rehearsed } from "../domain/rehearsed";
import { ruledObstacles, type TagFilter } from "../domain/tag_filter";
import { type Pace, type Units, unitsOf } from "../domain/units";
import type { Results } from "../planning/results";
import { Clock } from "../play/clock";
import { duration } from "../play/motion";
import { drawnObstacles } from "./edited";
import { type History, replace } from "./history";
import type { ShownMap } from "./maps";
import { reachOf } from "./place_words";

export interface Notice {
  tone: "info" | "bad";
  text: string;
  actions: readonly { label: string; act: () => void }[];
}

// What is to be seen: an obstacle, or points of the map.
export type Sight = number | readonly Point[];

const moment = 300; // ms

export class PageState {
  readonly history: Signal<History<Mission> | null> = signal(null);
  readonly mission = computed(() => this.history.value?.present ?? null);
  readonly shown: Signal<ShownMap | null> = signal(null);
  readonly drawn = computed<ReadonlySet<number>>(() => {
    const [mission, shown] = [this.mission.value, this.shown.value];
    return mission && shown ? drawnObstacles(mission, shown) : new Set();
  });
  readonly #rules = computed(() => this.mission.value?.protectAll ?? defaults.protectAll);
  // Of the obstacles shown those that a rule protects, by id. The same until the rules or the map are others.
  readonly ruled = computed<ReadonlyMap<number, TagFilter>>(() => {
    const shown = this.shown.value;
    return shown ? ruledObstacles(this.#rules.value, shown.map.cells) : new Map();
  });
  readonly units: Signal<Units> = computed(() =>
    this.shown.value
      ? unitsOf(this.shown.value.base.description, this.pace)
      : { metric: true, cell: 1, time: "seconds", seconds: 1 },
  );
  // Of values of the objective.
  readonly objectiveUnits = computed<Units>(() => {
    const [units, mission] = [this.units.value, this.mission.value];
    return mission ? { ...units, seconds: units.seconds / shownPer(mission) } : units;
  });
  readonly loading = signal(true); // a map is on its way
  readonly selected = signal<number | null>(null);
  readonly highlighted = signal<number | null>(null);
  readonly pointedZone = signal<number | null>(null); // in a list: its place in the mission's
  readonly chosenAgent = signal<number | null>(null); // its place in the mission's list
  // What was last asked to be shown; the map moves there if it is off the picture. Each time another object.
  readonly sight = signal<{ what: Sight } | null>(null);
  readonly notice = signal<Notice | null>(null);
  readonly looks = computed(() => looksOf(this.mission.value?.agents ?? []));
  readonly clock = new Clock();
  readonly rehearsed: Signal<Rehearsed | null> = signal(null);
  // The plan that is played.
  readonly played = computed<Plan | null>(() => this.rehearsed.value?.plan ?? this.results.plans.value.after?.plan ?? null);

  readonly reach = computed<Reach | null>(() => {
    const plan = this.played.value;
    return plan ? reachOf(plan, this.results.plans.value.before?.plan ?? null) : null;
  });

  readonly bands: Signal<Bands | null> = signal(null); // of time, of the last plan that they were asked for

  readonly bandsAreOld = signal(false);
  // The cell under the pointer, where there are bands; chosen by a click or a key, or just passed over.
  readonly pointed = signal<{ cell: Cell; isChosen: boolean } | null>(null);

  // Whether what is shown answers an older question.
  readonly outdated = computed(() => {
    const answered = this.results.answered.value?.of;
    const mission = this.mission.value;
    return Boolean(answered && mission && !asksTheSame(answered, mission));
  });
  // Whether it has for a moment: what follows the mouse does so within it.
  readonly old = signal(false);

  // `pace`: of a plan that is in the units of its file (unitsOf).
  constructor(
    readonly results: Results,
    private readonly pace: Pace | null = null,
  ) {
    let timer: ReturnType<typeof setTimeout>;
    effect(() => {
      void results.answered.value; // each answer is another moment
      clearTimeout(timer);
      if (!this.outdated.value) this.old.value = false;
      else timer = setTimeout(() => (this.old.value = true), moment);
    });
  }

  toggleBands(): void {
    const history = this.history.value;
    if (history) this.history.value = replace(history, { ...history.present, bands: !history.present.bands });
  }

  toggleLayer(layer: LayerName): void {
    const history = this.history.value;
    if (!history) return;
    const { layers } = history.present;
    const order: LayerName[] = ["before", "after", "paper"];
    const next = order.filter((name) => layers.includes(name) !== (name === layer));
    this.history.value = replace(history, { ...history.present, layers: next });
  }

  // What is drawn has to stay unless something else is said, and so has what a rule protects.
  markOf(id: number): Mark | null {
    const stays = this.drawn.value.has(id) || this.ruleOf(id) !== null;
    const said = this.mission.value?.marks.get(this.keyOf(id)) ?? (stays ? "protect" : null);
    return said === "allow" ? null : said;
  }

  ruleOf(id: number): TagFilter | null {
    return this.ruled.value.get(id) ?? null;
  }

  // Under which key something is said of an obstacle of the map shown. A wall may have grown since.
  keyOf(id: number): number {
    const ids = this.shown.value?.ids;
    if (!ids) return 0;
    const keys = [...(this.mission.value?.marks.keys() ?? [])];
    return keys.find((key) => ids.toShown(key) === id) ?? ids.toBase(id);
  }

  // Chosen by name, somewhere else than on the map.
  showObstacle(id: number): void {
    this.selected.value = id;
    this.sight.value = { what: id };
  }

  chooseAgent(agent: number | null): void {
    this.chosenAgent.value = agent;
    const chosen = agent === null ? undefined : this.mission.value?.agents[agent];
    if (!chosen || !this.mission.value) return;
    const ends = (["start", "goal"] as const).map((end) => cellOf(this.mission.value!.agents, { agent: agent!, end }));
    this.sight.value = { what: ends };
  }

  // Where playback is to stand once there is a plan.
  seekWhenPlanned(time: number): void {
    const stop = effect(() => {
      const plan = this.results.plans.value.after?.plan;
      if (!plan) return;
      this.clock.load(duration(plan));
      this.clock.seek(time);
      queueMicrotask(() => stop());
    });
  }

  notify(tone: Notice["tone"], text: string, actions: Notice["actions"] = []): void {
    this.notice.value = { tone, text, actions };
  }
}
