// Converts between the units of the page, metres and seconds, and those of the service, cells and cells per unit of
// time. For a map without a cell size the page uses cells and steps.
import type { MapDescription } from "./map";

// What the units of a file are on the page.
export interface Scale {
  cell: number; // metres, or 1
  seconds: number; // of a unit of time
}

// As it was said: dividing by a factor and multiplying again leaves something in the last digits.
export function scaled(value: number, factor: number): number {
  return Number((value * factor).toPrecision(15));
}

export type TimeUnit = "seconds" | "steps";

export interface Units {
  metric: boolean;
  cell: number; // metres, or 1
  // What a unit of plans' time is, and how many seconds.
  time: TimeUnit;
  seconds: number;
}

// What a file says of its unit of time: its speeds, in cells, and whether the unit is a second.
export interface Pace {
  inSeconds: boolean;
  speeds: readonly (number | undefined)[]; // 1 where nothing is said
}

// How many seconds a unit of time is. Where all speeds are 1 and nothing else is said, they stand for 1 m/s, as in the tables
// and pictures of the command.
export function secondsPerUnit({ inSeconds, speeds }: Pace, cell: number): number {
  return !inSeconds && speeds.length > 0 && speeds.every((speed = 1) => speed === 1) ? cell : 1;
}

// `pace`: of a plan that is in the units of its file; the page itself asks in metres and seconds.
export function unitsOf(map: Pick<MapDescription, "cell_size" | "georeference">, pace: Pace | null = null): Units {
  const metric = map.georeference !== null || map.cell_size !== 1;
  const cell = metric ? map.cell_size : 1;
  return { metric, cell, time: metric ? "seconds" : "steps", seconds: pace ? secondsPerUnit(pace, cell) : 1 };
}

const space = "\u00a0"; // between a number and its unit, where no line may break

// 16 min 15 s. From an hour on without seconds, unless it has to be `fine`.
export function duration(time: number, units: Units, fine = false): string {
  if (time < 0) return `−${duration(-time, units, fine)}`;
  return durationText(shownTime(time, units, fine), units, fine);
}

// As it is displayed: in seconds, or in steps.
function shownTime(time: number, units: Units, fine: boolean): number {
  const exact = time * units.seconds;
  const to = (digits: number) => Number(exact.toFixed(digits));
  if (units.time === "steps") return exact < 99.95 ? to(2) : to(1);
  if (exact < 59.95) return exact < 9.995 ? to(2) : to(1);
  return fine || to(0) < 3600 ? to(0) : 60 * Math.round(exact / 60);
}

function durationText(shown: number, units: Units, fine: boolean): string {
  if (units.time === "steps") return `${decimals(shown)}${space}steps`;
  if (shown < 60) return `${trimmed(shown, 2)}${space}s`;
  const [hours, minutes, seconds] = [Math.floor(shown / 3600), Math.floor(shown / 60) % 60, trimmed(shown % 60, 2)];
  const parts = [`${minutes}${space}min`, ...(seconds === "0" ? [] : [`${seconds}${space}s`])];
  return hours === 0 ? parts.join(" ") : [`${hours}${space}h`, ...(fine ? parts : parts.slice(0, 1))].join(" ");
}

// Times that stand beside each other: with seconds where these tell them apart.
export function durations(times: readonly number[], units: Units): string[] {
  const fine = areNear(times, units);
  return times.map((time) => duration(time, units, fine));
}

function areNear(times: readonly number[], units: Units): boolean {
  const [first = 0, ...others] = [...new Set(times)].sort((a, b) => a - b);
  return others.some((time, i) => (time - (others[i - 1] ?? first)) * units.seconds < 600);
}

// How much later one time is than another, as anyone finds who subtracts what `durations` says of them.
export function difference(earlier: number, later: number, units: Units): string {
  const fine = areNear([earlier, later], units);
  const shown = shownTime(later, units, fine) - shownTime(earlier, units, fine);
  return shown > 1e-9 ? durationText(Number(shown.toFixed(2)), units, true) : duration(later - earlier, units);
}

// 16:15, for where there is little room; rounded as `duration` is.
export function clockTime(time: number, units: Units): string {
  if (time < 0) return `−${clockTime(-time, units)}`;
  const shown = shownTime(time, units, true);
  if (units.time === "steps") return decimals(shown);
  if (shown < 60) return `${trimmed(shown, 2)}${space}s`;
  const [hours, minutes, seconds] = [Math.floor(shown / 3600), Math.floor(shown / 60) % 60, shown % 60];
  const two = (n: number) => String(n).padStart(2, "0");
  return hours > 0 ? `${hours}:${two(minutes)}:${two(seconds)}` : `${minutes}:${two(seconds)}`;
}

export function area(cells: number, units: Units): string {
  if (!units.metric) return `${grouped(cells)}${space}${cells === 1 ? "cell" : "cells"}`;
  return squareMetres(cells * units.cell * units.cell);
}

export function squareMetres(size: number): string {
  return `${size < 10 ? trimmed(size, 1) : grouped(Math.round(size))}${space}m²`;
}

export function length(cells: number, units: Units): string {
  return units.metric ? metres(cells * units.cell) : `${decimals(cells)}${space}cells`;
}

// A share as people say it: 22 %, 0.15 %.
export function percent(share: number): string {
  const value = 100 * share;
  if (value >= 9.95) return `${Math.round(value)}${space}%`;
  if (value >= 0.995) return `${trimmed(value, 1)}${space}%`;
  return value < 0.005 ? `${value > 0 ? "less than 0.01" : "0"}${space}%` : `${trimmed(value, 2)}${space}%`;
}

// For “within”: never less than the share itself.
export function percentUp(share: number): string {
  const value = 100 * share;
  const unit = value >= 9.95 ? 1 : value >= 0.995 ? 0.1 : 0.01;
  return `${trimmed(Math.ceil(value / unit - 1e-9) * unit, 2)}${space}%`;
}

function metres(value: number): string {
  return value < 10_000 ? `${grouped(Math.round(value))}${space}m` : `${trimmed(value / 1000, 1)}${space}km`;
}

function decimals(value: number): string {
  return value < 99.95 ? trimmed(value, 2) : grouped(Math.round(value * 10) / 10);
}

function trimmed(value: number, digits: number): string {
  return String(Number(value.toFixed(digits)));
}

function grouped(value: number): string {
  const [whole, rest] = String(value).split(".");
  const text = value >= 10_000 ? whole!.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole!;
  return rest ? `${text}.${rest}` : text;
}
