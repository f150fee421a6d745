// Maps of a page without a service: files that are fetched once.
import { describe, expect, it } from "vitest";
import { LocalClient } from "../../src/api/local_client";

const city = { description: { id: "city", obstacles: { count: 1 } }, obstacles: ["a house"], background: ["a river"] };

// A client of a host of files, and what was fetched there.
function hosted(isThere: () => boolean = () => true): { client: LocalClient; fetched: string[] } {
  const fetched: string[] = [];
  const noWorker = () => {
    throw new Error("nothing is planned here");
  };
  const fetch = async (path: string) => {
    fetched.push(path);
    await new Promise((done) => setTimeout(done));
    if (!isThere()) throw new Error("no network");
    return new Response(JSON.stringify(path === "maps.json" ? { maps: [{ id: "city" }] } : city));
  };
  const client = new LocalClient(noWorker, new Promise(() => undefined), { fetched: fetch, hasFiles: true });
  return { client, fetched };
}

describe("a client of a page without a service", () => {
  it("fetches a map once, for all who ask meanwhile and later", async () => {
    const { client, fetched } = hosted();
    await client.maps();
    const parts = await Promise.all([client.map("city"), client.obstacles("city"), client.background("city")]);
    expect(parts).toEqual([city.description, city.obstacles, city.background]);
    await client.map("city");
    expect(fetched).toEqual(["maps.json", "maps/city.json"]);
  });

  it("fetches on for others where one of them stops", async () => {
    const { client, fetched } = hosted();
    await client.maps();
    const stop = new AbortController();
    const first = client.map("city", stop.signal);
    const second = client.obstacles("city");
    stop.abort();
    await expect(first).rejects.toMatchObject({ trouble: "stopped" });
    expect(await second).toEqual(city.obstacles);
    expect(fetched).toEqual(["maps.json", "maps/city.json"]);
  });

  it("tries again after a failure", async () => {
    let isThere = true;
    const { client } = hosted(() => isThere);
    await client.maps();
    isThere = false;
    await expect(client.map("city")).rejects.toThrow("no network");
    isThere = true;
    expect(await client.map("city")).toEqual(city.description);
  });
});
