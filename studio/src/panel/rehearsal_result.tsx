// What went wrong, what it costs, and what the lines on the map mean; in place of what the plan achieves.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Studio } from "../mission/studio";
import { proof } from "../mission/words";
import { stepWords, sumWords, type Telling } from "../rehearse/words";
import { Icon } from "./icons";
import { nameOf } from "./obstacle_words";

export function RehearsalResult({ studio }: { studio: Studio }) {
  const { page, rehearsal } = studio;
  const steps = rehearsal.steps.value;
  const last = steps.at(-1);
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    if (section.current) bringIntoSight(section.current);
  }, [last]);
  if (!last) return null;
  const units = page.units.value;
  const telling = tellingOf(studio);
  const told = stepWords(last, telling);
  const sum = sumWords(steps, units);
  const earlier = steps.slice(0, -1);
  const busy = rehearsal.working.value;
  return (
    <section ref={section} class={`headline rehearsal ${last.is === null ? "bad" : "plain"}`} aria-label="Result" aria-busy={busy}>
      <h2>{told}</h2>
      {sum && <p class="arrivals">{sum}</p>}
      {earlier.length > 0 && (
        <>
          <p class="arrivals">Before that:</p>
          <ol class="happened">
            {earlier.map((step) => (
              <li key={`${step.now} ${step.news.kind}`}>{stepWords(step, telling)}</li>
            ))}
          </ol>
        </>
      )}
      <Sureness studio={studio} />
      {last.is !== null && <Legend />}
      <div class="rehearsal-buttons">
        <button type="button" class="button" onClick={() => rehearsal.undo()}>
          <Icon name="undo" />
          Undo
        </button>
        <button type="button" class="button" onClick={() => rehearsal.reset()}>
          Back to the plan
        </button>
      </div>
      <Spoken text={sum ? `${told} ${sum}` : told} />
    </section>
  );
}

// Where the panel lies below the map, that comes first: it has the sentence, too.
function bringIntoSight(result: HTMLElement): void {
  const panel = result.closest(".panel");
  if (panel && getComputedStyle(panel).overflowY === "visible") scrollTo({ top: 0 });
  else result.scrollIntoView({ block: "nearest" });
}

function tellingOf({ page }: Studio): Telling {
  return { units: page.units.value, obstacle: (id) => nameOf(page.shown.value!, id).text };
}

// The same on the map, where the panel lies below it.
export function RehearsalCaption({ studio }: { studio: Studio }) {
  const last = studio.rehearsal.steps.value.at(-1);
  if (!last) return null;
  return (
    <p class="rehearsal-caption" aria-hidden="true">
      {stepWords(last, tellingOf(studio))}
    </p>
  );
}

function Sureness({ studio }: { studio: Studio }) {
  const { held, checked } = studio.rehearsal;
  const plan = held.value;
  const sure = plan && proof(plan);
  if (!plan || !sure) return null;
  const report = checked.value?.plan === plan ? checked.value.report : null;
  return (
    <div class="sureness">
      <p class={sure.tone}>
        <Icon name={sure.tone === "sure" ? "check" : sure.tone === "plain" ? "about" : "warning"} />
        {sure.text}
      </p>
      {report?.valid && (
        <p class="sure">
          <Icon name="check" />
          Checked independently
        </p>
      )}
      {report && !report.valid && (
        <p class="alarm" role="alert">
          <Icon name="warning" />
          <span>
            <strong>Do not use this plan.</strong> The independent check found: {report.violations[0]?.message}
          </span>
        </p>
      )}
    </div>
  );
}

function Legend() {
  return (
    <p class="rehearsal-legend">
      <span>
        <svg width="34" height="12" aria-hidden="true">
          <path class="line-committed" d="M2 6h30" />
          <path class="line-new" d="M2 6h30" />
        </svg>
        committed until the diamond
      </span>
      <span>
        <svg width="34" height="12" aria-hidden="true">
          <path class="line-new" d="M2 6h30" />
        </svg>
        new
      </span>
      <span>
        <svg width="34" height="12" aria-hidden="true">
          <path class="line-old" d="M2 6h30" />
        </svg>
        as it was planned
      </span>
    </p>
  );
}

// Screen readers hear it once rubble that is held over the map has been dropped.
function Spoken({ text }: { text: string }) {
  const [settled, setSettled] = useState("");
  useEffect(() => {
    const timer = setTimeout(() => setSettled(text), 700);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <p class="spoken" aria-live="polite">
      {settled}
    </p>
  );
}
