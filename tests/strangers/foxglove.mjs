// foxglove.mjs MODULES MADE_UP: a viewer built of other people's parts (@foxglove/ws-protocol, rosmsg, rosmsg2-serialization, cdr;
// ws) watches the broadcast of the program MADE_UP: under both names of the protocol it sees the channels, decodes what they say
// by the schemas they advertise, and finds the numbers that belong to their times.
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";

const [modules, program] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { CdrReader } = require("@foxglove/cdr");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");
const { WebSocket } = require("ws");

const FIRST_NS = 1741590000000000000n;
const STEP_NS = 50000000n;
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

const made = spawn(program, [], { stdio: ["pipe", "pipe", "inherit"] });
const lines = createInterface({ input: made.stdout })[Symbol.asyncIterator]();
const ended = new Promise((done) => made.on("exit", done));
const { port } = JSON.parse((await lines.next()).value);
const url = `ws://127.0.0.1:${port}/live`;
const figures = async () => (await fetch(`http://127.0.0.1:${port}/figures`)).json();

/** A viewer: what has come in so far, by kind; `next` waits for more of it. */
class Viewer {
  constructor(protocols) {
    this.ws = new WebSocket(url, protocols);
    this.client = new FoxgloveClient({ ws: this.ws });
    this.channels = new Map();
    this.statuses = [];
    this.messages = [];
    this.times = [];
    this.errors = [];
    this.client.on("serverInfo", (info) => (this.info = info));
    this.client.on("advertise", (list) => list.forEach((channel) => this.channels.set(channel.topic, channel)));
    this.client.on("status", (status) => this.statuses.push(status));
    this.client.on("message", (message) => this.messages.push(message));
    this.client.on("time", (time) => this.times.push(time.timestamp));
    this.client.on("error", (error) => this.errors.push(error));
  }
  async until(condition, what) {
    for (let i = 0; i < 1000 && !condition(); ++i) await sleep(10);
    assert(condition(), `${what} did not come; ${this.errors}`);
  }
  async opened() {
    await this.until(() => this.channels.size > 0, "the list of channels");
    return this;
  }
  subscribe(topic) {
    return this.client.subscribe(this.channels.get(topic).id);
  }
  of(subscription) {
    return this.messages.filter((message) => message.subscriptionId === subscription);
  }
  async close() {
    const closed = new Promise((done) => this.client.on("close", done));
    this.client.close();
    return closed;
  }
}

/** Decodes by the schema that was advertised, as viewers do. */
function readerOf(channel) {
  assert.equal(channel.encoding, "cdr");
  assert.equal(channel.schemaEncoding, "ros2msg");
  return new MessageReader(parse(channel.schema, { ros2: true }));
}

function numberOf(message) {
  const since = message.timestamp - FIRST_NS;
  assert.equal(since % STEP_NS, 0n);
  return Number(since / STEP_NS);
}

function checkWind(reader, message) {
  assert.equal(reader.readMessage(message.data).data, 0.25 * numberOf(message));
}

function checkFlow(reader, message) {
  const n = numberOf(message);
  const { header, vector } = reader.readMessage(message.data);
  assert.equal(BigInt(header.stamp.sec) * 1000000000n + BigInt(header.stamp.nanosec), message.timestamp);
  assert.equal(header.frame_id, "harbour");
  assert.deepEqual({ ...vector }, { x: n, y: -0.5 * n, z: Math.sqrt(n) });
}

function checkUnbroken(messages) {
  messages.forEach((message, i) => assert.equal(numberOf(message), numberOf(messages[0]) + i, "a message is missing"));
}

async function watchAs(protocol) {
  const viewer = await new Viewer([protocol]).opened();
  assert.equal(viewer.ws.protocol, protocol);
  assert.equal(viewer.info.name, "made up");
  assert.deepEqual(viewer.info.capabilities, ["time"]);
  assert.deepEqual([...viewer.channels.keys()].sort(), ["/rov/flow", "/site/depth", "/sonar/picture", "/wind/speed"]);
  assert.equal(viewer.channels.get("/rov/flow").schemaName, "geometry_msgs/msg/Vector3Stamped");
  assert.equal(viewer.messages.length, 0, "nothing was asked for yet");
  const wind = viewer.subscribe("/wind/speed");
  const flow = viewer.subscribe("/rov/flow");
  const from = Date.now();
  await viewer.until(() => viewer.of(flow).length >= 20 && viewer.of(wind).length >= 20, "a second of messages");
  const took_ms = Date.now() - from;
  assert(took_ms > 700 && took_ms < 10000, `20 messages at 20 Hz took ${took_ms} ms`);
  const windReader = readerOf(viewer.channels.get("/wind/speed"));
  const flowReader = readerOf(viewer.channels.get("/rov/flow"));
  for (const message of viewer.of(wind)) checkWind(windReader, message);
  for (const message of viewer.of(flow)) checkFlow(flowReader, message);
  checkUnbroken(viewer.of(flow));
  assert(viewer.times.length >= 20 && viewer.times.every((time) => (time - FIRST_NS) % STEP_NS === 0n));
  // The same bytes read field by field.
  const last = viewer.of(flow).at(-1);
  const cdr = new CdrReader(last.data);
  assert.deepEqual([cdr.int32(), cdr.uint32()], [Number(last.timestamp / 1000000000n), Number(last.timestamp % 1000000000n)]);
  assert.deepEqual([cdr.string(), cdr.float64()], ["harbour", numberOf(last)]);
  // And no more once it has enough.
  viewer.client.unsubscribe(wind);
  await sleep(300);
  const enough = viewer.of(wind).length;
  await sleep(300);
  assert.equal(viewer.of(wind).length, enough);
  assert.deepEqual(viewer.statuses, []);
  assert.deepEqual(viewer.errors, []);
  const closed = await viewer.close();
  assert.equal(closed.wasClean, true);
  return viewer.of(flow).length;
}

