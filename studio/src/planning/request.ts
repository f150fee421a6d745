// A mission as a request to the service.
import type { PlanRequest } from "../api/documents";
import { agentDocuments } from "../domain/agent_document";
import { type Agents, canOpen, drivesAlone, hasPaperMethod, limitsFlights } from "../domain/agents";
import { alsoNames } from "../domain/also";
import { marked, meetingRules, type Method, type Mission, shownPer } from "../domain/mission";
import type { Plan, RequestOptions } from "../domain/plan";
import { filterText, type TagFilter } from "../domain/tag_filter";
import type { Units } from "../domain/units";
import { zoneCollection } from "../domain/zone";

// What a plan is asked for with. Obstacles are those of the map that is planned on.
export interface Question {
  of: Mission;
  map: string;
  mission: PlanRequest["mission"];
  options: RequestOptions; // but for method and removals
  method: Method;
  removals: number | "auto";
  price: number; // what a removal has to save where their number is left open
  withBefore: boolean; // whether the way without removals is on the map, and has to follow at once
}

// `drawn` are the obstacles that have to stay unless something is said about them, `rules` which others do; `agents` are those of
// the mission, in terms of the map that is planned on.
export function questionOf(
  mission: Mission,
  units: Units,
  map: string,
  toShown: (key: number) => number,
  drawn: Iterable<number> = [],
  rules: readonly TagFilter[] = mission.protectAll,
  agents: Agents = mission.agents,
): Question {
  const said = new Set([...mission.marks.keys()].map(toShown));
  const usual = { protect: [...drawn].filter((id) => !said.has(id)), force: [] };
  const ids = (mark: "protect" | "force") =>
    [...new Set([...marked(mission, mark).map(toShown), ...usual[mark]])].filter((id) => id !== 0).sort((a, b) => a - b);
  const options: RequestOptions = {
    ...mission.also,
    objective: mission.objective,
    breach_time: mission.breachTime,
    breach_time_per_cell: mission.breachTimePerCell,
    ...(mission.rubble !== 0 && { rubble: mission.rubble }),
  };
  const [protect, force] = [[...ids("protect"), ...rules.map(filterText)], ids("force")];
  if (protect.length > 0) options.protect = protect;
  if (force.length > 0) options.force = force;
  return {
    of: mission,
    map,
    mission: documentOf({ ...mission, agents }, units),
    options,
    method: hasPaperMethod(mission) ? mission.method : "exact",
    removals: canOpen(mission.agents) || mission.removals !== "auto" ? mission.removals : 0,
    price: mission.price * shownPer(mission),
    withBefore: mission.layers.includes("before"),
  };
}

function documentOf(mission: Mission, units: Units): PlanRequest["mission"] {
  const { agents, zones } = mission;
  const rules = { ...meetingRules(mission), ...(zones.length > 0 && { zones: zoneCollection(zones) }) };
  const unit = units.metric ? { time_unit: "s" as const } : {};
  return { format: "waybreaker-mission/1", ...unit, agents: agentDocuments(agents, units.cell), rules };
}

export function canRemove({ of }: Question): boolean {
  return canOpen(of.agents);
}

// A draft, where plans take too long to follow the mouse: any-angle search that hurries to the goal, and of the obstacles in its way
// those it met most. On a city of 4096² cells that is a hundredth of the work, and its paths are a percent longer.
const hurried: RequestOptions = { planner: "theta", weight: 1.5 };
// Where vehicles keep clear of each other: the best that is found in so many seconds.
const teamDraft: RequestOptions = { select: "exact", time_limit: 0.15 };

// What is asked beside what the page knows need not go with a draft's own method.
export function hasDraft({ of }: Question): boolean {
  return Object.keys(of.also).length === 0;
}

function request(question: Question, method: Method | "draft", options: RequestOptions): PlanRequest {
  const byHits: RequestOptions = question.method === "paper" ? { paper: true } : { select: "hits" };
  const how: Record<typeof method, RequestOptions> = {
    exact: { select: "exact" },
    paper: { paper: true },
    draft: drivesAlone(question.of) ? { ...byHits, ...hurried } : teamDraft,
  };
  return { mission: question.mission, options: { ...how[method], ...question.options, ...options } };
}

