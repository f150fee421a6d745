// Mission files: waybreaker-mission/1 (docs/contract.md), as the command and the service read them. What only the page
// knows, such as drawn walls, stands in `page`, which they pass by.
import { marked, type Method, type Mission, mostRemovals } from "../domain/mission";
import { holdsMission } from "./address";
import { encodeLink } from "./link";

const format = "waybreaker-mission/1";

interface FileAgent {
  id: string;
  kind: "ground" | "air";
  start: [number, number];
  goal: [number, number];
  speed?: number; // cells per unit of time
  radius?: number;
}

interface MissionDocument {
  format: typeof format;
  time_unit?: "s"; // on maps with metres
  agents: FileAgent[];
  rules?: Record<string, unknown>;
  method?: Record<string, unknown>;
  limits?: unknown;
  page?: Record<string, unknown>;
}

// What a mission file says, as the query of a link.
export interface MissionQuery {
  query: string;
  leftOut: string[]; // members that the page has no words for
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
  const { markers, method } = mission;
  const count = mission.removals === "auto" ? removals : mission.removals;
  const { timing, ...how } = methodOf(method, count);
  const obstacles = (mark: "protect" | "force") => marked(mission, mark).filter((key) => key > 0).sort((a, b) => a - b);
  const document: MissionDocument = {
    format,
    ...(map.metric && { time_unit: "s" as const }),
    agents: [
      { id: "ground", kind: "ground", start: markers.start, goal: markers.goal, speed: mission.groundSpeed / map.cell, radius: mission.radius },
      {
        id: "air",
        kind: "air",
        start: markers.air_start ?? markers.start,
        goal: markers.air_goal ?? markers.goal,
        speed: mission.airSpeed / map.cell,
      },
    ],
    rules: {
      removals: count,
      protect: obstacles("protect"),
      force: obstacles("force"),
      breach_time: mission.breachTime,
      breach_time_per_cell: mission.breachTimePerCell,
      timing,
      objective: mission.objective,
    },
    method: how,
    page: pageOf(mission, map),
  };
  return `${JSON.stringify(document, null, 2)}\n`;
}

export function isMissionFile(value: unknown): value is Record<string, unknown> {
  return isObject(value) && value.format === format;
}

// Null where it is not about one ground agent and one air agent. `cell` is that of the map on the page.
export function queryOfFile(value: Record<string, unknown>, cell: number): MissionQuery | null {
  return Array.isArray(value.agents) ? queryOfDocument(value as unknown as MissionDocument, cell) : queryOfFormerFile(value);
}

export function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function methodOf(method: Method, removals: number) {
  // As the paper has it: see `waybreaker plan --paper`.
  return method === "exact"
    ? { timing: "enforce", select: "exact" }
    : { timing: "ignore", select: "hits", planner: "theta", flight: removals === 1 ? "optimal" : "nearest" };
}

// Of the mission's link what the file has no other place for.
function pageOf(mission: Mission, { width, cell, file }: MapOfMission): Record<string, string | number> {
  const walls = new Map([...mission.marks].filter(([key, mark]) => key < 0 || mark === "exclude" || mark === "allow"));
  const link = new URLSearchParams(encodeLink({ ...mission, marks: walls }, width));
  const elsewhere = ["start", "goal", "air_start", "air_goal", "ground_speed", "air_speed", "method", "objective", "radius"];
  for (const name of [...elsewhere, "breach_time", "breach_time_per_cell"]) link.delete(name);
  if (mission.removals !== "auto") link.delete("removals");
  return { ...Object.fromEntries(link), cell_size: cell, ...(file !== undefined && { file }) };
}

function queryOfDocument(document: MissionDocument, shown: number): MissionQuery | null {
  const { agents, rules = {}, method = {}, page = {} } = document;
  const [ground, air] = [agents.find((agent) => agent.kind === "ground"), agents.find((agent) => agent.kind === "air")];
  if (agents.length !== 2 || !ground || !air) return null;
  const cell = typeof page.cell_size === "number" ? page.cell_size : shown;
  const query = new URLSearchParams({
    start: ground.start.join(),
    goal: ground.goal.join(),
    ground_speed: speedOf(ground, cell),
    air_speed: speedOf(air, cell),
    removals: String(Math.min(Number(rules.removals ?? 3), mostRemovals)),
    method: method.select === "hits" ? "paper" : "exact",
  });
  if (ground.radius !== undefined) query.set("radius", String(ground.radius));
  for (const place of ["start", "goal"] as const) {
    if (air[place].join() !== ground[place].join()) query.set(`air_${place}`, air[place].join());
  }
  for (const name of ["objective", "breach_time", "breach_time_per_cell"]) {
    if (rules[name] !== undefined) query.set(name, String(rules[name]));
  }
  for (const [name, said] of Object.entries(page)) if (name !== "cell_size") query.set(name, String(said));
  for (const mark of ["protect", "force"]) {
    const ids = [idsIn(rules[mark]), page[mark]].flat().filter((one) => one !== undefined);
    if (ids.length > 0) query.set(mark, ids.join());
  }
  return { query: query.toString(), leftOut: leftOut(document, ground) };
}

// As it was said: dividing by the size of a cell and multiplying again leaves something in the last digits.
function speedOf({ speed = 1 }: FileAgent, cell: number): string {
  return String(Number((speed * cell).toPrecision(15)));
}

function idsIn(obstacles: unknown): number[] {
  return Array.isArray(obstacles) ? obstacles.filter((one) => typeof one === "number") : [];
}

const known = {
  rules: ["removals", "protect", "force", "breach_time", "breach_time_per_cell", "timing", "objective"],
  method: ["select", "planner", "flight", "weight", "tie_break", "moves", "bound", "explain"],
};

function leftOut({ rules = {}, method = {} }: MissionDocument, ground: FileAgent): string[] {
  const of = (object: Record<string, unknown>, names: string[]) => Object.keys(object).filter((name) => !names.includes(name));
  const corners = (ground as { corners?: string }).corners ?? "none";
  const tags = [rules.protect].flat().some((one) => typeof one === "string") ? ["protection by tag"] : [];
  return [...of(rules, known.rules), ...of(method, known.method), ...(corners === "none" ? [] : ["corners"]), ...tags];
}

// As the page once wrote them: what a link says, a line each.
function queryOfFormerFile(value: Record<string, unknown>): MissionQuery | null {
  const said = Object.entries(value).filter(
    ([name, one]) => name !== "format" && ["string", "number"].includes(typeof one),
  );
  const query = new URLSearchParams(said.map(([name, one]) => [name, String(one)])).toString();
  return holdsMission(query) ? { query, leftOut: [] } : null;
}
