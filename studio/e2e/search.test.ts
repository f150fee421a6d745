// What the page claims, and when: the steps of a search, the missions that maps open with.
import { readdirSync } from "node:fs";
import { expect, it } from "vitest";
import { data } from "./command";
import { Setting } from "./setting";

const setting = new Setting("search");

it("calls a first answer what it is, and stops and goes on when told to", async () => {
  const studio = await setting.visit();
  await studio.settled();
  const steps = () => studio.result().getByRole("group", { name: "State of the search" }).getByRole("listitem").allTextContents();
  expect(await steps()).toEqual(["Quick answer, done", "Looked, done", "Proven, not yet"]);
  // A server that is so slow that nothing comes of the first two seconds, nor of the longer search before the test lets it.
  let goOn = (): void => undefined;
  const held = new Promise<void>((done) => (goOn = done));
  await studio.page.route("**/plan", async (route) => {
    const request = route.request().postDataJSON() as { options: { time_limit?: number; removals: number } };
    const { time_limit: limit, removals } = request.options;
    if (limit === 2 && removals > 0) request.options.time_limit = 1e-9;
    if (limit === 10) await held;
    await route.continue({ postData: JSON.stringify(request) }).catch(() => undefined); // stopped meanwhile
  });
  await studio.marker("Ground start").focus();
  await studio.page.keyboard.press("Shift+ArrowDown");
  await studio.result().getByRole("heading", { name: /^So far, / }).waitFor();
  expect(await studio.result().getAttribute("class")).not.toContain("bad");
  await studio.result().getByText(/Looking for a better plan|Waiting for the planner/).waitFor(); // which has not got the request
  expect((await steps()).slice(1)).toEqual(["Looking, now", "Proven, not yet"]);
  await studio.result().getByRole("button", { name: "Stop" }).click();
  await studio.result().getByText("Stopped: there may be a better plan.").waitFor();
  goOn();
  await studio.result().getByRole("button", { name: "Look on" }).click();
  await studio.result().getByRole("heading", { name: /^Removing 2 obstacles gets the ground robot there/ }).waitFor();
  await studio.settled();
  expect(await studio.accessibilityFaults()).toEqual([]);
  expect(studio.faults).toEqual([]);
  await studio.close();
});

for (const map of readdirSync(data).filter((name) => name.endsWith(".tif"))) {
  it(`${map} opens with a mission that two removals make 5 % shorter`, async () => {
    const studio = await setting.visit({ query: `#map=${map}` });
    await studio.settled();
    const [after, before] = await studio.figures();
    expect(1 - after! / before!).toBeGreaterThanOrEqual(0.05);
    const { removed, agents } = await studio.plan();
    expect([1, 2]).toContain(removed.length);
    const [{ start, goal }, cell] = [agents[0]!, (await studio.plan()).map.cell_size];
    expect(cell * Math.hypot(goal[0] - start[0], goal[1] - start[1])).toBeGreaterThan(400);
    await studio.close();
  });
}

it("moves the map to what is chosen by name, if it is off the picture", async () => {
  const studio = await setting.visit();
  await studio.settled();
  await studio.page.emulateMedia({ reducedMotion: "reduce" });
  const box = (await studio.map().boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await studio.page.mouse.move(box.x + box.width * 0.2, box.y + box.height * 0.95);
  for (let turn = 0; turn < 6; ++turn) await studio.page.mouse.wheel(0, -400);
  const name = studio.page.getByRole("table", { name: /^Removed obstacles/ }).locator(".obstacle-name").first();
  await name.click();
  const card = studio.page.getByRole("complementary", { name: /^About / });
  const about = await card.getAttribute("aria-label");
  await card.getByRole("button", { name: "Close" }).click();
  await studio.page.mouse.click(x, y); // it is in the middle
  await card.waitFor();
  expect(await card.getAttribute("aria-label")).toBe(about);
  await studio.close();
});
