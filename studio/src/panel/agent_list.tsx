// The agents of a team: when each arrives, and what it can do. Of a pair only how to add to it.
import { Fragment } from "preact";
import type { Agents, MissionAgent } from "../domain/agents";
import { shownPer } from "../domain/mission";
import { objectiveOf, type Plan } from "../domain/plan";
import { clockTime, type Units } from "../domain/units";
import { landings } from "../mission/flight_words";
import type { PageState } from "../mission/page_state";
import { worthSaying } from "../mission/place_words";
import type { Studio } from "../mission/studio";
import { aloneArrival, gainOf } from "../mission/team_words";
import { arrival, breachOrder, waits } from "../play/motion";
import { AgentDot } from "./agent_dot";
import { AgentFields } from "./agent_fields";
import { Section } from "./controls";
import { Name } from "./name";

export function AgentList({ page, studio }: { page: PageState; studio: Studio | null }) {
  const mission = page.mission.value;
  if (!mission || !page.shown.value) return null;
  const isTeam = page.looks.value.size > 0;
  if (!isTeam && !studio) return null;
  return (
    <Section title="Vehicles and aircraft" kind="agents">
      {isTeam && <AgentTable page={page} studio={studio} agents={mission.agents} />}
      {isTeam && (
        <p class="agent-legend">
          On the map, a start is filled and a goal is a ring.
          {page.reach.value && " An arrow marks a place that is reached sooner or only now, a cross one that is not."}
        </p>
      )}
      {studio && (
        <div class="agent-buttons">
          <button type="button" class="button" onClick={() => studio.editor.addVehicle()}>
            Add vehicle
          </button>
          <button type="button" class="button" onClick={() => studio.editor.addAircraft()}>
            Add aircraft
          </button>
          {!isTeam && (
            <button
              type="button"
              class="button"
              title="The robot breaks what is in its way itself, as a bulldozer does"
              onClick={() => studio.editor.leaveItAlone()}
            >
              Robot alone
            </button>
          )}
        </div>
      )}
    </Section>
  );
}

interface TableProps {
  page: PageState;
  studio: Studio | null;
  agents: Agents;
}

function AgentTable({ page, studio, agents }: TableProps) {
  const plan = page.played.value ?? undefined;
  const chosen = page.chosenAgent.value;
  return (
    <div class="agent-scroll">
      <table class="agent-table">
        <caption class="spoken">When each agent arrives{page.old.value && "; out of date"}</caption>
        <thead>
          <tr>
            <th scope="col">Agent</th>
            <th scope="col">Arrives</th>
            <th scope="col" title="If it were alone, with nothing removed">
              Alone
            </th>
            <th scope="col">Waits</th>
          </tr>
        </thead>
        <tbody>
          {agents.map((agent, i) => (
            <Fragment key={i}>
              <AgentRow page={page} plan={plan} agent={agent} index={i} />
              {studio && chosen === i && (
                <tr class="agent-details">
                  <td colSpan={4}>
                    <AgentFields studio={studio} agents={agents} index={i} />
                  </td>
                </tr>
              )}
            </Fragment>
          ))}
        </tbody>
        {plan && plan.agents.length > 0 && <Totals plan={plan} page={page} />}
      </table>
    </div>
  );
}

interface RowProps {
  page: PageState;
  plan: Plan | undefined;
  agent: MissionAgent;
  index: number;
}

function AgentRow({ page, plan, agent, index }: RowProps) {
  const isChosen = page.chosenAgent.value === index;
  return (
    <tr class={isChosen ? "lit" : ""}>
      <th scope="row">
        <button
          type="button"
          class="agent-name"
          aria-expanded={isChosen}
          onClick={() => page.chooseAgent(isChosen ? null : index)}
        >
          <AgentDot look={page.looks.value.get(agent.id)} />
          <Name of={agent.id} />
        </button>
      </th>
      <AgentFigures plan={plan} closed={page.results.plans.value.before?.plan ?? null} id={agent.id} units={page.units.value} />
    </tr>
  );
}

