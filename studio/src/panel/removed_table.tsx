// What is removed, in the order in which the aircraft opens it. Rows and map point at each other.
import { isTeam, type Plan, reached, type Removed } from "../domain/plan";
import { area, clockTime, difference, type Units } from "../domain/units";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { usersOf } from "../domain/users";
import { nounOf, savedBy } from "../mission/words";
import { AgentDot } from "./agent_dot";
import { Section } from "./controls";
import { MarkButtons } from "./mark_buttons";
import { Name } from "./name";
import { areBuildings, nameOf } from "./obstacle_words";
import { OsmLink } from "./osm_link";

export function RemovedTable({ page, studio }: { page: PageState; studio: Studio | null }) {
  const plan = page.results.plans.value.after?.plan;
  const shown = page.shown.value;
  if (!plan || !shown || plan.removed.length === 0) return null;
  const buildings = areBuildings(
    shown,
    plan.removed.map((one) => one.obstacle),
  );
  const noun = nounOf(2, buildings);
  const team = isTeam(plan);
  const users = vehicleCount(plan) > 1 ? usersOf(plan, shown.map.cells, (id) => radiusOf(page, id)) : null;
  const ordered = [...plan.removed].sort((a, b) => a.cleared_at - b.cleared_at);
  const title = `Removed ${noun}`;
  return (
    <Section title={title}>
      <table class="removed-table">
        <caption class="spoken">
          {title}, in the order in which {team ? "they are opened" : "the aircraft opens them"}
          {page.old.value && "; out of date"}
        </caption>
        <thead>
          <tr>
            <th scope="col">
              <span class="spoken">Order</span>
            </th>
            <th scope="col">{buildings ? "Building" : "Obstacle"}</th>
            <th scope="col">Opened</th>
            <th scope="col">Entered</th>
            <th scope="col">{users ? "For" : "If kept"}</th>
          </tr>
        </thead>
        <tbody>
          {ordered.map((removed, i) => (
            <Row
              key={removed.obstacle}
              page={page}
              studio={studio}
              removed={removed}
              order={i + 1}
              users={users?.get(removed.obstacle) ?? null}
            />
          ))}
        </tbody>
      </table>
      <Demolished page={page} plan={plan} />
      <Together page={page} plan={plan} />
      <Next page={page} />
    </Section>
  );
}

function vehicleCount({ agents }: Plan): number {
  return agents.filter(({ kind }) => kind === "ground").length;
}

function radiusOf(page: PageState, id: string): number {
  const agent = page.mission.value?.agents.find((one) => one.id === id);
  return agent?.kind === "ground" ? agent.radius : 0;
}

interface RowProps {
  page: PageState;
  studio: Studio | null;
  removed: Removed;
  order: number;
  users: readonly string[] | null; // of several vehicles: who drives there
}

function Row({ page, studio, removed, order, users }: RowProps) {
  const units = page.units.value;
  const id = removed.obstacle;
  const name = nameOf(page.shown.value!, id);
  const structures = page.shown.value!.map.cells.obstacle(id)?.structures?.length ?? 0;
  const lit = page.highlighted.value === id || page.selected.value === id;
  const point = (at: number | null) => () => (page.highlighted.value = at);
  const early = removed.entered_at !== null && removed.entered_at < removed.cleared_at - 1e-9;
  return (
    <tr
      class={lit ? "lit" : ""}
      onPointerEnter={point(id)}
      onPointerLeave={point(null)}
      onFocusCapture={point(id)}
      onBlurCapture={point(null)}
    >
      <td>
        <span class="badge">{order}</span>
      </td>
      <th scope="row">
        <button type="button" class="obstacle-name" onClick={() => page.showObstacle(id)}>
          <Name of={name.text} />
        </button>
        <span class="obstacle-facts">
          {area(removed.cells, units)}
          {structures > 1 ? `, part of ${structures} structures` : <OsmLink name={name} />}
        </span>
        {studio && <MarkButtons studio={studio} id={id} name={name.text} />}
      </th>
      <td>
        <data value={removed.cleared_at}>{clockTime(removed.cleared_at, units)}</data>
        {removed.by !== undefined && <AgentNames page={page} ids={[removed.by]} />}
      </td>
      <td class={early ? "early" : ""}>
        {removed.entered_at === null ? (
          "never"
        ) : (
          <data value={removed.entered_at}>{clockTime(removed.entered_at, units)}</data>
        )}
      </td>
      <td>
        {users && <AgentNames page={page} ids={users} />}
        {(!users || removed.saves !== undefined) && (
          <span class={users ? "if-kept" : ""}>
            <IfKept saves={removed.saves} units={page.objectiveUnits.value} />
            {users && " if kept"}
          </span>
        )}
      </td>
    </tr>
  );
}