// Seconds. The first plan has to come soon; then the search goes on, for longer and at last for as long as the service gives it.
const quick = 2;
const patient = 10;

// The limits of the searches that follow the first; null: the service's own.
export function furtherLimits({ removals }: Question): readonly (number | null)[] {
  return removals === "auto" ? [null] : [patient, null]; // steps of the curve were patient
}

// Whether more time might have brought a better plan.
export function isCut(plan: Plan, limit: number | null): boolean {
  return plan.limit_reached === true || (limit !== null && (plan.seconds?.total ?? 0) >= limit);
}

// Whether the first answer to a question was.
export function isHasty(plan: Plan, question: Question): boolean {
  return isCut(plan, question.removals === "auto" ? stepLimit(question) : quick);
}

function limited(seconds: number | null): RequestOptions {
  return seconds === null ? {} : { time_limit: seconds };
}

export function planRequest(question: Question, removals: number, limit: number | null = quick): PlanRequest {
  return request(question, question.method, { removals, ...limited(limit) });
}

export function draftRequest(question: Question, removals: number): PlanRequest {
  return request(question, "draft", { removals });
}

// What a draft says is not proven: to be within 100 % of the best does.
const unproven: RequestOptions = { gap: 1 };

// The plan that keeps what another removes: a fraction of the work, for there is nothing to choose, and nothing to prove.
export function keptRequest(question: Question, removed: readonly number[]): PlanRequest {
  return request(question, "exact", { removals: removed.length, force: [...removed], time_limit: quick, ...unproven });
}

// The way without removals that goes with it.
export function keptBeforeRequest(question: Question): PlanRequest {
  const { mission, options } = beforeRequest(question);
  return { mission, options: { ...options, ...unproven } };
}

// Whether that does for a draft. What an aircraft can fly to depends on where it starts.
export function canKeep({ method, of }: Question): boolean {
  return method === "exact" && drivesAlone(of) && !limitsFlights(of.agents);
}

export function draftBeforeRequest(question: Question): PlanRequest {
  const { protect, force, ...options } = question.options;
  return request({ ...question, options }, "draft", { removals: 0 });
}

// Whether there is anything to explain: what is removed, or what is not because it is too far.
export function hasReasons({ of, removals }: Question, plan: Plan): boolean {
  return plan.removed.length > 0 || (limitsFlights(of.agents) && removals !== "auto" && removals > 0);
}

// With what the mission would lose without each removal, and what no aircraft can fly to.
export function explainRequest(question: Question, removals: number): PlanRequest {
  return request(question, question.method, { removals, explain: true });
}

// A step of the curve: there are many, and the next waits.
export function stepRequest(question: Question, removals: number): PlanRequest {
  return planRequest(question, removals, stepLimit(question));
}

function stepLimit(question: Question): number {
  return drivesAlone(question.of) ? patient : quick;
}

// The way with nothing removed; what has to go or stay is no matter then.
export function beforeRequest(question: Question, limit: number | null = quick): PlanRequest {
  const { protect, force, ...options } = question.options;
  return { mission: question.mission, options: { select: "exact", ...options, removals: 0, ...limited(limit) } };
}

// Of what is asked besides only limits are for the paper's method as well.
export function paperRequest(question: Question, removals: number): PlanRequest {
  const left = ["timing", "minimise_demolition", ...alsoNames.method];
  const options = Object.fromEntries(Object.entries(question.options).filter(([name]) => !left.includes(name)));
  return request({ ...question, options }, "paper", { removals });
}

// Which questions have the same answer.
export const keyOf = {
  plan: (q: Question) => JSON.stringify([q.map, q.mission, q.options, q.method, q.removals, q.removals === "auto" && q.price]),
  // But for where agents start and end.
  places: ({ mission, ...q }: Question) => {
    const agents = mission.agents.map(({ start, goal, ...agent }) => agent);
    return JSON.stringify([q.map, { ...mission, agents }, q.options, q.method, q.removals]);
  },
  front: (q: Question) => JSON.stringify([q.map, q.mission, q.options, q.method]),
  before: (q: Question) => JSON.stringify([q.map, beforeRequest(q)]),
};