interface FiguresProps {
  plan: Plan | undefined;
  closed: Plan | null; // with nothing removed
  id: string;
  units: Units;
}

function AgentFigures({ plan, closed, id, units }: FiguresProps) {
  const index = plan?.agents.findIndex((agent) => agent.id === id) ?? -1;
  const agent = plan?.agents[index];
  if (!plan || !agent) return <td colSpan={3}>…</td>;
  const at = arrival(agent);
  const time = (value: number) => <data value={value}>{clockTime(value, units)}</data>;
  if (agent.kind === "air") {
    const opens = breachOrder(plan).flatMap((one, i) => (one.by === id ? [i + 1] : []));
    return (
      <>
        <td>{agent.lost ? "lost" : time(at)}</td>
        <td colSpan={2}>
          {opens.length > 0 ? `opens ${opens.join(", ")}` : "opens nothing"}
          {landings(plan, agent, units).map((text, i) => (
            <small key={i} class="agent-gain">
              {text}
            </small>
          ))}
        </td>
      </>
    );
  }
  const clears = breachOrder(plan).flatMap((one, i) => (one.by === id ? [i + 1] : []));
  const isOnlyNow = closed?.agents.some((one) => one.id === id && one.reached === false);
  const alone = aloneArrival(plan, index);
  const waited = waits(agent).reduce((sum, { from, until }) => sum + until - from, 0);
  return (
    <>
      {agent.reached === false ? (
        <td class="missed">not reached</td>
      ) : (
        <td class={alone === null || at < alone * (1 - worthSaying) ? "sooner" : ""}>
          {time(at)}
          {isOnlyNow ? (
            <small class="agent-gain">only now</small>
          ) : (
            <Gain gain={gainOf(plan, closed, id)} of={at} units={units} />
          )}
          {clears.length > 0 && <small class="agent-gain">opens {clears.join(", ")}</small>}
        </td>
      )}
      <td>{alone === null ? "no way" : time(alone)}</td>
      <td>{waited > 0 ? time(waited) : "–"}</td>
    </>
  );
}

// What the removals are worth to one vehicle of the team.
function Gain({ gain, of, units }: { gain: number | null; of: number; units: Units }) {
  if (gain === null || Math.abs(gain) < worthSaying * of) return null;
  return (
    <small class="agent-gain" title="Than in the same team with nothing removed">
      {clockTime(Math.abs(gain), units)} {gain > 0 ? "sooner" : "later"}
    </small>
  );
}

// Of the whole team, together and each alone; first what counts.
function Totals({ plan, page }: { plan: Plan; page: PageState }) {
  const { agents } = page.mission.value!;
  const [units, per] = [page.units.value, shownPer({ agents, objective: "flowtime" })];
  const sums = { ...units, seconds: units.seconds / per };
  const rows = [
    { name: "Last arrival", member: "makespan", objective: "makespan", units },
    { name: "Last vehicle", member: "ground_makespan", objective: "ground-makespan", units },
    { name: per === 1 ? "Sum" : "Average", member: "flowtime", objective: "flowtime", units: sums },
  ] as const;
  const counts = ({ objective }: (typeof rows)[number]) => objective === objectiveOf(plan);
  const ordered = [...rows.filter(counts), ...rows.filter((row) => !counts(row))];
  const time = (value: number | null, of: Units) =>
    value === null ? "no way" : <data value={value}>{clockTime(value, of)}</data>;
  return (
    <tfoot>
      {ordered.map((row) => (
        <tr key={row.name} class={counts(row) ? "counts" : ""}>
          <th scope="row">{row.name}</th>
          <td>{time(plan.after[row.member], row.units)}</td>
          <td>{time(plan.before[row.member], row.units)}</td>
          <td />
        </tr>
      ))}
    </tfoot>
  );
}
