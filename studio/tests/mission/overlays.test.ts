import { beforeEach, expect, it } from "vitest";
import { type Client, ServiceError } from "../../src/api/client";
import type { MapDescription } from "../../src/domain/map";
import type { Choice } from "../../src/domain/mission";
import type { KeptFile } from "../../src/mission/kept_file";
import { moved, Overlays, type OverlayState } from "../../src/mission/overlays";
import { mapOf } from "../domain/picture";

const flood: KeptFile = { name: "flood.of.today.geojson", bytes: new Blob(["{}"]) };

class FakeClient {
  readonly laid: { map: string; use: string; width: number }[] = [];
  failure: ServiceError | null = null;
  overlay = async (map: string, { use, width }: OverlayState) => {
    this.laid.push({ map, use, width });
    if (this.failure) throw this.failure;
    return { id: "upload-1" } as MapDescription;
  };
  file = async () => ({ bytes: new Blob(["tiff"]), name: "upload-1.tif" });
}

let client: FakeClient;
let opened: { map: string; file: string }[];
let overlays: Overlays;
beforeEach(() => {
  client = new FakeClient();
  opened = [];
  overlays = new Overlays(client as unknown as Client, async (map, file) => opened.push({ map: map.id, file: file.name }));
});

it("lays a file over the map as what a person says it is", async () => {
  overlays.begin(flood, "city.tif");
  expect(overlays.state.value).toMatchObject({ use: "water", busy: false });
  overlays.choose({ use: "closed", width: 9 });
  await overlays.finish();
  expect(client.laid).toEqual([{ map: "city.tif", use: "closed", width: 9 }]);
  expect(opened).toEqual([{ map: "upload-1", file: "flood.tif" }]);
  expect(overlays.state.value).toBeNull();
});

it("says why it could not, and can be tried as something else", async () => {
  client.failure = new ServiceError("refused", "Not so.");
  overlays.begin(flood, "city.tif");
  await overlays.finish();
  expect(overlays.state.value).toMatchObject({ busy: false, failure: "Not so." });
  overlays.choose({ use: "wall" });
  expect(overlays.state.value?.failure).toBeNull();
  overlays.cancel();
  expect(overlays.state.value).toBeNull();
  expect(opened).toEqual([]);
});

it("forgets the answer to what was cancelled", async () => {
  overlays.begin(flood, "city.tif");
  const finished = overlays.finish();
  overlays.cancel();
  await finished;
  expect(opened).toEqual([]);
});

// F is the flood, which takes the mill and the shed, and leaves a part of the barn.
it("finds marked obstacles again where a flood has taken a part of them, and drawn walls by their cells", () => {
  const from = mapOf("aa.bb", "aa.bb", "..c..");
  const to = mapOf("FFFb.", "FFFbb", "..F..");
  const marks = new Map<number, Choice>([[1, "protect"], [2, "force"], [3, "exclude"], [-4, "allow"]]);
  for (const [name, obstacle] of [["Mill", from.obstacles[0]], ["Barn", from.obstacles[1]], ["Shed", from.obstacles[2]]] as const) {
    Object.assign(obstacle!, { name });
  }
  Object.assign(to.obstacles[1]!, { name: "Barn" });
  expect([...moved(marks, from, to)]).toEqual([[to.at(3, 0), "force"], [-4, "allow"]]);
});
