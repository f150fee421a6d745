// Keeps bands of time up with the plan of many places. They are asked for once it rests: drafts do without.
import { batch, effect, untracked } from "@preact/signals";
import { type Client, pause } from "../api/client";
import { Bands } from "../domain/bands";
import type { Plan } from "../domain/plan";
import type { PageState } from "./page_state";

const calm = 150; // ms

export class BandFollower {
  #followed: Plan | null = null;
  #asking: AbortController | null = null;
  #key = ""; // of the plan whose bands are known

  constructor(
    private readonly page: PageState,
    private readonly client: Pick<Client, "reach">,
  ) {
    effect(() => {
      const after = page.results.plans.value.after;
      const [isOfPlaces, isShown] = [page.reach.value !== null, page.mission.value?.bands === true];
      untracked(() => {
        if (!isOfPlaces) this.#forget();
        else if (isShown) this.#follow(after!.rough === "draft" ? null : after!.plan);
      });
    });
  }

  #forget(): void {
    this.page.bands.value = null;
    this.#key = "";
    this.#follow(null);
  }

  // What was shown stays until the next bands are there. Null: there is none to follow now.
  #follow(plan: Plan | null): void {
    if (plan === this.#followed) return;
    this.#followed = plan;
    this.#asking?.abort();
    const isKnown = plan !== null && keyOf(plan) === this.#key;
    this.page.bandsAreOld.value = !isKnown && this.page.bands.peek() !== null;
    if (plan && !isKnown) void this.#ask(plan, (this.#asking = new AbortController()).signal);
  }

  // What fails is asked for again with the next plan, whose own requests say what is wrong.
  async #ask(plan: Plan, stop: AbortSignal): Promise<void> {
    const { page } = this;
    const map = page.shown.peek()!.map.description.id;
    let bands: Bands | null = null;
    try {
      await pause(calm, stop);
      bands = Bands.of(await this.client.reach(map, plan, stop));
    } catch {
      if (stop.aborted) return;
    }
    if (stop.aborted) return;
    this.#key = bands ? keyOf(plan) : "";
    batch(() => {
      page.bands.value = bands;
      page.bandsAreOld.value = false;
    });
  }
}

// Plans with the same bands have the same.
function keyOf({ map, mission, removed }: Plan): string {
  return JSON.stringify([map.digest, mission, removed.map(({ obstacle, cleared_at }) => [obstacle, cleared_at])]);
}
