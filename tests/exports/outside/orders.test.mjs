// Orders of VDA 5050, by its schemas and by a vehicle that is not ours.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import net from "node:net";
import { join } from "node:path";
import test, { after, before } from "node:test";
import Ajv from "ajv/dist/2020.js";
import addFormats from "ajv-formats";
import mqtt from "mqtt";
import vda5050 from "vda-5050-lib";
import { file, json, map, plan, waybreaker } from "./waybreaker.mjs";

// Off the vehicle's way.
const yard = [[20, 20], [60, 24], [40, 70], [20, 20]];
writeFileSync(file("zones.geojson"), JSON.stringify({
  type: "FeatureCollection",
  crs: "cells",
  features: [{
    type: "Feature",
    properties: { zone: "keep_out", name: "yard" },
    geometry: { type: "Polygon", coordinates: [yard] },
  }],
}));

// When the vehicle gets to the end of its first base, the last breach before it turns out to have failed.
plan("--zones", "zones.geojson", "--breach-time", "200s", "--vda5050", "orders.json");
const now = Date.parse(json("orders.json").orders[1].timestamp) / 1000;
const breach = json("plan.json").removed.filter((one) => one.cleared_at < now).at(-1);
const failed = [{ obstacle: breach.obstacle, at: breach.cleared_at }];
writeFileSync(file("state.json"), JSON.stringify({ format: "waybreaker-state/1", sequence: 1, now, failed }));
waybreaker("revise", map, "plan.json", "--state", "state.json", "--json", "new.json");
waybreaker("export", map, "new.json", "--vda5050", "revised.json");

const schemas = process.env.WAYBREAKER_VDA5050_SCHEMAS;
const skip = !schemas && "WAYBREAKER_VDA5050_SCHEMAS is not set";
for (const messages of ["orders.json", "revised.json"]) {
  test(`${messages} is valid by the schemas of VDA 5050`, { skip }, () => {
    const ajv = addFormats(new Ajv({ allErrors: true, strict: false }));
    const { orders, zoneSets, instantActions } = json(messages);
    assert.equal(instantActions.length, messages === "revised.json" ? 1 : 0);
    for (const { zoneSet } of zoneSets)
      assert.deepEqual(zoneSet.zones.filter((zone) => zone.zoneType === "BLOCKED").map((zone) => zone.vertices.length), [3]);
    for (const [schema, list] of [["order", orders], ["zoneSet", zoneSets], ["instantActions", instantActions]]) {
      const valid = ajv.compile(JSON.parse(readFileSync(join(schemas, `${schema}.schema`), "utf8")));
      for (const message of list) {
        assert.ok(valid(message), JSON.stringify(valid.errors));
        assert.ok(!valid({ ...message, serialNumber: 1 }));
      }
    }
  });
}

const topic = (name) => `field/v2/waybreaker/ground/${name}`;

// In the words of version 2.0: what 3.0 has left out or calls by another name.
const order2 = (order) => ({
  ...order,
  version: "2.0.0",
  edges: order.edges.map(({ maximumSpeed, ...edge }, i) =>
    ({ ...edge, maxSpeed: maximumSpeed, startNodeId: order.nodes[i].nodeId, endNodeId: order.nodes[i + 1].nodeId })),
});

const actions2 = ({ actions, ...message }) => ({ ...message, version: "2.0.0", instantActions: actions });

const baseOf = (order) => order.nodes.filter((node) => node.released);

let broker;
let fleet;
let vehicle;
let states = [];

// The first state from now on that is as wanted.
const reported = async (wanted) => {
  for (const start = Date.now(); Date.now() - start < 20000; await new Promise((again) => setTimeout(again, 10))) {
    const state = states.find(wanted);
    if (state) return state;
  }
  assert.fail(`the vehicle ends with ${JSON.stringify(states.at(-1))}`);
};

const send = (name, message) => {
  states = [];
  fleet.publish(topic(name), JSON.stringify(message));
};

const freePort = () => new Promise((resolve) => {
  const server = net.createServer().listen(0, "127.0.0.1", () => {
    const { port } = server.address();
    server.close(() => resolve(port));
  });
});

before(async () => {
  const port = await freePort();
  writeFileSync(file("broker.conf"), `listener ${port} 127.0.0.1\nallow_anonymous true\n`);
  broker = spawn("mosquitto", ["-c", file("broker.conf")], { stdio: "ignore" });
  const brokerUrl = `mqtt://127.0.0.1:${port}`;
  fleet = mqtt.connect(brokerUrl, { reconnectPeriod: 50 });
  await new Promise((connected) => fleet.once("connect", connected));
  fleet.on("message", (_, text) => states.push(JSON.parse(text)));
  await new Promise((subscribed) => fleet.subscribe(topic("state"), subscribed));

  const { x, y, mapId } = json("orders.json").orders[0].nodes[0].nodePosition;
  vehicle = new vda5050.AgvController(
    { manufacturer: "waybreaker", serialNumber: "ground" },
    { interfaceName: "field", transport: { brokerUrl }, vdaVersion: "2.0.0" },
    { agvAdapterType: vda5050.VirtualAgvAdapter, publishVisualizationInterval: 0 },
    {
      initialPosition: { mapId, x, y, theta: 0, lastNodeId: "start" },
      vehicleSpeed: 100,
      tickRate: 50,
      timeLapse: 300,
    });
  await vehicle.start();
});

after(async () => {
  await vehicle?.stop();
  fleet?.end(true);
  broker?.kill();
});

// Sends an order and waits until the vehicle has driven its base. It must stop there.
const driven = async (order) => {
  send("order", order2(order));
  const end = baseOf(order).at(-1);
  const state = await reported((one) => one.orderId === order.orderId && one.orderUpdateId === order.orderUpdateId &&
    one.lastNodeSequenceId === end.sequenceId && !one.driving);
  assert.deepEqual(states.flatMap((one) => one.errors), []);
  assert.equal(state.lastNodeId, end.nodeId);
  assert.equal(state.nodeStates.length, order.nodes.length - baseOf(order).length);
  return state;
};

const expectAt = ({ agvPosition }, { nodePosition }) => {
  const centimetre = 0.01;
  assert.ok(Math.hypot(agvPosition.x - nodePosition.x, agvPosition.y - nodePosition.y) < centimetre);
};

test("a vehicle that is not ours drives up to the opening, and takes the revision from there", async () => {
  const { orders } = json("orders.json");
  assert.ok(orders.length > 1);
  expectAt(await driven(orders[0]), baseOf(orders[0]).at(-1));

  // An update that does not begin where the base ends is none.
  send("order", order2({ ...orders[1], nodes: orders[1].nodes.slice(1), edges: orders[1].edges.slice(1) }));
  await reported((state) => state.errors.length > 0);

  const revised = json("revised.json");
  send("instantActions", actions2(revised.instantActions[0]));
  const idle = await reported((state) => state.actionStates.some((action) => action.actionStatus === "FINISHED"));
  const first = revised.orders[0];
  assert.notEqual(first.orderId, orders[0].orderId);
  expectAt(idle, first.nodes[0]);
  let state;
  for (const order of revised.orders) state = await driven(order);
  assert.equal(state.nodeStates.length, 0);
  expectAt(state, revised.orders.at(-1).nodes.at(-1));
});
