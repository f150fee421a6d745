// What can go wrong at the moment that playback stands at: the choices of the menu on the map, and of the panel.
import type { Cell, Point } from "../domain/geometry";
import type { Agent, Plan, Removed } from "../domain/plan";
import { rubbleAt, rubbleRadius } from "../domain/rubble";
import type { Pointed } from "../domain/scene";
import { clockTime, duration as durationText } from "../domain/units";
import type { Studio } from "../mission/studio";
import { arrival, breachOrder, duration, positionAt } from "../play/motion";
import { nameOf as agentName } from "../play/story";
import { cellAhead, usualDelays } from "../rehearse/choices";
import { failureOf } from "../rehearse/news";
import { nameOf } from "./obstacle_words";

export interface Mishap {
  label: string; // on a button beside what it happens to
  told: string; // by itself
  act: () => void;
}

export function failure(studio: Studio, obstacle: number): Mishap | null {
  const { page, rehearsal } = studio;
  const plan = page.played.value;
  const news = plan && failureOf(plan, obstacle, rehearsal.time);
  if (!news || !rehearsal.held.value) return null;
  const told = `The breach of ${nameOf(page.shown.value!, obstacle).text} fails, at ${clockTime(news.at, page.units.value)}`;
  return { label: "Breach fails", told, act: () => void rehearsal.happens(news) };
}

export function delays(studio: Studio, agent: Agent): Mishap[] {
  const { page, rehearsal } = studio;
  const at = rehearsal.time;
  if (agent.kind !== "ground" || !isUnderWay(studio, agent)) return [];
  const units = page.units.value;
  return usualDelays(duration(page.played.value!), units.seconds).map((by) => ({
    label: `${durationText(by, units)} late`,
    told: `${capital(agentName(agent))} stands still for ${durationText(by, units)}`,
    act: () => void rehearsal.happens({ kind: "delayed", agent: agent.id, by, at }),
  }));
}

export function loss(studio: Studio, agent: Agent): Mishap | null {
  if (agent.kind !== "air" || !isUnderWay(studio, agent)) return null;
  const { rehearsal } = studio;
  const act = () => void rehearsal.happens({ kind: "lost", agent: agent.id, at: rehearsal.time });
  return { label: "Lost", told: `${capital(agentName(agent))} is lost`, act };
}

// Rubble on the way of a vehicle, as near ahead as it can fall.
export function rubbleAhead(studio: Studio, agent: Agent): Mishap | null {
  const { rehearsal } = studio;
  if (agent.kind !== "ground" || !isUnderWay(studio, agent)) return null;
  const cell = cellAhead(agent, rehearsal.time, leastAhead(studio, agent));
  return cell && { label: "Rubble ahead", told: `Rubble falls ahead of ${agentName(agent)}`, act: () => dropRubble(studio, cell, true) };
}

const mostAtOnce = 3; // agents in a menu

// What can happen to what is there.
export function mishapsAt(studio: Studio, { cell, obstacle, agents: ids }: Pointed): Mishap[] {
  const { page, rehearsal } = studio;
  if (!rehearsal.available.value || !rehearsal.held.value || page.clock.time.value === null) {
    return rehearsal.available.value && obstacle !== null ? [failure(studio, obstacle)].filter((one) => one !== null) : [];
  }
  const agents = page.played.value?.agents.filter(({ id }) => ids.includes(id)).slice(0, mostAtOnce) ?? [];
  const ofAgents = agents.flatMap((agent) => [...delays(studio, agent), loss(studio, agent)]);
  const found = [obstacle === null ? null : failure(studio, obstacle), ...ofAgents];
  const free = page.shown.value?.map.cells.at(...cell) === 0;
  const rubble = { label: "Rubble", told: "Rubble falls here", act: () => dropRubble(studio, cell, true) };
  return [...found.filter((one) => one !== null), ...(free && agents.length === 0 ? [rubble] : [])];
}

// Not `done` while it is held over the map.
export function dropRubble(studio: Studio, at: Cell | null, done: boolean): void {
  const { page, rehearsal } = studio;
  if (!at) return rehearsal.abandon();
  const plan = page.played.value;
  const [cells, time] = [page.shown.value?.map.cells, rehearsal.time];
  if (!plan || !cells) return;
  const clear = plan.agents.flatMap((agent) => {
    const now = agent.kind === "ground" ? positionAt(agent, time) : null;
    return now ? [{ at: [now.x, now.y] as Point, radius: radiusOf(studio, agent.id) }] : [];
  });
  const runs = rubbleAt(at, cells, clear);
  if (runs.length > 0) void rehearsal.happens({ kind: "rubble", runs, at: time }, done);
  else rehearsal.abandon();
}

export function radiusOf({ page }: Studio, id: string): number {
  const agent = page.mission.value?.agents.find((one) => one.id === id);
  return agent?.kind === "ground" ? agent.radius : 0;
}

// Openings that are still to come, in the order of their numbers.
export function openingsToCome(plan: Plan, time: number): { removed: Removed; number: number }[] {
  return breachOrder(plan)
    .map((removed, i) => ({ removed, number: i + 1 }))
    .filter(({ removed }) => removed.cleared_at >= time);
}

function isUnderWay({ rehearsal }: Studio, agent: Agent): boolean {
  return rehearsal.held.value !== null && !agent.lost && arrival(agent) > rehearsal.time;
}

// So far that the vehicle and what is committed of its way are clear of it.
function leastAhead(studio: Studio, { id }: Agent): number {
  return 2 * rubbleRadius(studio.page.shown.value!.map.cells) + 2 * radiusOf(studio, id) + 4;
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
