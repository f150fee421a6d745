// Playback of a plan: play and pause, where in time, how fast, and lanes of what each agent does when.
import { useEffect, useMemo, useState } from "preact/hooks";
import { isPair } from "../domain/agents";
import type { Plan } from "../domain/plan";
import { activityAt } from "./activity";
import { type Clock, speeds } from "./clock";
import { Lanes } from "./lanes";
import { duration } from "./motion";
import { Story } from "./story";
import "./timeline.css";

export interface TimelineProps {
  plan: Plan; // the one that is played
  clock: Clock;
  formatTime: (time: number) => string; // a time of the plan as people read it, with its unit
  moments?: readonly number[] | undefined; // when something went wrong
}

export function Timeline({ plan, clock, formatTime, moments = [] }: TimelineProps) {
  const length = duration(plan);
  // A little less: rounded, the last step could lie beyond the end, and End would stop one short of it.
  const step = length / 400.000001;
  const story = useMemo(() => new Story(plan), [plan]);
  const [pointed, setPointed] = useState<string | null>(null);
  useEffect(() => clock.load(length), [clock, length]);
  useEffect(() => () => clock.stop(), [clock]);
  const playing = clock.playing.value;
  const time = clock.time.value ?? 0;
  const told = pointed ?? (clock.time.value === null ? null : story.at(time));
  if (length <= 0) return null;
  return (
    <div class="timeline" role="group" aria-label="Playback" style={{ "--lane-names": widthOfNames(plan) }}>
      {told !== null && (
        <p class="timeline-told" aria-hidden="true">
          {told}
        </p>
      )}
      <button
        type="button"
        class="timeline-play"
        aria-label={playing ? "Pause" : "Play"}
        onClick={() => clock.toggle()}
      >
        <svg viewBox="0 0 24 24" width="24" height="24" aria-hidden="true">
          <path fill="currentColor" d={playing ? "M6 4.5h4.2v15H6zm7.8 0H18v15h-4.2z" : "M7 4.2v15.6L20 12z"} />
        </svg>
      </button>
      <div class="timeline-middle">
        <Lanes story={story} duration={length} clock={clock} formatTime={formatTime} moments={moments} onPoint={setPointed} />
        <input
          class="timeline-scrubber"
          type="range"
          min={0}
          max={length}
          step={step}
          value={time}
          aria-label="Time of the mission"
          aria-valuetext={`${formatTime(time)} of ${formatTime(length)}: ${activityAt(story, time)}`}
          onInput={(event) => clock.seek(Number(event.currentTarget.value))}
        />
      </div>
      <div class="timeline-facts">
        <output class="timeline-time" aria-live="off">
          {formatTime(time)} <span>/ {formatTime(length)}</span>
        </output>
        <label class="timeline-speed">
          <span>Speed</span>
          <select
            value={String(clock.speed.value)}
            onChange={(event) => (clock.speed.value = Number(event.currentTarget.value))}
          >
            {speeds.map((speed) => (
              <option key={speed} value={String(speed)}>
                {`${speed}×`}
              </option>
            ))}
          </select>
        </label>
        <button
          type="button"
          class="timeline-follow"
          title="The map goes along with the agent"
          aria-pressed={clock.follows.value}
          onClick={() => (clock.follows.value = !clock.follows.value)}
        >
          Follow
        </button>
        <button type="button" class="timeline-stop" disabled={clock.time.value === null} onClick={() => clock.stop()}>
          Whole plan
        </button>
      </div>
    </div>
  );
}

// As the longest name of a team needs, as far as that leaves room for the lanes.
export function widthOfNames({ agents }: Plan): string {
  if (isPair(agents)) return "52px";
  const letters = Math.max(...agents.map(({ id }) => id.length));
  return `clamp(52px, ${8 * letters + 12}px, min(20vw, 180px))`;
}
