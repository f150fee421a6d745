// What people do to zones: each change is a step that can be undone.
import { signal } from "@preact/signals";
import type { Point } from "../domain/geometry";
import type { Mission } from "../domain/mission";
import { faultOfRing, windowOf, type Zone, type ZoneKind } from "../domain/zone";
import type { Editor } from "./editor";
import type { PageState } from "./page_state";

export class ZoneEditor {
  readonly kind = signal<ZoneKind>("no_fly"); // of the next one
  readonly corners = signal(0); // of the one that is being drawn

  constructor(
    private readonly page: PageState,
    private readonly editor: Pick<Editor, "change" | "endGesture">,
  ) {}

  // Corner by corner, and `done` when the outline is closed.
  outline(ring: readonly Point[], done: boolean): void {
    this.corners.value = done ? 0 : ring.length;
    if (!done) return;
    const fault = faultOfRing(ring);
    if (fault) return this.page.notify("bad", fault);
    const zone: Zone = { kind: this.kind.value, name: "", agents: [], rings: [ring] };
    this.#change((zones) => [...zones, zone]);
  }

  add(zones: readonly Zone[]): void {
    this.#change((before) => [...before, ...zones]);
  }

  rename(index: number, name: string): void {
    this.#replace(index, { name }, `name of zone ${index}`);
  }

  endGesture(): void {
    this.editor.endGesture();
  }

  // Whom it was for was of the other kind.
  setKind(index: number, kind: ZoneKind): void {
    this.#replace(index, { kind, agents: [] });
  }

  // Between which it holds; undefined: no such time.
  setTime(index: number, which: "from" | "until", time: number | undefined): void {
    const timed = (zone: Zone): Zone => {
      const { from, until, ...rest } = { ...zone, [which]: time };
      return { ...rest, ...windowOf(from, until) };
    };
    this.#change((zones) => zones.map((zone, i) => (i === index ? timed(zone) : zone)), `${which} of zone ${index}`);
  }

  remove(index: number): void {
    this.page.pointedZone.value = null;
    this.#change((zones) => zones.filter((_, i) => i !== index));
  }

  show(index: number): void {
    const zone = this.page.mission.value?.zones[index];
    if (zone) this.page.sight.value = { what: zone.rings[0]! };
  }

  #replace(index: number, part: Partial<Zone>, gesture: string | null = null): void {
    this.#change((zones) => zones.map((zone, i) => (i === index ? { ...zone, ...part } : zone)), gesture);
  }

  #change(how: (zones: Mission["zones"]) => Mission["zones"], gesture: string | null = null): void {
    this.editor.change((mission) => ({ ...mission, zones: how(mission.zones) }), gesture);
  }
}
