// watch.mjs MODULES SLACKWATER SCENARIO LOG SEEN: viewers of @foxglove/ws-protocol watch `slackwater live SCENARIO --viewer-port`,
// one under each name of the protocol. What @foxglove/cdr reads in the odometry goes to SEEN as [[vehicle, time, [x, y, z]], ...].
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";

const [modules, slackwater, scenario, log, seenFile] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { CdrReader } = require("@foxglove/cdr");
const { WebSocket } = require("ws");

const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const VEHICLES = ["rov", "usv"];
const ENOUGH = 100; // of each, five seconds of the run

const options = ["--viewer-port", "0", "--real-time-factor", "2", "--out", log];
const run = spawn(slackwater, ["live", scenario, ...options], { stdio: ["ignore", "ignore", "pipe"] });
process.on("exit", () => run.kill("SIGKILL"));
const ended = new Promise((done) => run.on("exit", (code) => done(code)));
const url = await new Promise((found) => {
  createInterface({ input: run.stderr }).on("line", (line) => {
    console.log(line);
    const match = /^viewers: (ws:\S+)/.exec(line);
    if (match) found(match[1]);
  });
});

/** The fields of nav_msgs/msg/Odometry up to the place, one after the other. */
function placeIn(data) {
  const cdr = new CdrReader(data);
  const stamp = BigInt(cdr.int32()) * 1000000000n + BigInt(cdr.uint32());
  const frame = cdr.string();
  const child = cdr.string();
  return { stamp, frame, child, position: [cdr.float64(), cdr.float64(), cdr.float64()] };
}

async function watchAs(protocol) {
  const ws = new WebSocket(url, [protocol]);
  const client = new FoxgloveClient({ ws });
  const channels = new Map();
  const messages = [];
  let info, times = 0;
  client.on("serverInfo", (it) => (info = it));
  client.on("advertise", (list) => list.forEach((channel) => channels.set(channel.topic, channel)));
  client.on("time", () => ++times);
  client.on("message", (message) => messages.push(message));
  const until = async (condition, what) => {
    for (let i = 0; i < 3000 && !condition(); ++i) await sleep(10);
    assert(condition(), `${what} did not come`);
  };
  const wanted = VEHICLES.flatMap((vehicle) =>
    ["odometry", "pose", "battery_state", "imu", "mission_state", "active_waypoints"].map((what) => `/${vehicle}/${what}`));
  await until(() => [...wanted, "/clock"].every((topic) => channels.has(topic)), `channels ${wanted}, of ${[...channels.keys()]},`);
  assert.equal(ws.protocol, protocol);
  assert.equal(info.name, "Driven from outside");
  const of = new Map();
  for (const vehicle of VEHICLES) {
    const channel = channels.get(`/${vehicle}/odometry`);
    assert.deepEqual([channel.schemaName, channel.encoding, channel.schemaEncoding], ["nav_msgs/msg/Odometry", "cdr", "ros2msg"]);
    of.set(client.subscribe(channel.id), vehicle);
  }
  const count = (vehicle) => messages.filter((message) => of.get(message.subscriptionId) === vehicle).length;
  await until(() => VEHICLES.every((vehicle) => count(vehicle) >= ENOUGH), "the odometry");
  assert(times > 0, "the clock");
  client.close();
  return messages.map((message) => {
    const vehicle = of.get(message.subscriptionId);
    const { stamp, frame, child, position } = placeIn(message.data);
    assert.equal(stamp, message.timestamp);
    assert.deepEqual([frame, child], ["map", `${vehicle}/base_link`]);
    return [vehicle, Number(stamp / 1000n) / 1e6, position];
  });
}

const seen = (await Promise.all([FoxgloveClient.SUPPORTED_SUBPROTOCOL, "foxglove.sdk.v1"].map(watchAs))).flat();
run.kill("SIGINT");
assert.equal(await ended, 0);
writeFileSync(seenFile, JSON.stringify(seen));
