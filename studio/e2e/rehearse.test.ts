// A rehearsal in the page: what goes wrong by mouse and by keyboard, and revisions that the command's check accepts.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { RevisionAnswer, RevisionRequest } from "../src/api/documents";
import type { Plan } from "../src/domain/plan";
import { positionAt } from "../src/play/motion";
import { command, data } from "./command";
import { Setting } from "./setting";
import { phone, type StudioPage } from "./studio_page";

const city = join(data, "berlin-adlershof.tif");
const size = { width: 501, height: 501 };
const setting = new Setting("rehearse");
const { scratch } = setting;

function written(name: string, document: unknown): string {
  const file = join(scratch, name);
  writeFileSync(file, JSON.stringify(document));
  return file;
}

interface Exchange {
  request: RevisionRequest;
  answer: RevisionAnswer;
}

// What the page asks and is answered while something is done on it: the last time.
async function revised(studio: StudioPage, doIt: () => Promise<void>): Promise<Exchange> {
  const answers: Promise<Exchange>[] = [];
  const listen = (response: { url(): string; request(): { postDataJSON(): unknown }; json(): Promise<unknown> }) => {
    if (!response.url().endsWith("/revise")) return;
    const request = response.request().postDataJSON() as RevisionRequest;
    answers.push(response.json().then((answer) => ({ request, answer: answer as RevisionAnswer })));
  };
  studio.page.on("response", listen);
  await doIt();
  await studio.page.locator('.rehearsal[aria-busy="false"]').getByText("Checked independently").waitFor();
  studio.page.off("response", listen);
  return (await Promise.all(answers)).at(-1)!;
}

function goesOn({ request, answer }: Exchange, next = written("next.json", answer.plan)): string {
  const [old, state] = [request.plan, request.state].map((one, i) => written(`${i}.json`, one));
  return execFileSync(command, ["check", city, next, "--after", old!, "--state", state!], { encoding: "utf8" });
}

// Goes to about that time; to which one, it says.
async function seek(studio: StudioPage, time: number): Promise<number> {
  const slider = studio.page.getByRole("slider", { name: "Time of the mission" });
  await slider.evaluate((one, to) => {
    (one as HTMLInputElement).value = String(to);
    one.dispatchEvent(new Event("input", { bubbles: true }));
  }, time);
  return Number(await slider.inputValue());
}

