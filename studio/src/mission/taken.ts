// What a person takes along: the plan, the map and the mission as files, the mission as a link.
import type { ExportFormat } from "../api/client";
import type { Plan } from "../domain/plan";
import { keyOf } from "../planning/request";
import type { Results } from "../planning/results";
import { fragmentOf, longestLink } from "./address";
import { saveAs } from "./save_as";
import type { Studio } from "./studio";

export async function downloadPlan(studio: Studio, format: ExportFormat): Promise<void> {
  const plan = studio.held.value;
  const map = studio.page.shown.value?.map.description;
  if (!plan || !map) return;
  const given = format === "html" ? withCurve(plan, studio.page.results) : plan;
  await save(studio, async () => ({
    bytes: await studio.client.exported(map.id, given, format),
    name: `${nameOf(plan)}.${format}`,
  }));
}

function nameOf({ revision }: Plan): string {
  return revision ? `revision-${revision.number}` : "plan";
}

// A page shows what each number of removals reaches, if that is known.
function withCurve(plan: Plan, { front, answered }: Results): Plan {
  const question = answered.value;
  const isOfPlan = !plan.revision && front.value?.isDone && question && front.value.key === keyOf.front(question);
  return isOfPlan ? { ...plan, front: [...front.value!.points] } : plan;
}

export async function downloadMap(studio: Studio): Promise<void> {
  const map = studio.page.shown.value?.map.description;
  if (map) await save(studio, () => studio.client.file(map.id));
}

export function downloadMission(studio: Studio): void {
  const text = studio.missionFile();
  if (text !== null) saveAs(new Blob([text], { type: "application/json" }), "mission.json");
}

export async function copyLink(studio: Studio): Promise<void> {
  const address = new URL(location.pathname, location.href).href + (await fragmentOf(studio.query()));
  if (address.length > longestLink) {
    const file = { label: "Save the mission as a file", act: () => downloadMission(studio) };
    const anyway = { label: "Copy it all the same", act: () => void copy(studio, address) };
    const letters = `${Math.round(address.length / 1000)} 000 letters`;
    return studio.page.notify("info", `The link has ${letters}, more than many programs take.`, [file, anyway]);
  }
  await copy(studio, address);
}

async function copy(studio: Studio, address: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(address);
    studio.page.notify("info", "The link to this mission is in the clipboard.");
  } catch {
    studio.page.notify("info", `The link to this mission: ${address}`);
  }
}

async function save(studio: Studio, fetched: () => Promise<{ bytes: Blob; name: string }>): Promise<void> {
  try {
    const { bytes, name } = await fetched();
    saveAs(bytes, name);
  } catch (error) {
    studio.failed(error, () => undefined);
  }
}
