// What the map shows, as a value, and what people do to it. The map draws scenes and knows no server, no URL and no
// panel.
import type { Agents, Handle, AgentLook } from "./agents";
import type { Bands } from "./bands";
import type { CellMap } from "./cell_map";
import type { Cell, Point, Run } from "./geometry";
import type { Ruled } from "./looks";
import type { Background, MapDescription } from "./map";
import type { LayerName, Mark } from "./mission";
import type { Plan } from "./plan";
import type { Reach } from "./reach";
import type { Rehearsed } from "./rehearsed";
import type { Zone } from "./zone";

export interface Layer {
  name: LayerName;
  plan: Plan;
}

// What follows the pointer while it is held down.
export type Brush = "wall" | "erase" | "rubble";
export type Tool = "move" | "zone" | "base" | Brush;

export function isBrush(tool: Tool): tool is Brush {
  return tool === "wall" || tool === "erase" || tool === "rubble";
}

export interface Scene {
  map: MapDescription;
  cells: CellMap;
  background: Background;
  agents: Agents;
  looks: ReadonlyMap<string, AgentLook>; // of a team: by id
  chosen: number | null; // the agent that is chosen in a list
  bands: Bands | null; // of time, in place of what lies around
  layers: Layer[]; // those shown; the last is on top
  marks: ReadonlyMap<number, Mark>; // by obstacle
  ruled: Ruled; // what is protected by tag or name
  zones: readonly Zone[];
  pointedZone: number | null; // pointed at in a list
  highlighted: number | null; // obstacle pointed at in a table
  selected: number | null; // obstacle whose card is open
  old: boolean; // whether the layers answer another mission than the markers show
  rehearsed: Rehearsed | null; // the top layer is what it shows
  reach: Reach | null; // which places are reached, where vehicles stand for places
  time: number | null; // of playback; null shows whole paths
  followed: Point | null; // what of the map is to stay in sight while it moves
  tool: Tool;
  editable: boolean; // whether markers can be dragged
  formatTime?: (time: number) => string; // formats the duration of waits; without it they are shown without a label
}

// What is at a place of the map. `at` of SceneEvents.ask is that place in pixels.
export interface Pointed {
  cell: Cell;
  obstacle: number | null;
  agents: readonly string[]; // in playback
}

export interface SceneEvents {
  // While a marker is dragged, once for each cell it comes to; `done` when it is let go.
  drag(handle: Handle, cell: Cell, done: boolean): void;
  select(obstacle: number | null, at: Cell | null): void;
  choose(agent: number): void; // a click on a marker of it
  hover(obstacle: number | null): void;
  passOver(cell: Cell | null): void; // where there are bands of time, once for each cell; null: off the map
  draw(tool: "wall" | "erase", runs: Run[]): void; // one stroke, when it ends
  outline(corners: readonly Point[], done: boolean): void; // of a zone, with each corner; `done` when it is closed
  base(at: Cell | null): void; // of an aircraft is set there; null: no more are
  // While rubble is held over the map, once for each cell it comes to; `done` when it is dropped. Null: it is not.
  drop(at: Cell | null, done: boolean): void;
  // What can be done with what is there is asked for; whether anything can.
  ask(what: Pointed, at: Point): boolean;
}
