import { beforeEach, expect, it, vi } from "vitest";
import { type Client, ServiceError } from "../../src/api/client";
import type { ImportRequest, Source } from "../../src/domain/extract";
import type { MapDescription } from "../../src/domain/map";
import { Importer } from "../../src/mission/importer";
import type { KeptFile } from "../../src/mission/kept_file";

const source: Source = {
  id: "source-1",
  name: "town.osm",
  bytes: 4,
  bounds: [8.9, 49.9, 9.1, 50.1],
  buildings: 1,
  columns: 1,
  rows: 1,
  built: [0.5],
  densest: { center: [9, 50], size: 800 },
  places: [],
};
const town: KeptFile = { name: "town.osm.pbf", bytes: new Blob(["data"]) };

class FakeClient {
  sent = 0;
  readonly imported: ImportRequest[] = [];
  described = source;
  failure: ServiceError | null = null; // of the next request
  sendSource = async () => {
    this.#fail();
    ++this.sent;
    return { ...this.described, id: `source-${this.sent}` };
  };
  importMap = async (request: ImportRequest) => {
    this.imported.push(request);
    this.#fail();
    return { id: "upload-1" } as MapDescription;
  };
  file = async () => ({ bytes: new Blob(["tiff"]), name: "upload-1.tif" });

  #fail(): void {
    const { failure } = this;
    this.failure = null;
    if (failure) throw failure;
  }
}

let client: FakeClient;
let opened: { map: string; file: string }[];
let importer: Importer;
beforeEach(() => {
  client = new FakeClient();
  opened = [];
  importer = new Importer(client as unknown as Client, async (map, file) => opened.push({ map: map.id, file: file.name }));
});

it("offers the densest window, and opens the map of the one that is chosen", async () => {
  await importer.begin(town);
  expect(importer.state.value).toMatchObject({ stage: "choosing", request: { center: [9, 50], size: 800 } });
  importer.choose({ size: 300, profile: "truck" });
  await importer.finish();
  expect(client.imported).toMatchObject([{ source: "source-1", size: 300, profile: "truck", center: [9, 50] }]);
  expect(opened).toEqual([{ map: "upload-1", file: "town.tif" }]);
  expect(importer.state.value).toBeNull();
});

it("says what is wrong with the file, and with the window", async () => {
  client.failure = new ServiceError("refused", "Town.osm.pbf: is damaged or cut short: at 3.");
  await importer.begin(town);
  expect(importer.state.value).toMatchObject({ stage: "failed", failure: "The file is damaged or cut short: at 3." });
  await importer.begin(town);
  client.failure = new ServiceError("refused", "No building there.");
  await importer.finish();
  expect(importer.state.value).toMatchObject({ stage: "choosing", failure: "No building there." });
  importer.choose({ size: 500 });
  expect(importer.state.value?.failure).toBeNull();
  expect(opened).toEqual([]);
});

it("says so where a file's description is none, and takes the next file", async () => {
  client.described = { ...source, bounds: [null, 1, null, 3] as unknown as Source["bounds"] };
  await importer.begin(town);
  expect(importer.state.value).toMatchObject({ stage: "failed", source: null, failure: expect.stringMatching(/cannot be shown/) });
  client.described = source;
  await importer.begin(town);
  expect(importer.state.value).toMatchObject({ stage: "choosing", failure: null });
});

it("is not left waiting by a description that it does not understand at all", async () => {
  const silent = vi.spyOn(console, "error").mockImplementation(() => undefined);
  client.described = { id: "source-1" } as Source;
  await importer.begin(town);
  expect(importer.state.value).toMatchObject({ stage: "failed", source: null });
  expect(silent).toHaveBeenCalledOnce();
  silent.mockRestore();
});

it("sends the file once more where the service has forgotten it", async () => {
  await importer.begin(town);
  client.failure = new ServiceError("missing", "There is no such source.");
  await importer.finish();
  expect(client.imported.map((request) => request.source)).toEqual(["source-1", "source-2"]);
  expect(opened).toHaveLength(1);
});

it("tells of a file that the service hangs up on for its size", async () => {
  client.failure = new ServiceError("gone", "The server does not answer.");
  await importer.begin({ name: "land.osm.pbf", bytes: new Blob([new Uint8Array(33 * 2 ** 20)]) });
  expect(importer.state.value?.failure).toMatch(/33 MB.*--max-upload/);
});

it("does nothing more once it is cancelled", async () => {
  const begun = importer.begin(town);
  importer.cancel();
  await begun;
  expect(importer.state.value).toBeNull();
  await importer.begin(town);
  const finished = importer.finish();
  importer.cancel();
  await finished;
  expect(opened).toEqual([]);
  expect(importer.state.value).toBeNull();
});
