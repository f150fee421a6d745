// What the plan achieves, in one sentence, and how sure that is.
import { useEffect, useRef, useState } from "preact/hooks";
import { isTeam } from "../domain/plan";
import { refusalWords } from "../mission/flight_words";
import type { PageState } from "../mission/page_state";
import type { Studio } from "../mission/studio";
import { reachWords } from "../mission/place_words";
import { surfaceWords } from "../mission/surface_words";
import { teamArrivals, teamHeadline } from "../mission/team_words";
import { arrivals, figuresText, figureTexts, headline, nounOf, proof, type Proof, tooEarly } from "../mission/words";
import { barredHeadline } from "../mission/zone_words";
import type { Judged } from "../planning/results";
import { askedRules } from "./asked_rules";
import { Flights, flightTexts } from "./flights";
import { Icon, type IconName } from "./icons";
import { areBuildings, nameOf } from "./obstacle_words";
import { SearchLine } from "./search_line";

export function HeadlineSection({ page, studio }: { page: PageState; studio: Studio | null }) {
  const after = page.results.plans.value.after;
  const failure = page.results.failure.value;
  const shown = page.shown.value;
  if (failure && failure.trouble === "refused") {
    return (
      <section class="headline bad" aria-label="Result">
        <h2>This mission cannot be planned</h2>
        <p>{refusalWords(failure.message, page.units.value, (id) => (shown ? nameOf(shown, id).text : `Obstacle ${id}`))}</p>
      </section>
    );
  }
  if (!after || !shown) {
    return (
      <section class="headline waiting" aria-label="Result">
        <h2>{waiting(page)}</h2>
        {studio && !studio.client.imports && !page.shown.value && (
          <p>
            The map and the planner are fetched once, about a megabyte. From then on this page plans by itself, without a
            server.
          </p>
        )}
        {studio && page.shown.value && <SearchLine studio={studio} />}
      </section>
    );
  }
  const units = page.units.value;
  const buildings = areBuildings(
    shown,
    after.plan.removed.map((one) => one.obstacle),
  );
  const team = isTeam(after.plan);
  const closed = page.results.plans.value.before?.plan ?? null;
  const isLooking = after.rough !== undefined;
  const isFound = isLooking && page.results.progress.value?.best != null;
  const objectiveUnits = page.objectiveUnits.value;
  const telling = { units: objectiveUnits, buildings, isLooking, isFound };
  const barred = isLooking ? null : barredHeadline(after.plan, units);
  const words = barred ?? (team ? teamHeadline(after.plan, closed, telling) : headline(after.plan, telling));
  const reach = page.reach.value;
  const who = reach ? reachWords(reach) : team ? teamArrivals(after.plan, units) : arrivals(after.plan, units);
  const surface = surfaceWords(after.plan, units);
  const figures = words.figures ? figureTexts(words.figures, objectiveUnits) : [];
  const asked = studio ? null : askedRules(after.plan); // there the choices are listed
  const told = words.figures ? `${words.title}: ${figuresText(words.figures, objectiveUnits)}.` : words.title;
  const spoken = [told, words.note, who, surface, ...flightTexts(page, after.plan)].filter((part) => part).join(" ");
  return (
    <section class={`headline ${words.tone}`} aria-label="Result" aria-busy={page.outdated.value || isLooking}>
      <h2>
        {words.title}
        {words.figures && ":"}
      </h2>
      {words.figures && (
        <p class="figures">
          <data class="figure" value={words.figures.after}>
            {figures[0]}
          </data>
          {words.figures.before !== null && (
            <span class="instead">
              {" instead of "}
              <data value={words.figures.before}>{figures[1]}</data>
            </span>
          )}
        </p>
      )}
      {words.note && <p class="arrivals">{words.note}</p>}
      {who && <p class="arrivals">{who}</p>}
      {surface && <p class="arrivals">{surface}</p>}
      <Flights page={page} plan={after.plan} />
      {asked && <p class="arrivals">Asked for: {asked}.</p>}
      {words.remedies.length > 0 && (
        <ul class="remedies">
          {words.remedies.map((remedy) => (
            <li key={remedy}>{remedy}</li>
          ))}
        </ul>
      )}
      {page.old.value && (
        <p class="old-note">
          <Icon name="warning" />
          This is the plan from before your last change.
        </p>
      )}
      {studio && <SearchLine studio={studio} />}
      {!page.old.value && (
        <Sureness judged={after} buildings={buildings} checking={checkOf(studio)} />
      )}
      <Spoken text={page.old.value ? `Out of date: ${spoken}` : spoken} />
    </section>
  );
}

function waiting(page: PageState): string {
  if (page.loading.value) return "Loading the map…";
  if (!page.shown.value) return "Choose a map to begin";
  return page.results.failure.value?.trouble === "stopped" ? "No plan yet" : "Planning…";
}

const signs: Record<Proof["tone"], IconName> = { sure: "check", plain: "about", unsure: "warning" };

// Whether there is somebody to check the plan, and does.
type Checking = "now" | "no" | "nobody";

function checkOf(studio: Studio | null): Checking {
  if (!studio) return "nobody";
  return studio.page.results.working.value ? "now" : "no";
}

interface SurenessProps {
  judged: Judged;
  buildings: boolean;
  checking: Checking;
}

// What is proven before the search has ended stands beside its progress.
function Sureness({ judged, buildings, checking }: SurenessProps) {
  const sure = proof(judged.plan);
  if (judged.rough === "draft") return <Draft />;
  if (!sure) return null;
  const early = tooEarly(judged.plan);
  const { verdict } = judged;
  return (
    <div class="sureness">
      {!judged.rough && (
        <p class={sure.tone}>
          <Icon name={signs[sure.tone]} />
          {sure.text}
        </p>
      )}
      {early > 0 && (
        <p class="unsure">
          <Icon name="warning" />
          Drives into {early === judged.plan.removed.length && early > 1 ? "all" : early} {nounOf(early, buildings)}{" "}
          before {early === 1 ? "it is" : "they are"} open: the paper’s rules do not mind
        </p>
      )}
      {verdict?.valid === false ? (
        <p class="alarm" role="alert">
          <Icon name="warning" />
          <span>
            <strong>Do not use this plan.</strong> The independent check found: {verdict.reason}
          </span>
        </p>
      ) : (
        (checking !== "nobody" || verdict) && (
          <p class={verdict ? "sure" : "pending"}>
            <Icon name="check" />
            {verdict ? "Checked independently" : checking === "now" ? "Being checked…" : "Not checked"}
          </p>
        )
      )}
    </div>
  );
}

// As much room as what is said of the plan, so that nothing moves under the mouse.
function Draft() {
  return (
    <div class="sureness">
      <p class="pending">
        <Icon name="about" />
        Draft: the plan follows once the mouse rests
      </p>
      <p class="pending">
        <Icon name="check" />
        Not checked
      </p>
    </div>
  );
}

// Screen readers hear the result when it has settled, not at every step of a drag.
function Spoken({ text }: { text: string }) {
  const [settled, setSettled] = useState("");
  const timer = useRef(0);
  useEffect(() => {
    timer.current = window.setTimeout(() => setSettled(text), 700);
    return () => clearTimeout(timer.current);
  }, [text]);
  return (
    <p class="spoken" aria-live="polite">
      {settled}
    </p>
  );
}
