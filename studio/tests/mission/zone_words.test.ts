import { expect, it } from "vitest";
import type { Units } from "../../src/domain/units";
import { barredHeadline } from "../../src/mission/zone_words";
import { planOf } from "../domain/plans";

const city: Units = { metric: true, cell: 2.4, time: "seconds", seconds: 1 };

it("names the zone that stands in the way, and in whose", () => {
  const none = planOf({ after: null, status: "not_found" });
  expect(barredHeadline(none, city)).toBeNull();
  const zones = { features: [{ properties: {} }, { properties: { name: "air\u202eport" } }] };
  const mission = { agents: [{ kind: "ground" }, { kind: "air", id: "heli" }], rules: { zones } };
  const title = (zone: number, agent: string) =>
    barredHeadline({ ...none, mission, barred_by: { zone, agent, at: 232.7 } }, city)!.title.replaceAll(/[\u00a0\u202f]/g, " ");
  expect(title(1, "ground")).toBe("No plan was found: after 3 min 53 s, zone 1 stands in the way of the ground robot");
  expect(title(2, "heli")).toBe("No plan was found: after 3 min 53 s, the zone airport stands in the way of heli");
});
