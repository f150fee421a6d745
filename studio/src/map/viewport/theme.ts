// Colours of the map, light and dark: Okabe and Ito's (2008), safe for colour-blind readers, over a quiet
// ground. The light ones are those of `waybreaker plan --svg`. Those of a team's agents, and of what the ground is, are as far
// apart for all kinds of colour vision as tests/map/viewport/theme.test.ts says; those of the ground in greyscale, too.
import type { AgentLook } from "../../domain/agents";
import type { Look } from "../../domain/looks";

// Ground by when it is reached.
export interface BandColours {
  bands: readonly string[]; // soonest first, each lighter than the one before
  unreached: string;
  dot: string; // on what is not reached
  hatch: string; // where a plan gains
  hatchHalo: string; // beside it: each shows on light and on dark ground
}

export interface Theme {
  outside: string; // beyond the map
  paper: string;
  frame: string;
  street: string;
  streetEdge: string;
  path: string; // for people on foot
  rail: string;
  water: string;
  waterName: string;
  green: string;
  greenName: string;
  obstacles: Record<Look, { fill: string; edge: string }>;
  reach: BandColours;
  removed: string;
  removedTint: string; // under the hatching
  breach: string; // carries figures in `onBreach`
  onBreach: string;
  ground: string;
  air: string;
  airEdge: string; // around orange: its contrast
  airLine: string; // of thin lines
  paperGround: string; // the paper's choice
  paperAir: string;
  paperTint: string; // under its hatching
  onGround: string; // glyphs on a disc of colour `ground`
  onAir: string;
  vehicles: readonly string[]; // of a team; they carry figures in `onVehicle`
  onVehicle: string;
  fleet: readonly string[]; // its aircraft: warm colours, with a dark edge; figures in `onAir`
  noFly: string; // zones, over a tint
  keepOut: string;
  protect: string;
  exclude: string;
  select: string;
  ink: string;
  fadedInk: string;
  halo: string;
  card: string; // under small texts
}

export const light: Theme = {
  outside: "#efece6",
  paper: "#faf8f4",
  frame: "#cdc5b8",
  street: "#ffffff",
  streetEdge: "#e2dacd",
  path: "#e8e0d2",
  rail: "#b9b1a4",
  water: "#cfe2ec",
  waterName: "#345f76",
  green: "#e2ecd6",
  greenName: "#4f6b3c",
  obstacles: {
    removable: { fill: "#dcd4c8", edge: "#a89e8d" },
    barrier: { fill: "#a8885f", edge: "#785a30" },
    fixed: { fill: "#a89f93", edge: "#736a5e" },
    water: { fill: "#89b8d9", edge: "#4c7f9f" },
    cliff: { fill: "#776d62", edge: "#463f36" },
    forbidden: { fill: "#d7beca", edge: "#8d6f80" },
    off_road: { fill: "#d0dfb8", edge: "#7f8a66" },
    unknown: { fill: "#efece6", edge: "#6a635a" },
  },
  reach: {
    bands: ["#095d6c", "#208089", "#42a3a3", "#74c4b9", "#a8decf", "#dbf4e8"],
    unreached: "#fffefb",
    dot: "#6a635a",
    hatch: "#d55e00",
    hatchHalo: "#ffffff",
  },
  removed: "#d55e00",
  removedTint: "#ffe2cc",
  breach: "#b84a00",
  onBreach: "#ffffff",
  ground: "#0072b2",
  air: "#e69f00",
  airEdge: "#6b4300",
  airLine: "#6b4300",
  paperGround: "#a3457f",
  paperAir: "#a3457f",
  paperTint: "#f6e2ee",
  onGround: "#ffffff",
  onAir: "#3b2500",
  vehicles: ["#0072b2", "#d41972", "#065605", "#6c2787", "#816339", "#8150ea", "#34080a", "#2c39ca", "#690a36", "#110d72"],
  onVehicle: "#ffffff",
  fleet: ["#e69f00", "#f6e27a", "#bd8748", "#f0c09a"],
  noFly: "#9c1f6e",
  keepOut: "#3d3a8c",
  protect: "#00785a",
  exclude: "#5b5750",
  select: "#26231f",
  ink: "#26231f",
  fadedInk: "#6a635a",
  halo: "#ffffff",
  card: "#fffefbee",
};

export const dark: Theme = {
  outside: "#101214",
  paper: "#1a1d21",
  frame: "#3a3f46",
  street: "#25292d",
  streetEdge: "#15181b",
  path: "#24282c",
  rail: "#4a4f57",
  water: "#1c4055",
  waterName: "#8fbdd6",
  green: "#1f2d22",
  greenName: "#a3c490",
  obstacles: {
    removable: { fill: "#5d626b", edge: "#858c97" },
    barrier: { fill: "#896d49", edge: "#b89f77" },
    fixed: { fill: "#7d848d", edge: "#aeb6c0" },
    water: { fill: "#15577b", edge: "#5e9fc4" },
    cliff: { fill: "#a69d90", edge: "#d6cec2" },
    forbidden: { fill: "#3f3046", edge: "#8a7494" },
    off_road: { fill: "#2c3626", edge: "#7d8c6c" },
    unknown: { fill: "#101214", edge: "#848b94" },
  },
  reach: {
    bands: ["#0a5a56", "#1b747b", "#318e8c", "#57a89c", "#82c0af", "#b0d8c8"],
    unreached: "#25292d",
    dot: "#b3afa7",
    hatch: "#d55e00",
    hatchHalo: "#ffffff",
  },
  removed: "#f0772b",
  removedTint: "#623a24",
  breach: "#ff8a3d",
  onBreach: "#231003",
  ground: "#56b4e9",
  air: "#f0b429",
  airEdge: "#241600",
  airLine: "#f0b429",
  paperGround: "#e093bf",
  paperAir: "#e093bf",
  paperTint: "#45273a",
  onGround: "#04202f",
  onAir: "#2b1b00",
  vehicles: ["#56b4e9", "#d374a1", "#4fe364", "#cac6ee", "#ffd3b0", "#9088fc", "#8e8607", "#99fbf4", "#daf84d", "#96bfa6"],
  onVehicle: "#15181b",
  fleet: ["#f0b429", "#fff1a8", "#b8843c", "#f98f86"],
  noFly: "#f08cc8",
  keepOut: "#b3afff",
  protect: "#3ddcb0",
  exclude: "#b9bec6",
  select: "#ffffff",
  ink: "#f1eee8",
  fadedInk: "#b3afa7",
  halo: "#15181b",
  card: "#1c1f23ee",
};

// Of an agent of a team.
export function colourOf({ kind, colour }: AgentLook, { vehicles, fleet }: Theme): string {
  const colours = kind === "ground" ? vehicles : fleet;
  return colours[colour % colours.length]!;
}