async function chooseProtocols() {
  const both = await new Viewer(["somebody.else.v7", "foxglove.sdk.v1", "foxglove.websocket.v1"]).opened();
  assert.equal(both.ws.protocol, "foxglove.sdk.v1", "the first of the client's list that is known");
  await both.close();
  const refused = new WebSocket(url, ["somebody.else.v7"]);
  const answer = await new Promise((done) => {
    refused.on("unexpected-response", (_, response) => done(response));
    refused.on("error", () => {});
  });
  assert.equal(answer.statusCode, 400);
  let text = "";
  for await (const piece of answer) text += piece;
  assert.match(JSON.parse(text).detail, /somebody\.else\.v7.*foxglove\.websocket\.v1, foxglove\.sdk\.v1/);
}

async function comeLate() {
  const viewer = await new Viewer(["foxglove.websocket.v1"]).opened();
  const depth = viewer.subscribe("/site/depth");
  await viewer.until(() => viewer.of(depth).length === 1, "what was said before anybody came");
  const [message] = viewer.of(depth);
  assert.equal(readerOf(viewer.channels.get("/site/depth")).readMessage(message.data).data, 35.5);
  assert.equal(message.timestamp, FIRST_NS);
  await viewer.close();
}

async function tryToWrite() {
  const viewer = await new Viewer(["foxglove.sdk.v1"]).opened();
  const attempts = [
    () => viewer.client.advertise({ topic: "/cmd", encoding: "cdr", schemaName: "std_msgs/msg/Float64" }),
    () => viewer.client.sendMessage(1, new Uint8Array([0, 1, 0, 0])),
    () => viewer.client.setParameters([{ name: "speed", value: 3 }]),
    () => viewer.client.subscribeConnectionGraph(),
    () => viewer.client.fetchAsset("package://rov/hull.stl", 1),
    () =>
      viewer.client.sendServiceCallRequest({ serviceId: 1, callId: 1, encoding: "cdr", data: new DataView(new ArrayBuffer(4)) }),
  ];
  for (const [i, attempt] of attempts.entries()) {
    attempt();
    await viewer.until(() => viewer.statuses.length === i + 1, `an answer to ${attempt}`);
    assert.equal(viewer.statuses[i].level, 1);
    assert.match(viewer.statuses[i].message, /read-only/);
  }
  viewer.client.subscribe(4711);
  viewer.ws.send("{no JSON");
  await viewer.until(() => viewer.statuses.length === attempts.length + 2, "answers to nonsense");
  assert(viewer.statuses.slice(-2).every((status) => status.level === 2));
  const flow = viewer.subscribe("/rov/flow");
  await viewer.until(() => viewer.of(flow).length > 0, "messages after all that");
  await viewer.close();
}

/** One client takes nothing in for some seconds, while eight megabytes a second are meant for it. */
async function stopReading() {
  const other = await new Viewer(["foxglove.websocket.v1"]).opened();
  const flow = other.subscribe("/rov/flow");
  const deaf = await new Viewer(["foxglove.websocket.v1"]).opened();
  const picture = deaf.subscribe("/sonar/picture");
  await deaf.until(() => deaf.of(picture).length > 5, "the first pictures");
  deaf.ws.pause();
  await sleep(2000);
  const before = await figures();
  const seen = other.of(flow).length;
  await sleep(4000);
  const after = await figures();
  const kept = other.of(flow).length - seen;
  const grown_mb = (after.resident_bytes - before.resident_bytes) / 1e6;
  const dropped = after.dropped - before.dropped;
  assert(dropped >= 60, `dropped ${dropped} pictures of 80`);
  assert(grown_mb < 4, `the server has grown by ${grown_mb} MB`);
  assert(kept > 70, `the other client got ${kept} messages of 80`);
  checkUnbroken(other.of(flow));
  const known = deaf.of(picture).length;
  deaf.ws.resume();
  await deaf.until(() => deaf.of(picture).length > known + 30, "pictures after the pause");
  const numbers = deaf.of(picture).map(numberOf);
  assert(numbers.every((n, i) => i === 0 || n > numbers[i - 1]), "in their order");
  assert(Number((other.times.at(-1) - FIRST_NS) / STEP_NS) - numbers.at(-1) < 10, "up to date again");
  await deaf.close();
  await other.close();
  return `dropped ${dropped}, the other lost none of ${kept}, the server grew by ${grown_mb.toFixed(1)} MB`;
}

let count = 0;
for (const protocol of [FoxgloveClient.SUPPORTED_SUBPROTOCOL, "foxglove.sdk.v1"]) count += await watchAs(protocol);
await chooseProtocols();
await comeLate();
await tryToWrite();
const deafness = await stopReading();
const watching = await new Viewer(["foxglove.sdk.v1"]).opened();
const farewell = new Promise((done) => watching.client.on("close", done));
made.stdin.end();
assert.equal((await farewell).code, 1001);
assert.equal(await ended, 0, "the program left clients behind");
console.log(`@foxglove/ws-protocol decodes ${count} messages under both names; a client that stops reading: ${deafness}`);