// How much later it would be without a removal; not known while that is still looked for.
function IfKept({ saves, units }: { saves: Removed["saves"]; units: Units }) {
  if (saves === undefined) return <span class="pending">…</span>;
  if (saves === null) return <>no way</>;
  if (saves <= 0) return <>no later</>; // another choice is as good
  return <data value={saves}>+{clockTime(saves, units)}</data>;
}

const mostNamed = 4;

function AgentNames({ page, ids }: { page: PageState; ids: readonly string[] }) {
  const looks = page.looks.value;
  if (ids.length === 0) return <span class="agent-names">nobody</span>;
  if (ids.length > mostNamed) {
    return (
      <span class="agent-names" title={ids.join(", ")}>
        {ids.length} vehicles
      </span>
    );
  }
  return (
    <span class="agent-names">
      {ids.map((id) => (
        <span key={id}>
          <AgentDot look={looks.get(id)} />
          <Name of={id} />
        </span>
      ))}
    </span>
  );
}

function allOf(count: number): string {
  return count === 2 ? "Both" : `All ${count}`;
}

// How much goes in all; one row says it of itself, unless it is a part of several.
function Demolished({ page, plan }: { page: PageState; plan: Plan }) {
  const { removals, cells, structures } = plan.demolition ?? { removals: 0, cells: 0 };
  if (removals === 0 || (removals === 1 && structures === undefined)) return null;
  const of = structures === undefined ? "" : ` of ${structures === 1 ? "one structure" : `${structures} structures`}`;
  return (
    <p class="together">
      {removals === 1 ? "It clears" : `${allOf(removals)} together clear`} {area(cells, page.units.value)}
      {of}.
    </p>
  );
}

// Why the last column does not add up to what the curve shows.
function Together({ page, plan }: { page: PageState; plan: Plan }) {
  const [saved, count] = [savedBy(plan, page.units.value), plan.removed.length];
  const known = plan.removed.every((one) => one.saves !== undefined);
  if (saved === null || !known) return null;
  const total = <strong>{saved}</strong>;
  return (
    <p class="together">
      {count === 1 ? "It saves" : `${allOf(count)} together save`} {total}. <em>If kept</em> is how much later it would be if{" "}
      {count === 1 ? "it" : "only that one"} had to stay and the best other choice were made: another may take its place
      {count === 1 ? "." : ", so these do not add up."}
    </p>
  );
}

// What one removal more would take.
function Next({ page }: { page: PageState }) {
  const plan = page.results.plans.value.after?.plan;
  const shown = page.shown.value;
  const next = plan?.next?.filter((one) => one.saves !== null && one.saves > 0) ?? [];
  if (!shown || next.length === 0) return null;
  const now = reached(plan!);
  const gain = difference(now - next[0]!.saves!, now, page.objectiveUnits.value);
  return (
    <p class="next">
      One removal more would take{" "}
      {next.map(({ obstacle }, i) => (
        <>
          {i > 0 && ", "}
          <button
            type="button"
            class="obstacle-name inline"
            onClick={() => page.showObstacle(obstacle)}
            onPointerEnter={() => (page.highlighted.value = obstacle)}
            onPointerLeave={() => (page.highlighted.value = null)}
          >
            <Name of={nameOf(shown, obstacle).text} />
          </button>
        </>
      ))}{" "}
      and save {gain}.
    </p>
  );
}