it("lets a breach fail and rubble fall, by the mouse, and undo takes both back", async () => {
  const studio = await setting.settled();
  const { page } = studio;
  const plan = await studio.plan();
  const [first] = [...plan.removed].sort((a, b) => a.cleared_at - b.cleared_at);
  await page.getByRole("button", { name: "Rehearse this plan" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  await seek(studio, first!.cleared_at / 2);

  const opening = await studio.place(first!.at, size);
  const failure = await revised(studio, async () => {
    await page.mouse.click(opening.x, opening.y, { button: "right" });
    await page.getByRole("menuitem", { name: /^The breach of .+ fails, at / }).click();
  });
  expect(failure.request.state.failed).toEqual([{ obstacle: first!.obstacle, at: first!.cleared_at }]);
  expect(failure.answer.plan!.removed.map((one) => one.obstacle)).not.toContain(first!.obstacle);
  expect(goesOn(failure)).toContain("valid");
  await studio.result().getByRole("heading", { name: /^The breach of .+ failed at \d+:\d\d: the mission ends/ }).waitFor();
  expect(await studio.accessibilityFaults()).toEqual([]);

  await page.getByRole("radio", { name: "Rubble" }).check({ force: true });
  const ahead = positionAt(failure.answer.plan!.agents[0]!, failure.request.state.now + 40)!;
  const spot = await studio.place([ahead.x, ahead.y], size);
  const rubble = await revised(studio, async () => {
    await page.mouse.move(spot.x, spot.y - 30);
    await page.mouse.down();
    for (let step = 1; step <= 6; ++step) await page.mouse.move(spot.x, spot.y - 30 + 5 * step);
    await page.mouse.up();
    await studio.result().getByRole("heading", { name: /^Rubble fell on the street/ }).waitFor();
  });
  expect(rubble.request.plan).toEqual(failure.answer.plan);
  expect(rubble.request.state.found[0]!.cells.length).toBeGreaterThan(10);
  expect(goesOn(rubble)).toContain("valid");

  const saved = page.waitForEvent("download");
  await page.getByRole("region", { name: "Take it along" }).getByRole("button", { name: "Plan (JSON)" }).click();
  const file = join(scratch, "taken.json");
  await (await saved).saveAs(file);
  expect((JSON.parse(readFileSync(file, "utf8")) as Plan).agents).toEqual(rubble.answer.plan!.agents);
  expect(goesOn(rubble, file)).toContain("valid");

  await page.getByRole("radio", { name: "Move" }).check({ force: true });
  await page.keyboard.press("Control+z");
  await studio.result().getByRole("heading", { name: /^The breach of/ }).waitFor();
  await page.keyboard.press("Control+z");
  await studio.result().getByText(/Removing 2 obstacles/).first().waitFor();
  expect(studio.faults).toEqual([]);
});

it("loses the aircraft by the keyboard alone, on a phone in the dark", async () => {
  const studio = await setting.settled({ viewport: phone, colorScheme: "dark" });
  const { page } = studio;
  await page.getByRole("button", { name: "Rehearse this plan" }).focus();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Pause" }).focus();
  await page.keyboard.press("Enter");
  const loss = await revised(studio, async () => {
    await page.getByRole("button", { name: "The aircraft: Lost" }).focus();
    await page.keyboard.press("Enter");
  });
  expect(loss.request.state.agents.map(({ doing }) => doing)).toContain("lost");
  expect(goesOn(loss)).toContain("valid");
  await studio.result().getByRole("heading", { name: /^The aircraft was lost at/ }).waitFor();
  expect(await studio.accessibilityFaults()).toEqual([]);
  expect(await studio.cutOff("button, h1, h2")).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);

  await page.getByRole("button", { name: "Follow" }).press("Enter"); // brings the vehicle into the middle
  const choices = page.getByRole("menuitem");
  await expect.poll(async () => {
    await studio.map().press("Shift+F10");
    return choices.allInnerTexts();
  }).toEqual([expect.stringMatching(/^The ground robot stands still for/), expect.stringMatching(/^The ground robot stands still for/)]);
  await page.keyboard.press("ArrowDown");
  expect(await choices.last().evaluate((one) => one === document.activeElement)).toBe(true);
  await page.keyboard.press("Escape");
  expect(await choices.count()).toBe(0);
  await page.getByRole("button", { name: "Back to the plan" }).click();
  await studio.result().getByText(/Removing 2 obstacles/).first().waitFor();
  expect(studio.faults).toEqual([]);
});

it("delays a vehicle of a team, and who goes behind it keeps to the orders", async () => {
  const mission = {
    format: "waybreaker-mission/1",
    agents: [
      { id: "truck", kind: "ground", start: [130, 104], goal: [466, 105] },
      { id: "rover", kind: "ground", start: [319, 410], goal: [72, 474], speed: 2 },
      { id: "drone", kind: "air", start: [130, 104], goal: [130, 104], speed: 5 },
    ],
    rules: { removals: 2, breach_time: 5 },
  };
  const studio = await setting.settled();
  const { page } = studio;
  await page.getByLabel("File to open").setInputFiles(written("mission.json", mission));
  await page.getByRole("table", { name: /^When each agent arrives/ }).getByRole("button", { name: "rover", exact: true }).waitFor();
  await studio.settled();
  await page.getByRole("button", { name: "Rehearse this plan" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  const time = await seek(studio, 60);
  const delay = await revised(studio, () => page.getByRole("button", { name: /^Truck: .+ late$/ }).last().click());
  const { now, agents } = delay.request.state;
  expect(now).toBeGreaterThan(time);
  const { x, y } = positionAt(delay.request.plan.agents[0]!, time)!;
  expect(agents[0]!.at).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
  expect(goesOn(delay)).toContain("valid");
  await studio.result().getByRole("heading", { name: /^Truck stood still for .+ from .+ on: / }).waitFor();
  expect(await studio.accessibilityFaults()).toEqual([]);
  expect(studio.faults).toEqual([]);
});
