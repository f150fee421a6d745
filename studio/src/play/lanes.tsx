// Two lanes, ground and air: a bar while the agent moves, stripes while it waits, a number where an obstacle is
// breached. A click goes to that time; the slider below them does so for the keyboard.
import { useId } from "preact/hooks";
import type { Plan } from "../domain/plan";
import { type Lane, lanes } from "./activity";

interface LanesProps {
  plan: Plan;
  duration: number;
  time: number | null;
  formatTime: (time: number) => string;
  seek: (time: number) => void;
}

const names = { ground: "Ground", air: "Air" };

export function Lanes({ plan, duration, time, formatTime, seek }: LanesProps) {
  const share = (at: number): string => `${(100 * at) / duration}%`;
  const go = (event: PointerEvent & { currentTarget: HTMLElement }): void => {
    const box = event.currentTarget.getBoundingClientRect();
    seek(((event.clientX - box.left) / box.width) * duration);
  };
  return (
    <div class="lanes" aria-hidden="true">
      {lanes(plan).map((lane) => (
        <div key={lane.kind} class={`lane lane-${lane.kind}`}>
          <span class="lane-name">{names[lane.kind]}</span>
          <div
            class="lane-track"
            onPointerDown={(event) => {
              event.currentTarget.setPointerCapture(event.pointerId);
              go(event);
            }}
            onPointerMove={(event) => event.buttons === 1 && go(event)}
          >
            <LaneBars lane={lane} share={share} formatTime={formatTime} />
            {time !== null && (
              <svg class="lane-now">
                <line x1={share(time)} x2={share(time)} y1="0" y2="100%" />
              </svg>
            )}
          </div>
        </div>
      ))}
    </div>
  );
}

interface LaneBarsProps {
  lane: Lane;
  share: (at: number) => string;
  formatTime: (time: number) => string;
}

// Attributes of SVG, no style: the page's security policy forbids styles in elements.
function LaneBars({ lane, share, formatTime }: LaneBarsProps) {
  const stripes = useId();
  const verb = lane.kind === "air" ? "breached" : "entered";
  return (
    <svg class="lane-bars">
      <pattern id={stripes} width="6" height="6" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <rect class="lane-stripe" width="2.5" height="6" />
      </pattern>
      {lane.spans.map(({ kind, from, until }) => (
        <rect
          key={from}
          class={`lane-${kind}`}
          x={share(from)}
          y="25%"
          width={share(until - from)}
          height="50%"
          rx="2"
          {...(kind === "wait" ? { fill: `url(#${stripes})` } : {})}
        >
          <title>{`${kind === "wait" ? "waits" : "moves"} ${formatTime(until - from)}`}</title>
        </rect>
      ))}
      {lane.moments.map(({ number, time }) => (
        <g key={number} class="lane-moment">
          <title>{`${number} ${verb} at ${formatTime(time)}`}</title>
          <circle cx={share(time)} cy="50%" r={lane.kind === "air" ? 8 : 4} />
          {lane.kind === "air" && (
            <text x={share(time)} y="50%" dy="0.36em">
              {number}
            </text>
          )}
        </g>
      ))}
    </svg>
  );
}
