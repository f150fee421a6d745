// Mission files: waybreaker-mission/1 (docs/contract.md), as the command and the service read them. What only the page
// knows, such as drawn walls, stands in `page`, which they pass by.
import { isChoice } from "../domain/abilities";
import { type AgentDocument, agentDocuments, agentsOf } from "../domain/agent_document";
import { hasPaperMethod, usualVehicle } from "../domain/agents";
import { type Also, alsoNames, alsoOf, alsoText, methodWords } from "../domain/also";
import { marked, meetingRules, type Method, type Mission, mostRemovals } from "../domain/mission";
import { filterText, inOne } from "../domain/tag_filter";
import { scaled, secondsPerUnit } from "../domain/units";
import { withTimes, zoneCollection, zonesOf, zonesText } from "../domain/zone";
import { holdsMission } from "./address";
import { agentsInQuery, encodeLink } from "./link";

const format = "waybreaker-mission/1";

interface MissionDocument {
  format: typeof format;
  overlays?: unknown; // { file, as, width? }[]: what is laid over the map before
  time_unit?: "s"; // on maps with metres
  agents: AgentDocument[];
  rules?: Record<string, unknown>;
  method?: Record<string, unknown>;
  limits?: unknown;
  page?: Record<string, unknown>;
}

// What a mission file says, as the query of a link.
export interface MissionQuery {
  query: string;
  leftOut: string[]; // what the page has no words for
}

// What the file needs to know of the map that the mission is on.
export interface MapOfMission {
  width: number;
  cell: number; // metres, or 1
  metric: boolean;
  file?: string | undefined; // where the person has it
}

// `removals`: their number, where the mission leaves it open.
export function missionFile(mission: Mission, map: MapOfMission, removals: number): string {
  const { agents, method } = mission;
  const count = mission.removals === "auto" ? removals : mission.removals;
  const said: Also = { ...methodWords(hasPaperMethod(mission) ? method : "exact", count), ...mission.also };
  const { corners } = said;
  const isCut = (agent: AgentDocument) => corners !== undefined && agent.kind === "ground";
  const ids = (mark: "protect" | "force") => marked(mission, mark).filter((key) => key > 0).sort((a, b) => a - b);
  const document: MissionDocument = {
    format,
    ...(map.metric && { time_unit: "s" as const }),
    agents: agentDocuments(agents, map.cell).map((one) => (isCut(one) ? { ...one, corners: String(corners) } : one)),
    rules: {
      removals: count,
      protect: [...ids("protect"), ...mission.protectAll.map(filterText)],
      force: ids("force"),
      breach_time: mission.breachTime,
      breach_time_per_cell: mission.breachTimePerCell,
      ...(mission.rubble !== 0 && { rubble: mission.rubble }),
      ...only(said, alsoNames.rules),
      objective: mission.objective,
      ...meetingRules(mission),
      ...(mission.zones.length > 0 && { zones: zoneCollection(mission.zones) }),
    },
    method: only(said, alsoNames.method),
    page: pageOf(mission, map),
  };
  return `${JSON.stringify(document, null, 2)}\n`;
}

export function isMissionFile(value: unknown): value is Record<string, unknown> {
  return isObject(value) && value.format === format;
}

