// What can go wrong at the moment that playback stands at, for each opening, vehicle and aircraft.
import type { Agent, Plan } from "../domain/plan";
import { clockTime } from "../domain/units";
import { refusalWords } from "../mission/flight_words";
import type { Studio } from "../mission/studio";
import { nameOf as agentName } from "../play/story";
import { whyNotRehearsed } from "../rehearse/rehearsal";
import { AgentDot } from "./agent_dot";
import { Section } from "./controls";
import { Icon } from "./icons";
import { delays, failure, loss, type Mishap, openingsToCome, rubbleAhead } from "./mishaps";
import { Name } from "./name";
import { nameOf } from "./obstacle_words";

const mostListed = 8; // of each kind: others can be asked on the map

export function Rehearse({ studio }: { studio: Studio }) {
  const { page, rehearsal } = studio;
  const plan = page.played.value;
  if (!plan || plan.agents.length === 0) return null;
  const why = whyNotRehearsed(plan);
  if (why) {
    return (
      <Section title="Rehearse" kind="rehearse">
        <p class="known">{why}</p>
      </Section>
    );
  }
  if (!rehearsal.available.value) return null;
  const isBegun = page.clock.time.value !== null || page.rehearsed.value !== null;
  return (
    <Section title="Rehearse" kind="rehearse">
      {isBegun ? (
        <>
          {rehearsal.held.value && <Mishaps studio={studio} plan={plan} />}
          {rehearsal.failure.value && (
            <p class="old-note" role="alert">
              <Icon name="warning" />
              {refusalWords(rehearsal.failure.value, page.units.value, (id) => nameOf(page.shown.value!, id).text)}
            </p>
          )}
        </>
      ) : (
        <>
          <p class="known">
            Play the mission, stop it anywhere, and let something go wrong. The rest is planned anew, and you see what it
            costs.
          </p>
          <button type="button" class="button" onClick={() => page.clock.play()}>
            Rehearse this plan
          </button>
        </>
      )}
    </Section>
  );
}

function Mishaps({ studio, plan }: { studio: Studio; plan: Plan }) {
  const { page, rehearsal } = studio;
  const { time } = rehearsal;
  const openings = openingsToCome(plan, time).slice(0, mostListed);
  const agents = chosenFirst(plan.agents, page.mission.value?.agents[page.chosenAgent.value ?? -1]?.id);
  const vehicles = agents.filter(({ kind }) => kind === "ground").slice(0, mostListed);
  const aircraft = agents.filter(({ kind }) => kind === "air").slice(0, mostListed);
  return (
    <>
      <p class="known">What goes wrong at {clockTime(time, page.units.value)}? Or right-click it on the map.</p>
      <ul class="mishaps">
        {openings.map(({ removed: { obstacle }, number }) => (
          <Row key={`opening ${obstacle}`} of={nameOf(page.shown.value!, obstacle).text} mishaps={[failure(studio, obstacle)]}>
            <span class="badge">{number}</span>
          </Row>
        ))}
        {vehicles.map((agent) => (
          <Row key={agent.id} of={capital(agentName(agent))} mishaps={[...delays(studio, agent), rubbleAhead(studio, agent)]}>
            <AgentDot look={page.looks.value.get(agent.id)} />
          </Row>
        ))}
        {aircraft.map((agent) => (
          <Row key={agent.id} of={capital(agentName(agent))} mishaps={[loss(studio, agent)]}>
            <AgentDot look={page.looks.value.get(agent.id)} />
          </Row>
        ))}
      </ul>
    </>
  );
}

interface RowProps {
  of: string; // whom it happens to
  mishaps: readonly (Mishap | null)[];
  children: preact.ComponentChildren;
}

function Row({ of, mishaps, children }: RowProps) {
  const possible = mishaps.filter((one) => one !== null);
  if (possible.length === 0) return null;
  return (
    <li>
      <span class="mishap-of">
        {children}
        <Name of={of} />
      </span>
      <span class="mishap-buttons">
        {possible.map(({ label, told, act }) => (
          <button key={label} type="button" class="button" aria-label={`${of}: ${label}`} title={told} onClick={act}>
            {label}
          </button>
        ))}
      </span>
    </li>
  );
}

function chosenFirst(agents: readonly Agent[], chosen: string | undefined): Agent[] {
  return [...agents.filter(({ id }) => id === chosen), ...agents.filter(({ id }) => id !== chosen)];
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
