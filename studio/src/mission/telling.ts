// What the headline of a plan says, and how it is told.
import type { Units } from "../domain/units";

export interface Headline {
  tone: "good" | "plain" | "bad";
  title: string;
  // The result, and the result without removals: shown large, as figures.
  figures: { after: number; before: number | null } | null;
  note?: string; // what else is to be said of the removals
  remedies: string[]; // what can be done where there is no plan
}

// How a plan is told.
export interface Telling {
  units: Units;
  buildings: boolean; // whether all that is removed is sure to be buildings
  isLooking: boolean; // whether a better plan may follow: then nothing is said that only the end of the search can say
  isFound?: boolean; // whether there is one already that is not shown yet
}
