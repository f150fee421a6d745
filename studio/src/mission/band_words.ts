// Bands of time in words.
import { type Bands, gain } from "../domain/bands";
import type { Cell } from "../domain/geometry";
import { duration, durations, percent, type Units } from "../domain/units";

export interface BandLine {
  look: "band" | "unreached" | "sooner" | "only-now";
  band: number; // 1 is the first
  text: string;
  share: string; // of the ground
}

export function gainsNothing(bands: Bands): boolean {
  return !bands.gains.some((one, i) => one !== gain.none && bands.after[i] !== 0);
}

// What there is to see. The ground reached by a time is that of all bands until then.
export function bandLines(bands: Bands, units: Units): BandLine[] {
  const { after, gains } = bands.shares();
  let reached = 0;
  const lines: BandLine[] = durations(bands.ends, units).map((text, i) => ({
    look: "band",
    band: i + 1,
    text: `${bands.isInbound ? "at the goal" : "reached"} by ${text}`,
    share: percent((reached += after[i + 1]!)),
  }));
  const add = (look: BandLine["look"], text: string, share: number) => {
    if (share > 0) lines.push({ look, band: 0, text, share: percent(share) });
  };
  add("unreached", "not reached", after[bands.unreached]!);
  add("sooner", `${duration(bands.sooner, units)} or more sooner`, gains[gain.sooner]!);
  add("only-now", "reached only now", gains[gain.onlyNow]!);
  return lines;
}

// Of a cell: “Here by 10 min, before by 15 min”. Empty where there is no ground.
export function bandsHere(bands: Bands, cell: Cell, units: Units): string {
  const here = bands.at(cell);
  if (!here) return "";
  const by = (band: number) => `by ${duration(bands.ends[band - 1]!, units)}`;
  const place = bands.isInbound ? "From here" : "Here";
  if (here.after === bands.unreached) return `${place} not reached`;
  if (here.before === 0 || here.before === bands.unreached) return `${place} only now, ${by(here.after)}`;
  return `${place} ${by(here.after)}${here.before === here.after ? "" : `, before ${by(here.before)}`}`;
}
