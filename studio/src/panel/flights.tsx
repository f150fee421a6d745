// What aircraft whose battery ends land with, and which obstacles are too far for them.
import { isTeam, type Plan } from "../domain/plan";
import type { Units } from "../domain/units";
import { landings, tooFar } from "../mission/flight_words";
import type { PageState } from "../mission/page_state";
import { Name } from "./name";
import { nameOf } from "./obstacle_words";

// The same as it is spoken.
export function flightTexts(page: PageState, plan: Plan): string[] {
  const units = page.units.value;
  const far = tooFar(plan, units).map(({ can, obstacles }) => {
    const each = obstacles.map(({ id, needs }) => `${nameOf(page.shown.value!, id).text}: ${needs}`);
    return `Out of range: ${can}. ${each.join("; ")}.`;
  });
  return [...flownIn(plan, units).map((text) => `The aircraft ${text}.`), ...far];
}

// Of a team the list of agents says who lands with what.
function flownIn(plan: Plan, units: Units): string[] {
  return isTeam(plan) ? [] : plan.agents.flatMap((agent) => landings(plan, agent, units));
}

export function Flights({ page, plan }: { page: PageState; plan: Plan }) {
  const units = page.units.value;
  const far = tooFar(plan, units);
  return (
    <>
      {flownIn(plan, units).map((text, i) => (
        <p key={i} class="arrivals">
          The aircraft {text}.
        </p>
      ))}
      {far.map(({ can, obstacles }) => (
        <div key={can} class="arrivals">
          Out of range: {can}.
          <ul class="out-of-range">
            {obstacles.map(({ id, needs }) => (
              <li key={id}>
                <button
                  type="button"
                  class="obstacle-name inline"
                  onClick={() => page.showObstacle(id)}
                  onPointerEnter={() => (page.highlighted.value = id)}
                  onPointerLeave={() => (page.highlighted.value = null)}
                >
                  <Name of={nameOf(page.shown.value!, id).text} />
                </button>
                : {needs}
              </li>
            ))}
          </ul>
        </div>
      ))}
    </>
  );
}
