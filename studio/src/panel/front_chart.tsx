// What each number of removals reaches (the Pareto front of removals and time), with the bound below as a faint line. Its
// columns stand under the slider's ticks.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Point } from "../domain/geometry";
import { mostRemovals } from "../domain/mission";
import { isUnknown, type Objective, valueOf } from "../domain/plan";
import { clockTime, duration, squareMetres, type Units } from "../domain/units";
import { onPrinting } from "../map/viewport/printing";
import type { PageState } from "../mission/page_state";
import type { Front } from "../planning/curve";
import { keyOf } from "../planning/request";
import { placeFigures } from "./front_labels";

const onPaper = 320; // pixels of a column (style/print.css)
const thumb = 22; // width of the slider's knob: its middle is what the columns are aligned with

interface Column {
  n: number;
  value: number | null; // null: no way with so few, or not yet known
  bound: number | null;
  area: number | null; // square metres that are demolished, where they are known
  further: boolean; // beyond where removals gain
  pending: boolean; // still being worked out
  unknown: boolean; // planning ended before
}

// Where the curve ends before the slider does, nothing further gains.
function columnsOf({ points, from, isDone }: Front, objective: Objective): Column[] {
  const last = points.length - 1;
  const values = points.map((point) => valueOf(point, objective));
  const least = values.findLast((value) => value !== null) ?? null;
  const gains = values.findIndex((value) => value !== null && least !== null && value <= least * (1 + 1e-9));
  const isKnown = points.every((point) => !isUnknown(point)); // else further removals might gain
  return Array.from({ length: Math.max(0, mostRemovals + 1 - from) }, (_, i) => {
    const pending = i > last && !isDone;
    const point = pending ? undefined : points[Math.min(i, last)];
    return {
      n: from + i,
      value: point ? valueOf(point, objective) : null,
      bound: point?.bound ? valueOf(point.bound, objective) : null,
      area: point?.area_m2 ?? null,
      further: isDone && isKnown && gains >= 0 && i > gains,
      pending,
      unknown: point !== undefined && isUnknown(point),
    };
  });
}

interface ChartProps {
  page: PageState;
  count: number;
  onChoose: ((n: number) => void) | null; // null: read-only
}

const height = 92;
const top = 26; // room for the figures over the points
const bottom = 10;

export function FrontChart({ page, count, onChoose }: ChartProps) {
  const [room, setRoom] = useState(340);
  const [printing, setPrinting] = useState(false);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const watch = new ResizeObserver(([entry]) => entry && setRoom(entry.contentRect.width));
    if (box.current) watch.observe(box.current);
    return () => watch.disconnect();
  }, []);
  useEffect(() => onPrinting(setPrinting), []);
  const width = printing ? onPaper : room; // nobody measures paper

  const front = page.results.front.value;
  const question = page.results.answered.value;
  const mission = page.mission.value;
  if (!front || !mission) {
    return (
      <div ref={box} class="front-chart empty">
        {!page.results.failure.value && <p>What each number reaches is being worked out…</p>}
      </div>
    );
  }
  const stale = question !== null && front.key !== keyOf.front(question);
  const units = page.objectiveUnits.value;
  const columns = columnsOf(front, mission.objective);
  const place = placer(columns, width);
  const line = (of: "value" | "bound", part: (column: Column) => boolean) => pathOf(columns.filter(part), of, place);
  const figures = figuresOf(columns, count, place, width, units);
  const gains = columns.findLast((column) => !column.further)?.n ?? front.from;
  return (
    <div
      ref={box}
      class={`front-chart ${stale ? "stale" : ""}`}
      role="group"
      aria-label="What each number of removals reaches"
    >
      <svg width={width} height={height} aria-hidden="true">
        <path class="front-bound" d={line("bound", () => true)} />
        <path class="front-flat" d={line("value", (column) => column.n >= gains)} />
        <path class="front-line" d={line("value", (column) => column.n <= gains)} />
        {columns.map(({ n, value, further }) =>
          value === null ? null : (
            <circle
              key={n}
              class={`front-point ${further ? "further" : ""} ${n === count ? "chosen" : ""}`}
              cx={place.x(n)}
              cy={place.y(value)}
              r={n === count ? 6 : further ? 2.5 : 4}
            />
          ),
        )}
      </svg>
      {columns.map((column) => (
        <button
          key={column.n}
          type="button"
          tabIndex={-1}
          class={`front-column ${column.n === count ? "chosen" : ""}`}
          style={{ left: `${place.x(column.n)}px`, width: `${place.step}px` }}
          title={columnLabel(column, units)}
          disabled={!onChoose}
          onClick={() => onChoose?.(column.n)}
        >
          <span class="spoken">{columnLabel(column, units)}</span>
          {isTold(column, columns) && <Figure column={column} at={figures.get(column.n)} place={place} units={units} />}
          <span class="front-tick" aria-hidden="true">
            {column.n}
          </span>
        </button>
      ))}
    </div>
  );
}

