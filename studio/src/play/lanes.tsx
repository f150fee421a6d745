// A lane for each agent: a bar while it moves, stripes while it waits, a number where an obstacle is breached. A click goes
// to that time; the slider below them does so for the keyboard.
import { useEffect, useId, useMemo, useRef, useState } from "preact/hooks";
import { type AgentLook, looksOf } from "../domain/agents";
import { plainName } from "../domain/plain_name";
import { type Lane, lanes } from "./activity";
import type { Clock } from "./clock";
import { spread } from "./spread";
import { nameOf, type Story } from "./story";

interface LanesProps {
  story: Story;
  duration: number;
  clock: Clock;
  formatTime: (time: number) => string;
  moments: readonly number[]; // when something went wrong
  onPoint: (told: string | null) => void; // a wait is pointed at
}

const names = { ground: "Ground", air: "Air" };

export function Lanes({ story, duration, clock, formatTime, moments, onPoint }: LanesProps) {
  const { plan } = story;
  const share = (at: number): string => `${(100 * at) / duration}%`;
  const times = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0); // pixels of the lanes
  useEffect(() => {
    const watch = new ResizeObserver(([entry]) => entry && setWidth(entry.contentRect.width));
    watch.observe(times.current!);
    return () => watch.disconnect();
  }, []);
  const go = (event: PointerEvent): void => {
    const box = times.current!.getBoundingClientRect();
    if (event.clientX >= box.left - 4) clock.seek(((event.clientX - box.left) / box.width) * duration);
  };
  const told = (lane: Lane, from: number, until: number) =>
    `${nameOf(lane)} ${story.verbAt(lane.id, from)}, ${formatTime(until - from)}`;
  // Drawn once for a plan: frames of playback move the line alone.
  const bars = useMemo(() => {
    const looks = looksOf(plan.agents);
    return lanes(plan).map((lane) => (
      <AgentLane
        key={lane.id}
        lane={lane}
        look={looks.get(lane.id)}
        share={share}
        pixels={(at) => (at / duration) * width}
        formatTime={formatTime}
        onWait={(from, until) => onPoint(from === null ? null : told(lane, from, until))}
      />
    ));
  }, [story, duration, width]);
  return (
    <div class="lanes" aria-hidden="true">
      <div
        class="lane-rows"
        onPointerDown={(event) => {
          event.currentTarget.setPointerCapture(event.pointerId);
          go(event);
        }}
        onPointerMove={(event) => event.buttons === 1 && go(event)}
      >
        {bars}
        <div ref={times} class="lane-times">
          <svg class="lane-now lane-news">
            {moments.map((at) => (
              <line key={at} x1={share(at)} x2={share(at)} y1="0" y2="100%" />
            ))}
          </svg>
          <Now clock={clock} share={share} />
        </div>
      </div>
    </div>
  );
}

function Now({ clock, share }: { clock: Clock; share: (at: number) => string }) {
  const time = clock.time.value;
  if (time === null) return null;
  return (
    <svg class="lane-now">
      <line x1={share(time)} x2={share(time)} y1="0" y2="100%" />
    </svg>
  );
}

interface LaneProps {
  lane: Lane;
  look: AgentLook | undefined; // of a team
  share: (at: number) => string;
  pixels: (at: number) => number;
  formatTime: (time: number) => string;
  onWait: (...wait: [from: number, until: number] | [null, null]) => void;
}

function AgentLane({ lane, look, ...bars }: LaneProps) {
  const { id, kind } = lane;
  return (
    <div class={`lane lane-${kind} ${look ? `agent-${look.kind}-${look.colour}` : ""}`}>
      <span class="lane-name" title={look && id}>
        {look ? <bdi>{plainName(id)}</bdi> : names[kind]}
      </span>
      <div class="lane-track">
        <LaneBars lane={lane} {...bars} />
      </div>
    </div>
  );
}

// Attributes of SVG, no style: the page's security policy forbids styles in elements.
function LaneBars({ lane, share, pixels, formatTime, onWait }: Omit<LaneProps, "look">) {
  const stripes = useId();
  const verb = lane.opens ? "breached" : "entered";
  const radius = lane.opens ? 8 : 4;
  // What happens at nearly the same time stands side by side.
  const places = spread(lane.moments.map(({ time }) => pixels(time)), 2 * radius + 1);
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
          {...(kind === "wait" && {
            fill: `url(#${stripes})`,
            onPointerEnter: () => onWait(from, until),
            onPointerLeave: () => onWait(null, null),
          })}
        >
          {kind === "move" && <title>{`moves ${formatTime(until - from)}`}</title>}
        </rect>
      ))}
      {lane.moments.map(({ number, time }, i) => (
        <g key={number} class={lane.opens ? "lane-moment" : "lane-moment lane-entered"}>
          <title>{`${number} ${verb} at ${formatTime(time)}`}</title>
          <circle cx={places[i]} cy="50%" r={radius} />
          {lane.opens && (
            <text x={places[i]} y="50%" dy="0.36em">
              {number}
            </text>
          )}
        </g>
      ))}
    </svg>
  );
}
