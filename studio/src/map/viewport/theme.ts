// Colours of the map, light and dark: Okabe and Ito's (2008), safe for colour-blind readers, over a quiet
// ground. The light ones are those of `waybreaker plan --svg`. The ten of a team's vehicles were searched for: as far from
// each other as can be, for all kinds of colour vision (tests/map/viewport/theme.test.ts).
import type { AgentLook } from "../../domain/agents";
import type { Look } from "../../domain/looks";

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
  waterName: "#3f6d86",
  green: "#e2ecd6",
  greenName: "#4f6b3c",
  obstacles: {
    removable: { fill: "#ddd6ca", edge: "#aba191" },
    barrier: { fill: "#a98f6d", edge: "#8a7050" },
    fixed: { fill: "#b5ab9c", edge: "#7d7467" },
    water: { fill: "#a3cbe3", edge: "#5f95b5" },
    cliff: { fill: "#7a7166", edge: "#4d463d" },
    forbidden: { fill: "#e0d8e0", edge: "#8f7f95" },
  },
  removed: "#d55e00",
  removedTint: "#fbe3d1",
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
  fleet: ["#e69f00", "#f7d454", "#c9843f", "#f2a38f"],
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
  paper: "#1c1f23",
  frame: "#3a3f46",
  street: "#2b3036",
  streetEdge: "#15181b",
  path: "#2a2e33",
  rail: "#4a4f57",
  water: "#1c4055",
  waterName: "#8fbdd6",
  green: "#1f2d22",
  greenName: "#a3c490",
  obstacles: {
    removable: { fill: "#474d56", edge: "#6a727d" },
    barrier: { fill: "#8a7556", edge: "#ab9470" },
    fixed: { fill: "#767e89", edge: "#a3abb5" },
    water: { fill: "#205777", edge: "#5e9fc4" },
    cliff: { fill: "#a39b90", edge: "#d0c8bc" },
    forbidden: { fill: "#38303f", edge: "#83738c" },
  },
  removed: "#f0772b",
  removedTint: "#4a2c19",
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
  vehicles: ["#56b4e9", "#db7aa6", "#3ed670", "#cec6f8", "#fad8ab", "#968dfd", "#85a25e", "#92fcf2", "#f1fb47", "#8fcdb9"],
  onVehicle: "#15181b",
  fleet: ["#f0b429", "#fff1a8", "#c98a4b", "#ffb3a0"],
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
