// Whether a gain is one: whoever sees the same time does not want a building to go for it.
import { difference, durations, percent, type Units } from "../domain/units";

// Less than this, of the time or in seconds, is no gain.
export const leastGain = { share: 0.001, seconds: 1 };
const minute = 60; // seconds: shorter times are told in tenths, and those tell

export interface Compared {
  before: number; // with nothing removed
  after: number;
}

export function isNegligible({ before, after }: Compared, units: Units): boolean {
  const change = Math.abs(before - after);
  if (change < leastGain.share * before) return true;
  const isLong = units.time === "seconds" && before * units.seconds >= minute;
  return isLong && change * units.seconds < leastGain.seconds;
}

// "would gain 0.06 %", and what it does to the sum of all times.
export function gainWords(of: Compared, sum: { before: number | null; after: number | null }, units: Units): string {
  const share = (of.before - of.after) / of.before;
  const own = share > 1e-9 ? `gains ${percent(share)}` : share < -1e-9 ? `costs ${percent(-share)}` : "gains nothing";
  const { before, after } = sum;
  if (before === null || after === null || isNegligible({ before, after }, units)) return own;
  if (after > before) return `${own}, and adds ${difference(before, after, units)} to the sum of all times, ${durations([before], units)[0]}`;
  return `${own}, and takes ${difference(after, before, units)} off the sum of all times, ${durations([before], units)[0]}`;
}
