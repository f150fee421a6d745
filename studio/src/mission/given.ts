// What a person drops on the page, opens or pastes: a map, map data, a plan, a mission, a link to one.
import type { Plan } from "../domain/plan";
import { missionAt } from "./address";
import { keep, type KeptFile } from "./kept_file";
import { isMissionFile } from "./mission_file";
import { isPlan } from "./plan_mission";

export type Given =
  | { kind: "map"; file: KeptFile }
  | { kind: "map data"; file: KeptFile } // to import a map from
  | { kind: "shapes"; file: KeptFile } // GeoJSON without buildings: to import, or to lay over a map
  | { kind: "zones"; name: string; value: unknown } // GeoJSON whose features say what kind of zone they are
  | { kind: "mission"; query: string }
  | { kind: "mission file"; value: Record<string, unknown> }
  | { kind: "plan"; plan: Plan };

// Its message is a sentence for people.
export class NotUnderstood extends Error {}

const mostText = 16_000_000; // bytes that may be a plan, a mission or a link

export async function understood(files: readonly File[]): Promise<Given> {
  let kept: KeptFile[];
  try {
    kept = await Promise.all(files.map(keep));
  } catch {
    throw new NotUnderstood("The file cannot be read. If it is a folder, choose the files in it.");
  }
  const yaml = kept.find((file) => isYaml(file.name));
  const other = kept.find((file) => file !== yaml);
  if (yaml) return { kind: "map", file: await rosMap(yaml, kept.length <= 2 ? other : undefined) };
  if (kept.length !== 1) {
    throw new NotUnderstood("One at a time: choose one file, or the YAML and the image of one ROS map.");
  }
  await refuseOtherMapData(kept[0]!);
  if (await areZones(kept[0]!)) return { kind: "zones", name: kept[0]!.name, value: inJson(await kept[0]!.bytes.text(), kept[0]!.name) };
  if (await isMapData(kept[0]!)) return { kind: (await areShapes(kept[0]!)) ? "shapes" : "map data", file: kept[0]! };
  return (await inText(kept[0]!)) ?? { kind: "map", file: kept[0]! };
}

// OpenStreetMap's formats, packed or not, and GeoJSON: by their first bytes, and by name.
async function isMapData({ name, bytes }: KeptFile): Promise<boolean> {
  const head = new Uint8Array(await bytes.slice(0, 2000).arrayBuffer());
  if (head[0] === 0x1f && head[1] === 0x8b) return true; // no map is packed with gzip
  const text = new TextDecoder().decode(head);
  if (text.includes("OSMHeader") || /<osm[\s>]/.test(text)) return true;
  if (!/^\s*\{/.test(text) || (bytes.size <= mostText && isOurs(await bytes.text()))) return false;
  return /\.geojson$/i.test(name) || /"type"\s*:\s*"Feature(Collection)?"/.test(text);
}

// Missions and plans have zones as GeoJSON.
function isOurs(text: string): boolean {
  return /"format"\s*:\s*"waybreaker-/.test(text);
}

// Of map data whether it is GeoJSON that knows no buildings.
async function areShapes({ bytes }: KeptFile): Promise<boolean> {
  if (bytes.size > mostText) return false;
  const text = await bytes.text();
  return text.trimStart().startsWith("{") && !/"building"\s*:/.test(text);
}

async function areZones({ bytes }: KeptFile): Promise<boolean> {
  if (bytes.size > mostText) return false;
  const text = await bytes.text();
  return text.trimStart().startsWith("{") && !isOurs(text) && /"zone"\s*:\s*"(no_fly|keep_out)"/.test(text);
}

// What the command imports, and the service does not take: they are several files, or name others.
async function refuseOtherMapData({ name, bytes }: KeptFile): Promise<void> {
  const head = new Uint8Array(await bytes.slice(0, 16).arrayBuffer());
  const isShape = head[0] === 0 && head[1] === 0 && head[2] === 0x27 && head[3] === 0x0a; // as its index begins, too
  if (isShape || /\.(shp|shx|dbf)$/i.test(name)) {
    throw new NotUnderstood(
      `“${name}” is one of the files of a shapefile, which only all together say what it holds. Make a map of them with “waybreaker import”, or one file to drop here with “ogr2ogr town.geojson ${name.replace(/\.\w+$/, ".shp")} -t_srs EPSG:4326”.`,
    );
  }
  if (new TextDecoder().decode(head).startsWith("SQLite format 3")) {
    throw new NotUnderstood(`“${name}” is a database, such as a GeoPackage. Make a map of it with “waybreaker import”.`);
  }
}

// The mission of a link that is dropped or pasted; null where the text is none.
export async function missionInText(text: string): Promise<string | null> {
  const link = /\bhttps?:\/\/[^\s"<>]+/.exec(text)?.[0];
  if (!link) return null;
  try {
    return (await missionAt(new URL(link))) || null;
  } catch {
    return null;
  }
}

async function inText({ name, bytes }: KeptFile): Promise<Given | null> {
  if (bytes.size > mostText) return null;
  const text = await bytes.text();
  if (text.trimStart().startsWith("{")) return missionOrPlan(inJson(text, name), name);
  const query = text.length < 500_000 ? await missionInText(text) : null;
  return /^\s*(https?:|\[InternetShortcut\])/.test(text) && query ? { kind: "mission", query } : null;
}

function inJson(text: string, name: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new NotUnderstood(`“${name}” is no complete JSON.`);
  }
}

function missionOrPlan(value: unknown, name: string): Given {
  if (isPlan(value)) return { kind: "plan", plan: value };
  if (isMissionFile(value)) return { kind: "mission file", value };
  throw new NotUnderstood(`“${name}” is neither a plan nor a mission of waybreaker.`);
}

// Both files of a ROS map in one, as the service takes them.
async function rosMap(yaml: KeptFile, image: KeptFile | undefined): Promise<KeptFile> {
  const text = await yaml.bytes.text();
  if (!image) {
    const named = imageOf(text);
    throw new NotUnderstood(`“${yaml.name}” belongs to ${named ? `“${named}”` : "an image"}: choose both together.`);
  }
  return { name: yaml.name, bytes: new Blob([yaml.bytes, "\n...\n", image.bytes]) };
}

// The image that the YAML of a ROS map names, where it is written as usual: on a line of its own, or in one pair of braces.
function imageOf(yaml: string): string | null {
  const value = /(?:^|[{,])[ \t]*(?:image|"image"|'image')[ \t]*:[ \t]*(?:"([^"\n]+)"|'([^'\n]+)'|([^\s"'#][^\n]*))/m.exec(yaml);
  if (!value) return null;
  const [, double, single, plain] = value;
  const end = yaml.trimStart().startsWith("{") ? /\s*([,}]|\s#)[^]*$|\s+$/ : /\s+#[^]*$|\s+$/;
  return double ?? single ?? plain!.replace(end, "");
}

function isYaml(name: string): boolean {
  return /\.ya?ml$/i.test(name);
}
