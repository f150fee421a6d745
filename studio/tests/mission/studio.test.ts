import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { MapDescription, Obstacles, PlanRequest } from "../../src/api/answers";
import { ServiceError, type Client, type Edits } from "../../src/api/client";
import type { CellMap } from "../../src/map/cell_map";
import { Studio } from "../../src/mission/studio";
import { mapOf } from "../map/picture";
import { planOf } from "./plans";

// A service with two maps. What is drawn is seen on the map `edited`, whose ids are others.
const pictures: Record<string, CellMap> = {
  "city.map": mapOf("....a.....", "....a.bb..", "....a.bb..", ".........."),
  "yard.map": mapOf("....", ".aa.", "...."),
  edited: mapOf("..........", "......aa..", "......aa..", ".........."),
};

function answerOf(cells: CellMap): Obstacles {
  const runs: number[] = [];
  for (let y = 0; y < cells.height; ++y) for (let x = 0; x < cells.width; ++x) runs.push(cells.at(x, y), 1);
  return { width: cells.width, height: cells.height, obstacles: [...cells.obstacles], runs };
}

class FakeClient {
  readonly planned: { map: string; request: PlanRequest }[] = [];
  readonly edits: Edits[] = [];
  gone = false;
  editable = true;

  maps = async () => {
    this.#answer();
    return ["city.map", "yard.map"].map((id) => ({ id, uploaded: false, loaded: true }));
  };
  map = async (id: string) => {
    this.#answer();
    if (!pictures[id]) throw new ServiceError("missing", "There is no such map.");
    const { width, height } = pictures[id];
    return { id, width, height, cell_size: 1, georeference: null, start: null, goal: null } as MapDescription;
  };
  obstacles = async (id: string) => answerOf(pictures[id]!);
  background = async () => ({ features: [] });
  edit = async (_: string, edits: Edits) => {
    if (!this.editable) throw new ServiceError("refused", "No.");
    this.edits.push(edits);
    return this.map("edited");
  };
  upload = async () => {
    throw new ServiceError("refused", "Not a map.");
  };
  plan = async (map: string, request: PlanRequest) => {
    this.#answer();
    this.planned.push({ map, request });
    return planOf({ removed: [1], after: 90 });
  };
  front = async () => ({ ...planOf({}), front: [] });
  check = async () => ({ valid: true, violations: [] });

  #answer(): void {
    if (this.gone) throw new ServiceError("gone", "Nobody there.");
  }
}

let client: FakeClient;
let studio: Studio;
const settle = (time = 0) => vi.advanceTimersByTimeAsync(time);
// The way without removals is asked for beside each plan.
const last = () => client.planned.filter(({ request }) => request.options?.removals !== 0).at(-1)!;

beforeEach(async () => {
  vi.useFakeTimers();
  client = new FakeClient();
  studio = new Studio(client as unknown as Client);
});
afterEach(() => vi.useRealTimers());

it("begins with a map and a plan, without being asked anything", async () => {
  await studio.start("");
  await settle();
  expect(studio.mission.value?.map).toBe("city.map");
  expect(studio.results.plans.value.after?.plan.status).toBe("solved");
  expect(studio.canUndo.value).toBe(false);
  await settle(1000);
  expect(studio.results.plans.value.after?.verdict).toEqual({ valid: true });
});

it("opens what a link says, and says itself the same", async () => {
  const link = "?map=yard.map&start=0,2&goal=3,0&removals=1&method=paper&protect=1&ground_speed=2&show=after,paper";
  await studio.start(link);
  await settle();
  expect(last()).toMatchObject({
    map: "yard.map",
    request: {
      mission: { start: [0, 2], goal: [3, 0], ground_speed: 2 },
      options: { paper: true, protect: [1], removals: 1 },
    },
  });
  expect(studio.link().split("&").sort()).toEqual(link.split("&").sort());
});

it("shows another map where the link's is not there, and says so", async () => {
  await studio.start("?map=nowhere.map&removals=7");
  await settle();
  expect(studio.mission.value).toMatchObject({ map: "city.map", removals: 2 });
  expect(studio.notice.value?.text).toContain("nowhere.map");
});

it("plans on the map as it is after exclusions, with its ids", async () => {
  await studio.start("");
  studio.mark(2, "protect");
  studio.mark(1, "exclude");
  await settle();
  expect(client.edits).toEqual([
    {
      block: [],
      free: [
        [4, 0, 1],
        [4, 1, 1],
        [4, 2, 1],
      ],
    },
  ]);
  expect(last()).toMatchObject({ map: "edited", request: { options: { protect: [1] } } });
  expect(studio.link()).toContain("protect=2&exclude=1");
  expect(studio.markOf(1)).toBe("protect");

  studio.undo();
  await settle();
  expect(last()).toMatchObject({ map: "city.map", request: { options: { protect: [2] } } });
});

it("asks for an edited map once", async () => {
  await studio.start("?map=city.map&exclude=1");
  await settle();
  studio.change((mission) => ({ ...mission, removals: 5 }));
  await settle();
  expect(last().request.options?.removals).toBe(5);
  expect(client.edits).toHaveLength(1);
});

it("says when the service does not edit, and keeps what it shows", async () => {
  await studio.start("");
  await settle();
  client.editable = false;
  studio.mark(1, "exclude");
  await settle();
  expect(studio.notice.value).toEqual({ tone: "bad", text: "No." });
  expect(studio.results.plans.value.after).toBeDefined();
});

it("takes a drag back as one step", async () => {
  await studio.start("");
  const before = studio.mission.value!.markers;
  for (const x of [1, 2, 3]) studio.drag("start", [x, 0], x === 3);
  await settle();
  expect(last().request.mission.start).toEqual([3, 0]);
  studio.undo();
  await settle();
  expect(last().request.mission.start).toEqual(before.start);
  expect(studio.canUndo.value).toBe(false);
});

it("goes back to the map before, too", async () => {
  await studio.start("");
  studio.choose("yard.map");
  await settle();
  expect(last().map).toBe("yard.map");
  studio.undo();
  await settle();
  expect(last().map).toBe("city.map");
  expect(studio.shown.value?.base.description.id).toBe("city.map");
});

it("allows as many removals as have to be", async () => {
  await studio.start("?map=city.map&removals=1");
  studio.mark(1, "force");
  studio.mark(2, "force");
  await settle();
  expect(last().request.options).toMatchObject({ removals: 2, force: [1, 2] });
});

it("loses nothing to a file that is no map", async () => {
  await studio.start("");
  await settle();
  await studio.upload(new File(["hello"], "bad.map"));
  expect(studio.notice.value?.text).toBe("“bad.map” cannot be used as a map: Not a map.");
  expect(studio.loading.value).toBe(false);
  expect(studio.mission.value?.map).toBe("city.map");
  expect(studio.results.plans.value.after).toBeDefined();
});

it("waits for a server that is gone, and then asks for what is wanted by then", async () => {
  await studio.start("");
  await settle();
  client.gone = true;
  studio.change((mission) => ({ ...mission, removals: 3 }));
  await settle();
  expect(studio.gone.value).toBe(true);
  expect(studio.results.plans.value.after).toBeDefined();
  studio.change((mission) => ({ ...mission, removals: 4 }));
  await settle(5000);
  expect(studio.gone.value).toBe(true);
  client.gone = false;
  await settle(2000);
  expect(studio.gone.value).toBe(false);
  expect(last().request.options?.removals).toBe(4);
});
