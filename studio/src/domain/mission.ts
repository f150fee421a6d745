// What is asked, as one immutable value: undo keeps old ones, a link holds one.
import { type Agents, pair } from "./agents";
import type { Also, Method } from "./also";
import type { Cell, Run } from "./geometry";
import type { Objective } from "./plan";
import type { TagFilter } from "./tag_filter";
import type { Zone } from "./zone";

// A way to end up at the goal: what the layers of the map are.
export type LayerName = "before" | "after" | "paper";

export type { Method };

// What the vehicles of a team do once they have arrived: stand in the way of others, or vanish.
export type AtGoal = "stay" | "leave";

export type Mark = "protect" | "force" | "exclude";

// What is said about an obstacle. Only of what has been drawn need be said that it may go.
export type Choice = Mark | "allow";

export const mostRemovals = 8;

// Speeds and times as people say them: metres and seconds, or cells and steps where the map has no scale.
export interface Mission {
  map: string; // the map as it was before anything is drawn; obstacle ids are those of this map
  agents: Agents;
  removals: number | "auto"; // auto: as many as save at least the price each
  price: number;
  method: Method;
  objective: Objective;
  breachTime: number;
  breachTimePerCell: number;
  rubble: number; // what a vehicle takes longer for each opening
  separation: number; // cells that the vehicles of a team keep between them
  atGoal: AtGoal;
  collisions: boolean; // or vehicles get past each other anywhere
  unreached: number | null; // where they do not: as what a vehicle counts that does not arrive; null: each must
  marks: ReadonlyMap<number, Choice>; // by obstacle, or by key of a drawn wall
  protectAll: readonly TagFilter[]; // beside what is marked: all obstacles that any of these means
  walls: readonly Run[]; // drawn
  erased: readonly Run[];
  zones: readonly Zone[];
  also: Also; // what there is no control for
  layers: readonly LayerName[];
  bands: boolean; // of time, where there are any
  time: number | null; // where playback stands
}

export const defaults = {
  removals: 2,
  price: 10,
  method: "exact",
  objective: "makespan",
  breachTime: 0,
  breachTimePerCell: 0,
  rubble: 0,
  separation: 0,
  atGoal: "stay",
  collisions: true,
  unreached: null,
  marks: new Map<number, Choice>() as ReadonlyMap<number, Choice>,
  protectAll: [] as readonly TagFilter[],
  walls: [] as readonly Run[],
  erased: [] as readonly Run[],
  zones: [] as readonly Zone[],
  also: {} as Also,
  layers: ["before", "after"] as readonly LayerName[],
  bands: true,
  time: null,
} satisfies Omit<Mission, "map" | "agents">;

// How far vehicles keep from each other, and what counts where one does not arrive, in the terms of requests and files.
export function meetingRules({ separation, atGoal, collisions, unreached }: Mission) {
  if (collisions) return { separation, at_goal: atGoal };
  return { separation: 0, at_goal: atGoal, collisions, ...(unreached !== null && { unreached }) };
}

// Where a mission begins and ends.
export interface Ends {
  start: Cell;
  goal: Cell;
  radius?: number | undefined; // of the vehicle, where the map says what is usual there
}

export function freshMission(map: string, { start, goal, radius }: Ends): Mission {
  return { ...defaults, map, agents: pair(start, goal, radius) };
}

// What values of the objective are divided by where they are shown: the sum of arrivals that count by weights says nothing
// to anyone, their average does.
export function shownPer({ agents, objective }: Pick<Mission, "agents" | "objective">): number {
  const isWeighed = objective === "flowtime" && agents.some(({ weight }) => weight !== 1);
  return (isWeighed && agents.reduce((sum, { weight }) => sum + weight, 0)) || 1;
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

const shownOnly = ["layers", "bands", "time"];

// Whether a plan of one mission is a plan of the other: how a mission is displayed does not matter.
export function asksTheSame(a: Mission, b: Mission): boolean {
  const names = Object.keys(defaults).filter((name) => !shownOnly.includes(name));
  return ["map", "agents", ...names].every((name) => {
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
