// What people look for on a map by name: streets, waters, squares, buildings, and what these are used for.
import type { CellMap } from "./cell_map";
import type { Point } from "./geometry";
import type { Background, Feature } from "./map";
import { usesOf, whatItIs } from "./obstacle_words";

export interface Place {
  name: string;
  what: string; // "street", "hospital", "section of a building"
  obstacle: number | null; // to select
  at: Point;
}

interface Entry {
  place: Place;
  text: string; // what is searched
  named: boolean; // or called by what it is used for
  size: number; // of several that are called the same, the largest stands for them
}

const mostFound = 8;

// Without capital letters and accents.
function plain(text: string): string {
  return text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase().replaceAll("ß", "ss");
}

export class PlaceIndex {
  readonly isEmpty: boolean;
  #made: Entry[] | null = null; // once somebody looks for something: on a large city that takes a moment

  constructor(
    private readonly background: Background,
    private readonly cells: CellMap,
  ) {
    this.isEmpty = !background.features.some(({ name }) => name) && obstacleEntries(cells).next().done === true;
  }

  get #entries(): Entry[] {
    return (this.#made ??= entriesOf(this.background, this.cells));
  }

  // The best few: what begins so before what has a word that does, before what has it anywhere.
  find(query: string): Place[] {
    const wanted = plain(query.trim());
    if (wanted === "") return [];
    const rank = ({ text }: Entry): number => {
      const at = text.indexOf(wanted);
      return at <= 0 ? at : /[\p{L}\p{N}]/u.test(text[at - 1]!) ? 2 : 1;
    };
    return this.#entries
      .map((entry) => ({ entry, rank: rank(entry) }))
      .filter((one) => one.rank >= 0)
      .sort((a, b) => a.rank - b.rank || b.entry.size - a.entry.size)
      .slice(0, mostFound)
      .map(({ entry }) => entry.place);
  }
}

function entriesOf(background: Background, cells: CellMap): Entry[] {
  const entries = new Map<string, Entry>();
  const add = (entry: Entry) => {
    const { name, obstacle } = entry.place;
    const key = `${obstacle === null ? "" : entry.named ? "named" : obstacle} ${name}`;
    const known = entries.get(key);
    if (!known || known.size < entry.size) entries.set(key, entry);
  };
  for (const feature of background.features) if (feature.name) add(featureEntry(feature));
  for (const entry of obstacleEntries(cells)) add(entry);
  return [...entries.values()];
}

function featureEntry(feature: Feature): Entry {
  const points = feature.points.flat();
  const longest = feature.points.reduce((a, b) => (b.length > a.length ? b : a));
  const what = feature.kind === "place" ? feature.class.replaceAll("_", " ") : feature.kind;
  const at = feature.shape === "area" ? middleOf(longest) : longest[Math.floor(longest.length / 2)]!;
  return { place: { name: feature.name, what, obstacle: null, at }, text: plain(feature.name), named: true, size: points.length };
}

function middleOf(points: readonly Point[]): Point {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return [(Math.min(...xs) + Math.max(...xs)) / 2, (Math.min(...ys) + Math.max(...ys)) / 2];
}

// A section is found by each building that it has a part of.
function* obstacleEntries(cells: CellMap): Generator<Entry> {
  for (const obstacle of cells.obstacles) {
    const uses = usesOf(obstacle);
    const names = obstacle.structures?.map(({ name }) => name ?? "") ?? [obstacle.name];
    const [left, top, right, bottom] = obstacle.bounds;
    const known = names.filter((one) => one !== "");
    for (const name of known.length > 0 ? known : uses.slice(0, 1).map(capital)) {
      const what = uses.length > 0 && known.length > 0 ? uses.join(", ") : whatItIs(obstacle);
      const place: Place = { name, what, obstacle: obstacle.id, at: [(left + right) / 2, (top + bottom) / 2] };
      yield { place, text: plain([name, ...uses].join(" ")), named: known.length > 0, size: obstacle.cells };
    }
  }
}

function capital(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}
