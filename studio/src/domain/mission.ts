// What is asked, as one immutable value: undo keeps old ones, a link holds one.
import type { Cell, Run } from "./geometry";
import type { Objective } from "./plan";

// A way to end up at the goal: what the layers of the map are.
export type LayerName = "before" | "after" | "paper";

export type Handle = "start" | "goal" | "air_start" | "air_goal";

// Markers to drag. An air marker that is absent stands where the ground agent's does.
export interface Markers {
  start: Cell;
  goal: Cell;
  air_start?: Cell;
  air_goal?: Cell;
}

export const handles: readonly Handle[] = ["start", "goal", "air_start", "air_goal"];

export function cellOf(markers: Markers, handle: Handle): Cell {
  if (handle === "air_start") return markers.air_start ?? markers.start;
  if (handle === "air_goal") return markers.air_goal ?? markers.goal;
  return markers[handle];
}

export function isAir(handle: Handle): boolean {
  return handle === "air_start" || handle === "air_goal";
}

export type Method = "exact" | "paper";

export type Mark = "protect" | "force" | "exclude";

// What is said about an obstacle. Only of what has been drawn need be said that it may go.
export type Choice = Mark | "allow";

export const mostRemovals = 8;

// Speeds and times as people say them: metres and seconds, or cells and steps where the map has no scale.
export interface Mission {
  map: string; // the map as it was before anything is drawn; obstacle ids are those of this map
  markers: Markers;
  removals: number | "auto"; // auto: as many as save at least the price each
  price: number;
  method: Method;
  objective: Objective;
  groundSpeed: number;
  airSpeed: number;
  breachTime: number;
  breachTimePerCell: number;
  radius: number; // of the ground agent, in cells
  marks: ReadonlyMap<number, Choice>; // by obstacle, or by key of a drawn wall
  walls: readonly Run[]; // drawn
  erased: readonly Run[];
  layers: readonly LayerName[];
  time: number | null; // where playback stands
}

export const defaults = {
  removals: 2,
  price: 10,
  method: "exact",
  objective: "makespan",
  groundSpeed: 1,
  airSpeed: 1,
  breachTime: 0,
  breachTimePerCell: 0,
  radius: 0.5,
  marks: new Map<number, Choice>() as ReadonlyMap<number, Choice>,
  walls: [] as readonly Run[],
  erased: [] as readonly Run[],
  layers: ["before", "after"] as readonly LayerName[],
  time: null,
} satisfies Omit<Mission, "map" | "markers">;

export function freshMission(map: string, markers: Markers): Mission {
  return { ...defaults, map, markers };
}

// A drawn wall has no id that lasts: it is called by one of its cells, as a number below 0.
export function wallKey([x, y]: Cell, width: number): number {
  return -(y * width + x) - 1;
}

export function wallCell(key: number, width: number): Cell {
  const index = -key - 1;
  return [index % width, Math.floor(index / width)];
}

export function withMark(mission: Mission, key: number, mark: Choice | null): Mission {
  const marks = new Map(mission.marks);
  if (mark) marks.set(key, mark);
  else marks.delete(key);
  return { ...mission, marks };
}

// What has to go needs as many removals.
export function withEnoughRemovals(mission: Mission): Mission {
  const { removals } = mission;
  const forced = marked(mission, "force").length;
  return removals === "auto" || removals >= forced ? mission : { ...mission, removals: forced };
}

// Whether a plan of one mission is a plan of the other: how a mission is displayed does not matter.
export function asksTheSame(a: Mission, b: Mission): boolean {
  const names = Object.keys(defaults).filter((name) => name !== "layers" && name !== "time");
  return ["map", "markers", ...names].every((name) => {
    const [one, other] = [a[name as keyof Mission], b[name as keyof Mission]];
    return one === other || text(one) === text(other);
  });
}

function text(value: unknown): string {
  return JSON.stringify(value instanceof Map ? [...value].sort(([a], [b]) => a - b) : value);
}

export function marked(mission: Mission, mark: Mark): number[] {
  return [...mission.marks].filter(([, has]) => has === mark).map(([key]) => key);
}

// Whether the map has to be changed before it is planned on.
export function hasEdits(mission: Mission): boolean {
  return mission.walls.length > 0 || mission.erased.length > 0 || [...mission.marks.values()].includes("exclude");
}
