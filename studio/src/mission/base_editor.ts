// What people do to the bases of aircraft: each change is a step that can be undone.
import { computed, signal } from "@preact/signals";
import { type Aircraft, canRecharge, mostBases } from "../domain/agents";
import type { Cell } from "../domain/geometry";
import type { Editor } from "./editor";
import type { PageState } from "./page_state";

export class BaseEditor {
  readonly #of = signal<string | null>(null); // the id: places in the list change

  // The aircraft that gets what is set on the map; null: there is none.
  readonly aircraft = computed<Aircraft | null>(() => {
    const agents = this.page.mission.value?.agents ?? [];
    const found = agents.find(({ id }) => id === this.#of.value);
    return found?.kind === "air" && canRecharge(found) ? found : null;
  });

  constructor(
    private readonly page: PageState,
    private readonly editor: Pick<Editor, "changeAgent" | "tool">,
  ) {}

  // From now on they are set on the map.
  begin(agent: number): void {
    this.#of.value = this.page.mission.value?.agents[agent]?.id ?? null;
    this.editor.tool.value = "base";
  }

  // A cell that is a base already stays one. Null: no more are set.
  set(cell: Cell | null): void {
    const aircraft = this.aircraft.value;
    if (!cell || !aircraft) {
      this.editor.tool.value = "move";
      return;
    }
    const { bases } = aircraft;
    if (bases.some((base) => base.join() === cell.join())) return;
    if (bases.length === mostBases) return this.page.notify("bad", `An aircraft has no more than ${mostBases} bases.`);
    this.editor.changeAgent(this.page.mission.value!.agents.indexOf(aircraft), { bases: [...bases, cell] });
  }

  remove(agent: number, base: number): void {
    const { bases } = this.page.mission.value!.agents[agent] as Aircraft;
    this.editor.changeAgent(agent, { bases: bases.filter((_, i) => i !== base) });
  }

  show(cell: Cell): void {
    this.page.sight.value = { what: [cell] };
  }
}
