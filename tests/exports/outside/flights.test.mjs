// Flights for QGroundControl, by the definitions of MAVLink.
import assert from "node:assert/strict";
import test from "node:test";
import mavlink from "mavlink-mappings";
import { json, map, plan, waybreaker } from "./waybreaker.mjs";

const { MavCmd, MavFrame } = mavlink.common;

plan("--breach-time", "30s", "--altitude", "60", "--qgc", "flight.plan");

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
    const options = ["--altitude", "60", "--breach-command", `${name}:1`, "--qgc", "-"];
    const flight = waybreaker("export", map, "plan.json", ...options);
    assert.equal(JSON.parse(flight).mission.items[3].command, MavCmd[name]);
  });
}
