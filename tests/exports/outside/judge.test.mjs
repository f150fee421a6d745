import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import test from "node:test";
import Ajv from "ajv";
import addFormats from "ajv-formats";
import mavlink from "mavlink-mappings";

const json = (file) => JSON.parse(readFileSync(file, "utf8"));
const { MavCmd, MavFrame } = mavlink.common;

const flight = (action) => {
  const options = ["--altitude", "60", "--qgc", "-", ...(action ? ["--breach-command", action] : [])];
  return JSON.parse(execFileSync("waybreaker", ["export", process.env.map, "plan.json", ...options], { encoding: "utf8" }));
};

test("a flight takes off, goes at a speed, opens what the plan opens, and lands", () => {
  const items = json("flight.plan").mission.items;
  assert.equal(items[0].command, MavCmd.NAV_TAKEOFF);
  assert.equal(items[1].command, MavCmd.DO_CHANGE_SPEED);
  assert.deepEqual(items[1].params.slice(0, 3), [1, 8, -1]);
  assert.equal(items.at(-1).command, MavCmd.NAV_LAND);
  const between = items.slice(2, -1).map((item) => item.command);
  const stop = [MavCmd.NAV_WAYPOINT, MavCmd.DO_SET_RELAY, MavCmd.NAV_LOITER_TIME];
  const breaches = json("plan.json").removed.length;
  assert.ok(breaches > 0);
  assert.deepEqual(between, [...Array(breaches).fill(stop).flat(), MavCmd.NAV_WAYPOINT]);
  for (const item of items) {
    const flies = MavCmd[item.command].startsWith("NAV_");
    assert.equal(item.frame, flies ? MavFrame.GLOBAL_RELATIVE_ALT : MavFrame.MISSION);
  }
});

const names = ["DO_SET_RELAY", "DO_REPEAT_RELAY", "DO_SET_SERVO", "DO_REPEAT_SERVO", "DO_SET_ACTUATOR", "DO_GRIPPER",
  "NAV_PAYLOAD_PLACE"];
for (const name of names) {
  test(`${name} has MAVLink's number`, () => {
    assert.equal(flight(`${name}:1`).mission.items[3].command, MavCmd[name]);
  });
}

const schemas = process.env.WAYBREAKER_VDA5050_SCHEMAS;
test("orders and zones are valid by the schemas of VDA 5050", { skip: !schemas && "WAYBREAKER_VDA5050_SCHEMAS is not set" }, () => {
  const ajv = addFormats(new Ajv({ allErrors: true, strict: false }));
  const { orders, zoneSets } = json("orders.json");
  for (const [schema, messages] of [["order", orders], ["zoneSet", zoneSets]]) {
    const valid = ajv.compile(json(`${schemas}/${schema}.schema`));
    assert.ok(messages.length > 0);
    for (const message of messages) assert.ok(valid(message), JSON.stringify(valid.errors));
    assert.ok(!valid({ ...messages[0], serialNumber: 1 }));
  }
});