interface FigureProps {
  column: Column;
  at: Point | null | undefined; // null: no room; undefined: it is not on the curve
  place: Placer;
  units: Units;
}

function Figure({ column, at, place, units }: FigureProps) {
  if (at === null || (at === undefined && column.value !== null)) return null;
  const [x, y] = at ?? [place.x(column.n), column.pending ? height / 2 + 8 : top + 8];
  return (
    <span
      class="front-value"
      aria-hidden="true"
      style={{ left: `calc(50% + ${x - place.x(column.n)}px)`, top: `${y - 8}px` }}
    >
      {column.pending ? "…" : column.unknown ? "?" : column.value === null ? "no way" : clockTime(column.value, units)}
    </span>
  );
}

// Of several columns in a row without a way the first says so: the words are wider than a column.
function isTold(column: Column, columns: readonly Column[]): boolean {
  const before = columns.find(({ n }) => n === column.n - 1);
  const hasNoWay = ({ value, pending, unknown }: Column) => value === null && !pending && !unknown;
  return !(hasNoWay(column) && before && hasNoWay(before));
}

// Where the figures of those columns stand that have one.
function figuresOf(columns: Column[], count: number, place: Placer, width: number, units: Units): Map<number, Point | null> {
  const on = columns.filter((column) => column.value !== null);
  const told = on.filter((column) => !column.further || column.n === count);
  const pointOf = ({ n, value }: Column): Point => [place.x(n), place.y(value!)];
  const figures = told.map((column) => ({
    at: pointOf(column),
    text: clockTime(column.value!, units),
    bold: column.n === count,
  }));
  const places = placeFigures(figures, on.map(pointOf), { width, height });
  return new Map(told.map(({ n }, i) => [n, places[i]!]));
}

function columnLabel({ n, value, area, pending, unknown }: Column, units: Units): string {
  const what = n === 1 ? "1 removal" : `${n} removals`;
  if (pending) return `${what}: being worked out`;
  if (unknown) return `${what}: not worked out in time`;
  const demolished = area ? `, ${squareMetres(area)} demolished` : "";
  return value === null ? `${what}: no way` : `${what}: ${duration(value, units)}${demolished}`;
}

interface Placer {
  step: number;
  x: (n: number) => number;
  y: (value: number) => number;
}

function placer(columns: Column[], width: number): Placer {
  const values = columns.flatMap(({ value, bound }) => [value, bound]).filter((value) => value !== null);
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const spread = most - least || 1;
  const step = (width - thumb) / mostRemovals;
  return {
    step,
    x: (n) => thumb / 2 + n * step,
    y: (value) => top + ((most - value) / spread) * (height - top - bottom),
  };
}

function pathOf(columns: Column[], of: "value" | "bound", place: Placer): string {
  const points = columns.flatMap((column) => (column[of] === null ? [] : [[place.x(column.n), place.y(column[of])]]));
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x!.toFixed(1)} ${y!.toFixed(1)}`).join("");
}
