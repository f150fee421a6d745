// What the plan achieves, in one sentence, and how sure that is.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Progress } from "../api/client";
import { isTeam } from "../domain/plan";
import { duration, type Units } from "../domain/units";
import type { PageState } from "../mission/page_state";
import { Studio } from "../mission/studio";
import { teamArrivals, teamHeadline } from "../mission/team_words";
import { arrivals, figuresText, figureTexts, headline, nounOf, proof, type Proof, tooEarly } from "../mission/words";
import type { Judged } from "../planning/results";
import { askedRules } from "./asked_rules";
import { Icon, type IconName } from "./icons";
import { areBuildings } from "./obstacle_words";

export function HeadlineSection({ page }: { page: PageState }) {
  const after = page.results.plans.value.after;
  const failure = page.results.failure.value;
  const shown = page.shown.value;
  if (failure && failure.trouble === "refused") {
    return (
      <section class="headline bad" aria-label="Result">
        <h2>This mission cannot be planned</h2>
        <p>{failure.message}</p>
      </section>
    );
  }
  if (!after || !shown) {
    return (
      <section class="headline waiting" aria-label="Result">
        <h2>{waiting(page)}</h2>
        <Working page={page} />
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
  const words = team ? teamHeadline(after.plan, closed, buildings) : headline(after.plan, buildings);
  const who = team ? teamArrivals(after.plan, units) : arrivals(after.plan, units);
  const figures = words.figures ? figureTexts(words.figures, units) : [];
  const asked = page instanceof Studio ? null : askedRules(after.plan); // there the choices are listed
  const spoken = [words.figures ? `${words.title}: ${figuresText(words.figures, units)}.` : words.title, who].join(" ");
  return (
    <section class={`headline ${words.tone}`} aria-label="Result" aria-busy={page.outdated.value}>
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
      {who && <p class="arrivals">{who}</p>}
      {asked && <p class="arrivals">Asked for: {asked}.</p>}
      {words.remedies.length > 0 && (
        <ul class="remedies">
          {words.remedies.map((remedy) => (
            <li key={remedy}>{remedy}</li>
          ))}
        </ul>
      )}
      {page.old.value ? (
        <p class="old-note">
          <Icon name="warning" />
          This is the plan from before your last change.
        </p>
      ) : (
        <Sureness judged={after} buildings={buildings} checks={page instanceof Studio} />
      )}
      <Working page={page} />
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

interface SurenessProps {
  judged: Judged;
  buildings: boolean;
  checks: boolean; // whether there is somebody to check the plan
}

function Sureness({ judged, buildings, checks }: SurenessProps) {
  const sure = proof(judged.plan);
  if (!sure) return null;
  if (judged.draft) {
    return (
      <div class="sureness">
        <p class="pending">A draft: the exact plan follows</p>
      </div>
    );
  }
  const early = tooEarly(judged.plan);
  const { verdict } = judged;
  return (
    <div class="sureness">
      <p class={sure.tone}>
        <Icon name={signs[sure.tone]} />
        {sure.text}
      </p>
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
        (checks || verdict) && (
          <p class={verdict ? "sure" : "pending"}>
            <Icon name="check" />
            {verdict ? "Checked independently" : "Being checked…"}
          </p>
        )
      )}
    </div>
  );
}

// Only for plans one has to wait for.
function Working({ page }: { page: PageState }) {
  if (page instanceof Studio && page.results.failure.value?.trouble === "stopped") {
    return (
      <div class="working">
        <span>Stopped: what is shown may be older than what is asked.</span>
        <button type="button" class="button" onClick={() => page.planAgain()}>
          Plan again
        </button>
      </div>
    );
  }
  const progress = page.results.progress.value;
  if (!progress || progress.seconds < 0.4) return null;
  return (
    <div class="working">
      <progress aria-label="Planning" />
      <span>
        {doing(page, progress)}: {Math.round(progress.seconds)} s
        {progress.seconds >= 1 && <Known progress={progress} units={page.units.value} />}
      </span>
      {page instanceof Studio && (
        <button type="button" class="button" onClick={() => page.planner.stop()}>
          <Icon name="stop" /> Stop
        </button>
      )}
    </div>
  );
}

// How good the best plan so far is, and what none can be better than.
function Known({ progress: { best, bound }, units }: { progress: Progress; units: Units }) {
  if (best == null && bound == null) return null;
  const parts = [];
  if (best != null) parts.push(`best so far ${duration(best, units)}`);
  if (bound != null) parts.push(`none is below ${duration(bound, units)}`);
  return <span class="known">{parts.join("; ")}</span>;
}

function doing(page: PageState, progress: Progress): string {
  if (progress.state === "queued") return "Waiting for the planner";
  return isAnswered(page) ? "Looking for a better plan" : "Planning";
}

// Whether the plan shown is of the mission as it is.
function isAnswered(page: PageState): boolean {
  return page instanceof Studio && page.planner.isUpToDate();
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
