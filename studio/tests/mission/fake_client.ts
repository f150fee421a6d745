// The service as tests of the page have it: a few maps, and a plan for whatever is asked.
import { type Edits, ServiceError } from "../../src/api/client";
import type { PlanRequest } from "../../src/api/documents";
import type { CellMap } from "../../src/domain/cell_map";
import type { MapDescription, Obstacles } from "../../src/domain/map";
import { mapOf } from "../domain/picture";
import { planOf } from "../domain/plans";

// A service with a few maps. What is drawn is seen on the map `edited`, whose ids are others.
const pictures: Record<string, CellMap> = {
  "city.map": mapOf("....a.....", "....a.bb..", "....a.bb..", ".........."),
  "yard.map": mapOf("....", ".aa.", "...."),
  "town.map": mapOf("....a.....", "....a.bb..", "....a.bb..", ".........."),
  "upload-1": mapOf("....", "a...", "...."),
  walled: mapOf("....a.....", "....a.bb..", "....a.bb..", ".ccc......"),
  edited: mapOf("..........", "......aa..", "......aa..", ".........."),
};
Object.assign(pictures["town.map"]!.obstacles[0]!, { name: "Globe", tags: ["amenity=theatre"] });
Object.assign(pictures["town.map"]!.obstacles[1]!, { name: "Old Globe", tags: ["amenity=pub"] });

function answerOf(cells: CellMap): Obstacles {
  const runs: number[] = [];
  for (let y = 0; y < cells.height; ++y) for (let x = 0; x < cells.width; ++x) runs.push(cells.at(x, y), 1);
  return { width: cells.width, height: cells.height, obstacles: [...cells.obstacles], runs };
}

export class FakeClient {
  readonly planned: { map: string; request: PlanRequest }[] = [];
  readonly edits: Edits[] = [];
  readonly missing = new Set<string>(); // maps that were there
  asks = 0;
  gone = false;
  editable = true;

  maps = async () => {
    this.#answer();
    return ["city.map", "yard.map"].map((id) => ({ id, uploaded: false, loaded: true }));
  };
  map = async (id: string) => {
    this.#answer(id);
    if (!pictures[id]) throw new ServiceError("missing", "There is no such map.");
    const { width, height } = pictures[id];
    const usual = { cell_size: 1, georeference: null, start: null, goal: null };
    return { id, width, height, digest: id, ...usual } as MapDescription;
  };
  obstacles = async (id: string) => answerOf(pictures[id]!);
  background = async () => ({ features: [] });
  edit = async (id: string, edits: Edits) => {
    this.#answer(id);
    if (!this.editable) throw new ServiceError("refused", "No.");
    this.edits.push(edits);
    return this.map(edits.block.length > 0 ? "walled" : "edited");
  };
  upload = async (bytes: Blob) => {
    const id = await bytes.text();
    if (!pictures[id]) throw new ServiceError("refused", "Not a map.");
    this.missing.delete(id);
    return this.map(id);
  };
  plan = async (map: string, request: PlanRequest) => {
    this.#answer(map);
    this.planned.push({ map, request });
    return planOf({ removed: [1], after: 90 });
  };
  check = async () => ({ valid: true, violations: [] });

  #answer(map = ""): void {
    ++this.asks;
    if (this.missing.has(map)) throw new ServiceError("missing", "There is no such map.");
    if (this.gone) throw new ServiceError("gone", "Nobody there.");
  }
}
