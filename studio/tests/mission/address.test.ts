import { expect, it, vi } from "vitest";
import type { Run } from "../../src/domain/geometry";
import { freshMission } from "../../src/domain/mission";
import { fragmentOf, holdsMission, longestLink, missionAt } from "../../src/mission/address";
import { encodeLink } from "../../src/mission/link";
import { union } from "../../src/mission/run_set";

const at = (hash: string, search = "") => missionAt({ hash, search });
const short = "map=berlin-mitte.tif&start=256,434&goal=118,55&removals=2";

// As people draw walls: lines three cells wide.
function strokes(count: number): Run[] {
  const runs: Run[] = [];
  for (let i = 0; i < count; ++i) {
    const [x, y, slope] = [(i * 97) % 400, (i * 61) % 300, (i % 7) / 3 - 1];
    for (let row = 0; row < 120; ++row) runs.push([Math.max(0, Math.round(x + row * slope)), y + row, 3]);
  }
  return union(runs, []);
}

it("holds a short mission readably, and a long one compressed", async () => {
  expect(await fragmentOf(short)).toBe(`#${short}`);
  const walls = strokes(32);
  const long = encodeLink({ ...freshMission("m", { start: [0, 0], goal: [9, 9] }), walls }, 501);
  expect(long.length).toBeGreaterThan(8192); // what the server takes of an address
  const fragment = await fragmentOf(long);
  expect(fragment).toMatch(/^#z=[\w-]+$/);
  expect(fragment.length).toBeLessThan(longestLink);
  for (const query of [short, long, `${short}&walls=${"ü".repeat(500)}`]) expect(await at(await fragmentOf(query))).toBe(query);
});

it("is found in the links of former versions, too", async () => {
  expect(await at("", `?${short}`)).toBe(short);
  expect(await at("#start=1,2&goal=3,4", `?${short}`)).toBe("start=1,2&goal=3,4");
  expect(await at("", "")).toBe("");
  expect(await at("#removed-table", "?utm_source=mail")).toBe("");
});

it("must be whole", async () => {
  const fragment = await fragmentOf(short.repeat(20));
  await expect(at(fragment.slice(0, -20))).rejects.toThrow();
  await expect(at("#z=%%%")).rejects.toThrow();
  await expect(at("#z=AAAA")).rejects.toThrow();
});

it("is not unpacked without end", async () => {
  const bomb = await fragmentOf("map=".padEnd(20_000_000, "a"));
  let unpacked = 0;
  const Unpacking = DecompressionStream;
  vi.stubGlobal(
    "DecompressionStream",
    class {
      readonly writable;
      readonly readable;
      constructor(format: CompressionFormat) {
        const own = new Unpacking(format);
        this.writable = own.writable;
        this.readable = own.readable.pipeThrough(
          new TransformStream<Uint8Array, Uint8Array>({
            transform(bytes, to) {
              unpacked += bytes.length;
              to.enqueue(bytes);
            },
          }),
        );
      }
    },
  );
  await expect(at(bomb)).rejects.toThrow("too large");
  vi.unstubAllGlobals();
  expect(unpacked).toBeLessThan(4_000_000);
});

it("knows what a mission is by map or places", () => {
  expect([short, "start=1,2", "token=x", ""].map(holdsMission)).toEqual([true, true, false, false]);
});
