// What goes wrong: files that are no maps, maps and servers that are gone.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { Server } from "./server";
import { Setting } from "./setting";
import { yardFile } from "./yard";

const setting = new Setting("trouble");
const { scratch } = setting;

it("a file that is no map gets the server's words, and the mission stays", async () => {
  const page = await setting.settled();
  const before = await page.figures();
  const file = join(scratch, "holiday.map");
  writeFileSync(file, "type octile\nheight 3\nwidth banana\nmap\n");
  await page.page.getByLabel("File to open").setInputFiles(file);
  const alert = page.page.getByRole("alert").filter({ hasText: "holiday.map" });
  await alert.waitFor();
  expect(await alert.innerText()).toMatch(/width|banana|line 3/);
  expect(await page.figures()).toEqual(before);
});

it("a good file of one's own is opened", async () => {
  const page = await setting.settled();
  await page.page.getByLabel("File to open").setInputFiles(yardFile(scratch));
  await expect.poll(async () => (await page.plan()).map.width).toBe(20);
  await page.settled();
});

it("a ROS map is opened by its YAML and image together, and an image alone says how it was read", async () => {
  const [yaml, image] = [join(scratch, "floor.yaml"), join(scratch, "floor.pgm")];
  const greys = Array.from({ length: 12 * 12 }, (_, i) => (i % 12 === 6 && i > 24 ? 0 : i < 12 ? 205 : 254));
  writeFileSync(yaml, "image: floor.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  writeFileSync(image, `P2 12 12 255\n${greys.join(" ")}\n`);
  const page = await setting.settled();
  const input = page.page.getByLabel("File to open");
  await input.setInputFiles(yaml);
  await page.page.getByText("“floor.yaml” belongs to “floor.pgm”: choose both together.").waitFor();
  await input.setInputFiles([image, yaml]);
  await expect.poll(async () => (await page.plan()).map.cell_size).toBe(0.5);
  await page.settled();
  expect(await page.page.getByLabel("About this map").innerText()).toMatch(/^8\.3 % of this map is unknown ground, without data: it bars the way\.$/);
  await input.setInputFiles(image);
  await page.page.getByLabel("About this map").getByText(/205.* is free/).waitFor();
});

it("a map that is gone is said, asked for once, and can be sent again", async () => {
  const other = await Server.start();
  const studio = await setting.settled({}, `${other.url}/`);
  await studio.page.getByLabel("File to open").setInputFiles(yardFile(scratch));
  await expect.poll(async () => (await studio.plan()).map.width).toBe(20);
  await studio.settled();
  await other.stop();
  const back = await Server.start(other.port);
  let asked = 0;
  studio.page.on("request", () => ++asked);
  await studio.marker("Ground goal").focus(); // what no plan of the curve knows
  await studio.page.keyboard.press("ArrowLeft");
  const card = studio.page.getByRole("alert").filter({ hasText: "no longer has the map “yard.map”" });
  await card.waitFor();
  await studio.result().getByText("This is the plan from before your last change").waitFor();
  expect(await studio.result().getByText("Checked independently").count()).toBe(0);
  await studio.marker("Ground goal").focus();
  await studio.page.keyboard.press("ArrowLeft");
  await studio.page.waitForTimeout(1500);
  expect(asked).toBeLessThan(6);
  await card.getByRole("button", { name: "Send it again" }).click();
  await card.waitFor({ state: "detached" });
  await studio.settled();
  expect((await studio.plan()).map.width).toBe(20);
  await studio.result().getByText("Checked independently").waitFor(); // of the plan that is on its way
  await back.stop();
});

it("a server that is gone is told of, and the page goes on when it is back", async () => {
  const other = await Server.start();
  const studio = await setting.settled({}, `${other.url}/`);
  const before = await studio.figures();
  await other.stop();
  await studio.marker("Ground goal").focus();
  await studio.page.keyboard.press("ArrowRight");
  await studio.page.getByText("The server does not answer").waitFor();
  expect(await studio.figures()).toEqual(before);
  const back = await Server.start(other.port);
  await studio.page.getByText("The server does not answer").waitFor({ state: "detached" });
  const goal = await studio.cellOf("Ground goal");
  await expect.poll(async () => (await studio.plan()).agents[0]!.goal).toEqual(goal);
  await back.stop();
});