// Null where nobody drives in it. `cell` is that of the map on the page.
export function queryOfFile(value: Record<string, unknown>, cell: number): MissionQuery | null {
  return Array.isArray(value.agents) ? queryOfDocument(value as unknown as MissionDocument, cell) : queryOfFormerFile(value);
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function only(said: Also, names: readonly string[]): Also {
  return Object.fromEntries(Object.entries(said).filter(([name]) => names.includes(name)));
}

// Of the mission's link what the file has no other place for.
function pageOf(mission: Mission, { width, cell, file }: MapOfMission): Record<string, string | number> {
  const walls = new Map([...mission.marks].filter(([key, mark]) => key < 0 || mark === "exclude" || mark === "allow"));
  const link = new URLSearchParams(encodeLink({ ...mission, marks: walls }, width));
  const others = [...inRules, ...timesInRules, "method", "protect_all", "zones", "also"];
  for (const name of [...agentsInQuery(mission.agents, null).keys(), ...others]) link.delete(name);
  if (mission.removals !== "auto") link.delete("removals");
  return { ...Object.fromEntries(link), cell_size: cell, ...(file !== undefined && { file }) };
}

function queryOfDocument(document: MissionDocument, shown: number): MissionQuery | null {
  const { agents, rules = {}, method = {}, page = {} } = document;
  if (!agents.some((agent) => agent.kind === "ground")) return null;
  const cell = typeof page.cell_size === "number" ? page.cell_size : shown;
  const pace = { inSeconds: document.time_unit === "s", speeds: agents.map((agent) => agent.speed) };
  const scale = { cell, seconds: secondsPerUnit(pace, cell) };
  const asked = agentsOf(agents, scale);
  const isSized = agents.every((agent) => agent.kind === "air" || agent.radius !== undefined);
  const removals = Number(rules.removals ?? usualRemovals);
  const unreached = typeof rules.unreached === "number" ? rules.unreached : null;
  const how: Method = method.select === "hits" && hasPaperMethod({ agents: asked, unreached }) ? "paper" : "exact";
  const corners = cornersOf(agents);
  const query = new URLSearchParams({
    ...Object.fromEntries(agentsInQuery(asked, isSized ? null : usualVehicle.radius)),
    removals: String(Math.min(removals, mostRemovals)),
    method: how,
  });
  const also = alsoOf({ ...rules, ...method, ...(corners && { corners }) }, how, removals);
  if (Object.keys(also).length > 0) query.set("also", alsoText(also));
  for (const name of inRules) {
    if (rules[name] !== undefined) query.set(name, String(rules[name]));
  }
  for (const name of timesInRules) {
    if (rules[name] !== undefined) query.set(name, String(scaled(Number(rules[name]), scale.seconds)));
  }
  for (const [name, said] of Object.entries(page)) if (name !== "cell_size") query.set(name, String(said));
  for (const mark of ["protect", "force"]) {
    const ids = [idsIn(rules[mark]), page[mark]].flat().filter((one) => one !== undefined);
    if (ids.length > 0) query.set(mark, ids.join());
  }
  const zones = zonesOf(rules.zones);
  const inSeconds = (time: number) => scaled(time, scale.seconds);
  if (zones && zones.length > 0) query.set("zones", zonesText(withTimes(zones, inSeconds)));
  const all = textsIn(rules.protect);
  if (all.length > 0) query.set("protect_all", inOne(all));
  return { query: query.toString(), leftOut: leftOut(document) };
}

function idsIn(obstacles: unknown): number[] {
  return Array.isArray(obstacles) ? obstacles.filter((one) => typeof one === "number") : [];
}

function objectsIn(list: unknown): Record<string, unknown>[] {
  return Array.isArray(list) ? list.filter(isObject) : [];
}

function textsIn(obstacles: unknown): string[] {
  return Array.isArray(obstacles) ? obstacles.filter((one) => typeof one === "string") : [];
}

const usualRemovals = 3; // of the command

// What links and rules call alike.
const inRules = ["objective", "separation", "at_goal", "collisions"];
const timesInRules = ["breach_time", "breach_time_per_cell", "rubble", "unreached"];

// Those of all vehicles; null where they differ.
function cornersOf(agents: readonly Partial<AgentDocument>[]): string | null {
  const all = new Set(agents.filter((agent) => agent.kind !== "air").map(({ corners = "none" }) => corners));
  return all.size === 1 ? [...all][0]! : null;
}

const known = {
  rules: ["removals", "protect", "force", ...inRules, ...timesInRules, "zones", ...alsoNames.rules],
  method: ["bound", "explain", ...alsoNames.method],
};

const batteryNames = ["range", "endurance", "reserve", "recharge", "bases"] as const;

// What the page has no words for, or the command refuses.
export function leftOut(
  { agents, overlays, rules = {}, method = {} }: Pick<MissionDocument, "agents" | "overlays" | "rules" | "method">,
): string[] {
  const of = (object: Record<string, unknown>, names: string[]) => Object.keys(object).filter((name) => !names.includes(name));
  const says = (name: keyof AgentDocument, kind: AgentDocument["kind"]) =>
    agents.some((agent) => agent[name] !== undefined && agent.kind === kind);
  const aircraft = agents.filter(({ kind }) => kind === "air");
  const isVain = ({ range, endurance, recharge }: AgentDocument) => recharge !== undefined && (range ?? endurance) === undefined;
  const hasNoUse = ({ recharge, bases }: AgentDocument) => bases !== undefined && recharge === undefined;
  const isUnread = ({ can_breach: can }: AgentDocument) => can !== undefined && !isChoice(can);
  const removals = Number(rules.removals ?? usualRemovals);
  return [
    ...objectsIn(overlays).map(({ file, as }) => `the overlay ${file}: drop that file on the page, and lay it over the map as ${as}`),
    ...of(rules, known.rules),
    ...(rules.zones !== undefined && zonesOf(rules.zones) === null ? ["zones, which are not in cells"] : []),
    ...of(method, known.method),
    ...(cornersOf(agents) === null ? ["corners, which differ between its vehicles"] : []),
    ...(says("ready_at", "air") ? ["ready_at of aircraft"] : []),
    ...(says("approach", "air") || says("approach", "ground") ? ["approach"] : []),
    ...(says("flown", "air") ? ["flown"] : []),
    ...batteryNames.filter((name) => says(name, "ground")).map((name) => `${name} of vehicles`),
    ...(aircraft.some(isVain) ? ["recharge of aircraft without range and endurance"] : []),
    ...(aircraft.some(hasNoUse) ? ["bases of aircraft without recharge"] : []),
    ...(says("reach", "air") ? ["reach of aircraft"] : []),
    ...(agents.some(isUnread) ? ["can_breach that is more than most_cells and only"] : []),
    ...(removals > mostRemovals ? [`${removals} removals: ${mostRemovals} are the most here`] : []),
  ];
}

// As the page once wrote them: what a link says, a line each.
function queryOfFormerFile(value: Record<string, unknown>): MissionQuery | null {
  const said = Object.entries(value).filter(
    ([name, one]) => name !== "format" && ["string", "number"].includes(typeof one),
  );
  const query = new URLSearchParams(said.map(([name, one]) => [name, String(one)])).toString();
  return holdsMission(query) ? { query, leftOut: [] } : null;
}
