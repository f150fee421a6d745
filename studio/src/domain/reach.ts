// Which places are reached, where vehicles do not get in each other's way: each stands for one.
export type PlaceState = "as before" | "sooner" | "only now" | "not reached";

export interface Reach {
  end: "start" | "goal"; // where the places are: at that end of the ways
  states: ReadonlyMap<string, PlaceState>; // by vehicle
}
