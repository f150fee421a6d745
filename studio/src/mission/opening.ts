// Opens what a person gives: files that are dropped or chosen, links.
import { cellsAt } from "../domain/map";
import type { Plan } from "../domain/plan";
import { isInCells, zonesOf } from "../domain/zone";
import { type Given, NotUnderstood, understood } from "./given";
import type { KeptFile } from "./kept_file";
import { encodeLink, mapOfLink } from "./link";
import { isUpload } from "./maps";
import { queryOfFile } from "./mission_file";
import { leftOutOfPlan, mapsOfPlan, missionOfPlan } from "./plan_mission";
import type { Studio } from "./studio";

export function openFiles(studio: Studio, files: readonly File[]): Promise<void> {
  return take(studio, files, async (given) => {
    if (given.kind === "map") await studio.maps.upload(given.file);
    else if (!studio.client.imports && (given.kind === "map data" || given.kind === "shapes")) throw needsService(given.file);
    else if (given.kind === "map data") await studio.importer.begin(given.file);
    else if (given.kind === "shapes") await openShapes(studio, given.file);
    else if (given.kind === "zones") openZones(studio, given);
    else if (given.kind === "plan") await openPlan(studio, given.plan);
    else if (given.kind === "mission") await openMission(studio, given.query);
    else await openMissionFile(studio, given.value);
  });
}

function needsService({ name }: KeptFile): NotUnderstood {
  return new NotUnderstood(`“${name}” is map data, which “waybreaker serve” takes: this page has no server.`);
}

// What the day brings to the map shown, if that lies somewhere; else the map data of a city.
async function openShapes(studio: Studio, file: KeptFile): Promise<void> {
  const map = studio.page.shown.value?.base.description;
  if (map?.georeference) studio.overlays.begin(file, map.id);
  else await studio.importer.begin(file);
}

// Zones are added to those that are there; one step back takes them away again.
function openZones(studio: Studio, { name, value }: { name: string; value: unknown }): void {
  const place = studio.page.shown.value?.base.description.georeference;
  if (!place && !isInCells(value)) {
    throw new NotUnderstood(`The zones in “${name}” are in longitude and latitude, and the map does not say where it lies.`);
  }
  const zones = zonesOf(value, place && cellsAt(place.to_lon_lat));
  if (!zones) throw new NotUnderstood(`“${name}” is no collection of zones: each needs a polygon, and "no_fly" or "keep_out".`);
  studio.zones.add(zones);
  studio.page.notify("info", zones.length === 1 ? "A zone is added." : `${zones.length} zones are added.`);
}

// Files of a map that the service no longer has.
export function restoreFrom(studio: Studio, files: readonly File[]): Promise<void> {
  return take(studio, files, async (given) => {
    if (given.kind !== "map") throw new NotUnderstood("This file is no map.");
    await studio.maps.restore(given.file);
  });
}

// A mission of a link or a file.
export async function openMission(studio: Studio, query: string): Promise<void> {
  const id = mapOfLink(query) ?? studio.page.mission.value?.map;
  studio.page.notice.value = null;
  if (id !== undefined) await studio.maps.open(id, query);
}

async function openMissionFile(studio: Studio, value: Record<string, unknown>): Promise<void> {
  const said = queryOfFile(value, studio.page.units.value.cell);
  if (!said) throw new NotUnderstood("Nobody drives in this mission: it has no ground agent.");
  await openMission(studio, said.query);
  if (!studio.page.notice.value) say(studio, "", said.leftOut);
}

// The plan that the page carries. Where there was none, it does not say where from and where to.
export async function openCarried(studio: Studio, plan: Plan): Promise<void> {
  if (plan.agents.length > 0) await openPlan(studio, plan);
  else await studio.maps.start("");
}

async function openPlan(studio: Studio, plan: Plan): Promise<void> {
  await studio.maps.refreshList();
  const [there, query] = asked(plan, new Set(studio.maps.list.value.map((entry) => entry.id)));
  if (!(await studio.maps.open(there, query, plan.map.digest)) || studio.page.notice.value) return;
  if (studio.page.shown.value?.base.description.digest === plan.map.digest) {
    say(studio, "The mission of the plan is planned anew.", leftOutOfPlan(plan));
  } else {
    studio.page.notify("bad", `The plan was made on another state of “${there}”; its mission is planned on this one.`);
  }
}

// What is left out of a file stands until it is read: what is planned is not all that was asked.
function say(studio: Studio, first: string, leftOut: readonly string[]): void {
  const left = leftOut.length > 0 ? `Not all of the file is planned. Left out: ${leftOut.join("; ")}.` : "";
  const text = [first, left].filter((part) => part !== "").join(" ");
  if (text) studio.page.notify(left ? "bad" : "info", text);
}

// The map and the mission of a plan.
function asked(plan: Plan, there: ReadonlySet<string>): [map: string, query: string] {
  const ids = mapsOfPlan(plan);
  const map = ids.find((id) => there.has(id)) ?? ids[1]!;
  const mission = missionOfPlan(plan, map);
  if (!mission) throw new NotUnderstood("There is no plan in this file, and so no start and no goal.");
  const file = isUpload(plan.map.source) ? "" : `&file=${encodeURIComponent(plan.map.source)}`;
  return [map, encodeLink(mission, plan.map.width, null) + file];
}

async function take(studio: Studio, files: readonly File[], act: (given: Given) => Promise<void>): Promise<void> {
  studio.page.notice.value = null;
  try {
    await act(await understood(files));
  } catch (error) {
    const isSaid = error instanceof NotUnderstood;
    studio.page.notify("bad", isSaid ? error.message : "The page fails on this file: please report it.");
    if (!isSaid) throw error;
  }
}
