// The command, whose plans the package's must equal: WAYBREAKER_COMMAND, by default that of the release build.
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const project = resolve(fileURLToPath(import.meta.url), "../../..");
const command = process.env.WAYBREAKER_COMMAND ?? join(project, "build/release/apps/waybreaker");
if (!existsSync(command)) throw new Error(`there is no ${command}: build the command, or set WAYBREAKER_COMMAND`);

// Exit statuses: bad input; those that come with a plan file nevertheless.
const refused = 2;
const noPlan = [1, 4];

export class Refused extends Error {}

export class Scratch {
  folder = mkdtempSync(join(tmpdir(), "waybreaker-npm-"));

  file(name, content) {
    const path = join(this.folder, name);
    writeFileSync(path, content);
    return path;
  }

  remove() {
    rmSync(this.folder, { recursive: true });
  }
}

/** What the command writes for a mission, without measured seconds. */
export function nativePlan(scratch, { name, map, mission, front = false, options = {} }) {
  const { connectivity = 4, cellSize } = options;
  const { status, stdout, stderr } = spawnSync(
    command,
    [
      "plan",
      scratch.file(name, map),
      "--mission",
      scratch.file("mission.json", JSON.stringify(mission)),
      "--connectivity",
      String(connectivity),
      ...(cellSize === undefined ? [] : ["--cell-size", String(cellSize)]),
      ...(front ? ["--removals", "auto"] : []),
      "--no-timing",
      "--json",
      "-",
    ],
    { maxBuffer: 2 ** 28 },
  );
  if (status === refused) throw new Refused(stderr.toString());
  if (status !== 0 && !noPlan.includes(status)) throw new Error(`${command}: status ${status}, ${stderr}`);
  return stdout.toString();
}

/** What the command makes of a plan (a text) and a state: the next plan, and the report of its check. */
export function nativeRevision(scratch, { name, map, plan, state, reaction = 0 }) {
  const mapFile = scratch.file(name, map);
  const planFile = scratch.file("before.json", plan);
  const stateFile = scratch.file("state.json", JSON.stringify(state));
  const [newFile, reportFile] = ["new.json", "report.json"].map((file) => join(scratch.folder, file));
  const run = (...words) => {
    const { status, stderr } = spawnSync(command, words.map(String));
    if (status === refused) throw new Refused(stderr.toString());
    if (status !== 0 && !noPlan.includes(status)) throw new Error(`${command}: status ${status}, ${stderr}`);
  };
  const limits = ["--reaction", reaction, "--time-limit", 1e6];
  run("revise", mapFile, planFile, "--state", stateFile, ...limits, "--no-timing", "--json", newFile);
  run("check", mapFile, newFile, "--after", planFile, "--state", stateFile, "--json", reportFile);
  return { plan: readFileSync(newFile, "utf8"), report: JSON.parse(readFileSync(reportFile, "utf8")) };
}

/** A map of data/ as a MovingAI map. */
export function cityMap(scratch, tiff) {
  const path = join(scratch.folder, "city.map");
  execFileSync(command, ["map", "convert", join(project, "data", tiff), path], { stdio: "ignore" });
  return readFileSync(path, "utf8");
}
