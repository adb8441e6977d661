// hands_page.mjs MODULES ADDRESS WORK: the page of hands of the session at ADDRESS, in Chromium, under its own policy. Its detector
// finds drawn hands whose 21 landmarks are known; then such a hand before a webcam turns the camera of a vehicle.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { FakeWebcam, planes_of } from "./hands/fake_webcam.mjs";

const [modules, address, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const LIMIT_MS = 60000; // one picture takes 3 s with SwiftShader on a quiet machine
const [WIDE, HIGH] = [320, 240];

const STRAIGHT = [0, 0, 0, 0, 0];
const REST = { x_m: 0, y_m: 0, away_m: 0.45, roll_deg: 0, yaw_deg: 0, pitch_deg: 0, curl_deg: STRAIGHT };
const OPEN = { ...REST };
const FIST = { ...REST, curl_deg: [30, 75, 75, 75, 75] };
const PINCH = { ...REST, curl_deg: [10, 45, 15, 10, 10], pinch: true };
const TWO = { ...REST, curl_deg: [40, 0, 0, 75, 75] };
/** Name, pose, is a left hand, what the page is to make of it. */
let LOOKS = [
  ["a left hand, moved and turned", { ...OPEN, x_m: -0.06, y_m: 0.03, roll_deg: 20, yaw_deg: 20 }, true, "open"],
  ["a pinch, far", { ...PINCH, x_m: 0.08, y_m: -0.04, away_m: 0.6 }, false, "pinch"],
  ["two fingers apart", { ...TWO, apart_deg: 20, roll_deg: -15 }, false, "two"],
  ["two fingers together", { ...TWO, apart_deg: -10 }, false, "two"],
  ["a fist", FIST, false, "fist"],
];
if (process.env.SLACKWATER_MORE_HANDS) {
  const shapes = [["open", OPEN], ["pinch", PINCH], ["two", TWO], ["fist", FIST]];
  LOOKS = shapes.flatMap(([shape, pose]) =>
    [[-25, 0, 0], [0, 25, 0], [0, -25, 0], [25, 0, 10], [0, 0, -15]].flatMap(([roll_deg, yaw_deg, pitch_deg]) =>
      [[0, 0, 0.4, false], [-0.08, 0.04, 0.6, true]].map(([x_m, y_m, away_m, is_left]) =>
        [`${shape} ${roll_deg} ${yaw_deg} ${pitch_deg} at ${away_m} m`, { ...pose, roll_deg, yaw_deg, pitch_deg, x_m, y_m, away_m }, is_left, shape])));
}

const webcam = new FakeWebcam(join(work, "webcam.y4m"), WIDE, HIGH);
const browser = await require("puppeteer-core").launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  userDataDir: join(work, "browser"),
  args: ["--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader", "--disable-gpu-compositing",
    "--disable-accelerated-2d-canvas", "--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream",
    `--use-file-for-fake-video-capture=${webcam.file}`],
  protocolTimeout: 4 * LIMIT_MS,
});
const faults = [];
const abroad = [];
function watch(page, name) {
  page.on("pageerror", (error) => faults.push(`${name} throws: ${error.message}`));
  page.on("request", (it) => {
    const is_ours = it.url().startsWith(`${address}/`) || /^(data|about|blob):/.test(it.url());
    if (!is_ours || !["GET", "HEAD"].includes(it.method())) abroad.push(`${name}: ${it.method()} ${it.url()}`);
  });
}
async function fail(what, error) {
  console.log(`FAILED: ${what}: ${error.message}`);
  for (const page of await browser.pages())
    console.log(`${page.url()}: ${await page.evaluate(() => document.body.innerText.slice(0, 600)).catch(String)}`);
  process.kill(-browser.process().pid, "SIGKILL");
  process.exit(1);
}
async function reads(page, at, pattern, limit_ms = LIMIT_MS) {
  const read = (at, pattern) => {
    const text = document.querySelector(at)?.textContent ?? "";
    return new RegExp(pattern).test(text) && text;
  };
  const found = await page.waitForFunction(read, { timeout: limit_ms, polling: 50 }, at, pattern.source).catch(async () => {
    throw new Error(`${at} reads "${await page.$eval(at, (it) => it.textContent).catch(String)}", not ${pattern}`);
  });
  return found.jsonValue();
}
const press = (page, text) =>
  page.waitForFunction((text) => {
    const button = [...document.querySelectorAll("button")].find((it) => it.textContent === text && it.offsetParent && !it.disabled);
    button?.click();
    return Boolean(button);
  }, { timeout: LIMIT_MS, polling: 50 }, text);

let drawing, session, hands;
let took_ms = 0;
const draw = (pose, is_left = false) => drawing.evaluate((pose, is_left) => draw(pose, is_left), pose, is_left);
async function show(pose) {
  const { truth, rgba } = await draw(pose);
  webcam.show(planes_of(Buffer.from(rgba, "base64"), WIDE, HIGH));
  return truth;
}
/** Until the window of hands has looked at so many pictures more. */
async function pictures(count) {
  const until = (await hands.evaluate(() => picturesSeen)) + count;
  await hands.waitForFunction((until) => picturesSeen >= until, { timeout: 2 * LIMIT_MS, polling: 20 }, until);
}
const orders = () => session.evaluate(() => window.cameraOrders);

const steps = {
  async "hands are drawn, with their true landmarks"() {
    drawing = await browser.newPage();
    await drawing.setContent("<!doctype html><title>drawing</title>");
    await drawing.addScriptTag({ path: join(work, "drawn_hands.js") });
    const glb = readFileSync(new URL("hands/right_hand.glb", import.meta.url)).toString("base64");
    await drawing.evaluate((glb) => load(glb), glb);
    const { truth } = await draw(OPEN);
    assert.equal(truth.length, 21);
    // By the law of the pinhole: 45 degrees high, the model's palm 92 mm long.
    const size = await drawing.evaluate((landmarks) => size_of({ landmarks }), truth);
    const expected = 0.0917 / (2 * 0.45 * Math.tan(Math.PI / 8));
    assert(Math.abs(size - expected) < 0.03 * expected, `${size}, expected ${expected}`);
    return `a palm of ${(size * HIGH).toFixed(1)} px`;
  },

  async "the page asks for nothing of its own accord, and its policy is its own"() {
    hands = await browser.newPage();
    watch(hands, "the page of hands");
    await hands.evaluateOnNewDocument(() => {
      window.cameraAsked = 0;
      const ask = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
      navigator.mediaDevices.getUserMedia = (...given) => (++window.cameraAsked, ask(...given));
    });
    const answer = await hands.goto(`${address}/session/hands`);
    await hands.waitForFunction(() => document.querySelector("button")?.disabled === false, { timeout: LIMIT_MS });
    assert.equal(await hands.evaluate(() => cameraAsked), 0);
    const policy = answer.headers()["content-security-policy"];
    assert(policy.includes("script-src 'self' 'wasm-unsafe-eval';"), policy);
    const other = await hands.evaluate(async () => (await fetch("/session")).headers.get("content-security-policy"));
    assert(!other.includes("wasm"), other);
    return policy;
  },

  async "without the detector's files it says so, and cannot be started"() {
    const without = await browser.newPage();
    await without.setRequestInterception(true);
    without.on("request", (it) => void (it.url().includes("/hands/model/") ? it.respond({ status: 404 }) : it.continue()));
    await without.goto(`${address}/session/hands`);
    const said = await reads(without, ".problem", /^This server has no detector of hands: /);
    assert.equal(await without.$eval("button", (it) => it.disabled), true);
    await without.close();
    return said;
  },

  async "it has no fault that axe-core knows, by day, dusk and night"() {
    await hands.evaluate(axe);
    let passes = 0;
    for (const palette of ["day", "dusk", "night"]) {
      await hands.evaluate((palette) => (document.documentElement.dataset.palette = palette), palette);
      const found = await hands.evaluate(async () => {
        const { violations, passes } = await axe.run(document);
        return { faults: violations.map((it) => `${it.id}: ${it.nodes.map((n) => n.target)}`), passes: passes.length };
      });
      assert.deepEqual(found.faults, [], palette);
      passes += found.passes;
    }
    return `${passes} rules pass`;
  },

  async "the detector finds drawn hands where they are"() {
    await hands.evaluate(async () => {
      const script = document.createElement("script");
      script.src = "/session/hands/model/hands.js";
      await new Promise((done, failed) => ((script.onload = done), (script.onerror = failed), document.head.append(script)));
      const detector = new window.Hands({ locateFile: (name) => `/session/hands/model/${name}` });
      detector.setOptions({ maxNumHands: 1, modelComplexity: 0, minDetectionConfidence: 0.6, minTrackingConfidence: 0.6 });
      let found;
      detector.onResults((it) => void (found = it));
      await detector.initialize();
      window.detect = async (picture) => {
        const image = new Image();
        image.src = picture;
        await image.decode();
        const began_ms = performance.now();
        await detector.send({ image });
        const wide = image.naturalWidth / image.naturalHeight;
        return {
          took_ms: performance.now() - began_ms,
          hands: found.multiHandLandmarks.map((it, i) => ({
            landmarks: it.map(({ x, y }) => ({ x: x * wide, y })),
            sureness: found.multiHandedness[i].score,
          })),
        };
      };
      window.endDetector = () => detector.close();
    });
    const empty = await draw(null);
    const none = await hands.evaluate((it) => detect(it), empty.picture);
    assert.equal(none.hands.length, 0, "a hand on an empty wall");
    const rows = [];
    for (const [name, pose, is_left, shape] of LOOKS) {
      const { truth, picture } = await draw(pose, is_left);
      const seen = await hands.evaluate((it) => detect(it), picture);
      took_ms = seen.took_ms;
      await hands.evaluate((it) => detect(it), empty.picture); // so that the next is not looked for where this one was
      assert.equal(seen.hands.length, 1, `${name}: ${seen.hands.length} hands`);
      const [hand] = seen.hands;
      const size = await drawing.evaluate((landmarks) => size_of({ landmarks }), truth);
      const off = truth.map(({ x, y }, i) => Math.hypot(x - hand.landmarks[i].x, y - hand.landmarks[i].y) / size);
      off.sort((a, b) => a - b);
      const meant = await drawing.evaluate((hand) => shape_of(hand, "other"), hand);
      const [spread, true_spread] = await drawing.evaluate((a, b) => [spread_of(a), spread_of({ landmarks: b })], hand, truth);
      // In sizes of the hand: the zoom is at rest from 0.28 to 0.52.
      if (shape === "two") assert(Math.abs(spread - true_spread) < 0.1, `${name}: fingers ${spread} apart, not ${true_spread}`);
      rows.push({ name, median: off[10], worst: off[20], is_sure: hand.sureness > 0.7, is_meant: meant === shape, meant, spread });
    }
    // Another comes: the first is followed.
    const first = await draw({ ...OPEN, x_m: 0.1 });
    await hands.evaluate((it) => detect(it), first.picture);
    const both = await drawing.evaluate((pose) => draw(pose, false, true), { ...OPEN, x_m: 0.1 });
    const followed = await hands.evaluate((it) => detect(it), both.picture);
    assert.equal(followed.hands.length, 1);
    const [knuckle, found] = [first.truth[9], followed.hands[0].landmarks[9]];
    assert(Math.abs(knuckle.x - found.x) < 0.1, `it follows the other: ${found.x}, not ${knuckle.x}`);
    await hands.evaluate(() => endDetector());
    if (!process.env.SLACKWATER_MORE_HANDS) {
      const [apart, together] = rows.filter((it) => it.meant === "two").map((it) => it.spread);
      assert(apart > 0.52 && together < 0.28, `apart ${apart}, together ${together}`);
    }
    const medians = rows.map((it) => it.median).sort((a, b) => a - b);
    const text = rows.map((it) => `${it.name}: median ${(100 * it.median).toFixed(1)} %, worst ${(100 * it.worst).toFixed(0)} %, ${it.meant}`);
    console.log(text.map((it) => `  ${it}`).join("\n"));
    assert(medians[medians.length >> 1] < 0.07, `median ${medians[medians.length >> 1]} of the hand over all`);
    for (const it of rows) {
      // Knuckles and wrist of the model are not quite where the detector's teachers had them; and a fist seen askance hides most.
      assert(it.median < 0.13, `${it.name}: median ${it.median} of the hand`);
      assert(it.worst < 0.35, `${it.name}: worst ${it.worst} of the hand`);
    }
    const good = rows.filter((it) => it.is_meant && it.is_sure).length;
    assert(good >= (process.env.SLACKWATER_MORE_HANDS ? 0.9 : 1) * rows.length, `${good} of ${rows.length} are taken for what they are`);
    return `median error ${(100 * medians[medians.length >> 1]).toFixed(1)} % of the hand, ${good} of ${rows.length} shapes right, ${took_ms.toFixed(0)} ms a picture`;
  },

  async "an operator takes the helm and opens the window of hands"() {
    await hands.close();
    session = await browser.newPage();
    watch(session, "the session's page");
    await session.setViewport({ width: 1000, height: 600 });
    await session.evaluateOnNewDocument(() => {
      window.cameraOrders = [];
      const send = WebSocket.prototype.send;
      WebSocket.prototype.send = function (data) {
        const said = JSON.parse(data);
        if (said.do === "camera") window.cameraOrders.push(said);
        return send.call(this, data);
      };
    });
    await session.goto(`${address}/session`);
    await session.waitForSelector("form.join option", { timeout: LIMIT_MS });
    await session.type("form.join input[type=text]", "Ann");
    await session.type("form.join input[type=password]", "ann-0123456789abcdef");
    await session.click("form.join button[type=submit]");
    await press(session, "Ask for the helm");
    await reads(session, ".helm-state", /^You drive/);
    await reads(session, ".camera .note", /^Looks straight ahead, level/);
    const opened = new Promise((done) => browser.once("targetcreated", (it) => done(it.page())));
    await press(session, "By hand");
    hands = await opened;
    watch(hands, "the window of hands");
    // Its clock goes so slowly that this machine is as quick as one with a graphics card: a picture in 0.05 to 0.15 s. So what is shown here holds
    // for such a machine; that a slow one asks for nothing is in tests/api/web/hands. What it says of its pictures is by the clock of all windows:
    // their age by its own clock, before now.
    await hands.evaluateOnNewDocument((slower) => {
      const now = performance.now.bind(performance);
      const origin_ms = performance.timeOrigin;
      performance.now = () => now() / slower;
      Object.defineProperty(performance, "timeOrigin", { get: () => origin_ms + now() - now() / slower });
      window.picturesSeen = 0; // each is drawn once it was looked at
      const draw = CanvasRenderingContext2D.prototype.drawImage;
      CanvasRenderingContext2D.prototype.drawImage = function (...given) {
        ++window.picturesSeen;
        return draw.apply(this, given);
      };
    }, Math.max(took_ms, 500) / 50);
    await hands.reload();
    assert.equal(await hands.evaluate(() => window.opener), null);
    assert.equal(await session.evaluate(() => document.hidden), false, "the session's page is hidden");
    return await hands.evaluate(() => document.title);
  },

  async "a pinch moved to the person's right turns the camera to starboard, as fast as it is far"() {
    const from = await show({ ...PINCH, x_m: 0.04 });
    await press(hands, "Start the camera");
    await reads(hands, ".seen", /^Pinch/, 2 * LIMIT_MS);
    await reads(hands, ".answer", /^Ready/);
    await pictures(2); // it is meant in its second picture; a third makes sure
    assert.equal(await hands.$eval(".asked", (it) => it.textContent), "Nothing is asked.");
    assert.deepEqual(await orders(), []);
    // Who does nothing with the helm for a minute has given it back; this machine may have needed that long.
    if (await session.evaluate(() => !/^You drive/.test(document.querySelector(".helm-state").textContent))) {
      await press(session, "Ask for the helm");
      await reads(session, ".helm-state", /^You drive/);
    }
    // Step by step: a hand that leaps is lost for a picture, and then is at rest where it is found.
    let to;
    for (const x_m of [0.02, 0, -0.02, -0.04]) {
      to = await show({ ...PINCH, x_m });
      await pictures(2);
    }
    const [size, a, b] = await drawing.evaluate(
      (from, to) => [size_of({ landmarks: from }), pinch_point({ landmarks: from }), pinch_point({ landmarks: to })], from, to);
    const palms = (a.x - b.x) / size; // the picture's left is the person's right
    const expected_deg_s = 20 * Math.min(Math.max(palms - 0.2, 0), 1);
    await pictures(4); // smoothed, and risen
    const asked = await reads(hands, ".asked", /^Asked: [\d.]+°\/s to starboard\.$/, 2 * LIMIT_MS);
    const asked_deg_s = Number(asked.match(/[\d.]+/)[0]);
    // Where the detector is off by 5 % of the hand at both ends and in its size the rate is off by 3 degrees a second.
    assert(Math.abs(asked_deg_s - expected_deg_s) < 3, `${asked_deg_s} degrees a second, by the drawn hand ${expected_deg_s}`);
    await reads(session, ".camera .note", /^Looks [1-9]\d*(\.\d+)?° to starboard, level/);
    const sent = await orders();
    assert(sent.length > 0 && sent.every((it, i) => it.pan_deg > (sent[i - 1]?.pan_deg ?? 0) && it.tilt_deg === 0 && it.zoom === 1), JSON.stringify(sent));
    return `${asked_deg_s} degrees a second asked, by the drawn hand ${expected_deg_s.toFixed(1)}; ${sent.length} orders to ${sent.at(-1).pan_deg.toFixed(1)} degrees`;
  },

  async "a hand that is gone stops it"() {
    await show(null);
    await reads(hands, ".seen", /^No hand/);
    const before = (await orders()).length;
    await reads(hands, ".asked", /^Nothing/);
    await new Promise((done) => setTimeout(done, 2000));
    assert.equal((await orders()).length, before);
    return `after ${before} orders no other`;
  },

  async "a window that is closed in the middle of a pinch stops it"() {
    await show({ ...PINCH, x_m: 0.04 });
    await reads(hands, ".seen", /^Pinch/, 2 * LIMIT_MS);
    await pictures(3);
    for (const x_m of [0.02, 0, -0.02, -0.04]) {
      await show({ ...PINCH, x_m });
      await pictures(2);
    }
    const from = (await orders()).length;
    await session.waitForFunction((from) => cameraOrders.length > from, { timeout: 2 * LIMIT_MS, polling: 20 }, from);
    await hands.close();
    await new Promise((done) => setTimeout(done, 600)); // 0.3 s, and the order that was on its way
    const count = (await orders()).length;
    await new Promise((done) => setTimeout(done, 2000));
    assert.equal((await orders()).length, count, "orders without a window");
    const opened = new Promise((done) => browser.once("targetcreated", (it) => done(it.page())));
    await press(session, "By hand");
    hands = await opened;
    watch(hands, "the second window of hands");
    await press(hands, "Start the camera");
    await hands.waitForFunction(() => !document.querySelector("canvas").hidden, { timeout: LIMIT_MS });
    return `after ${count} orders no other`;
  },

  async "stopped, the camera is off"() {
    await press(hands, "Stop the camera");
    const isOff = () => document.querySelector("canvas").hidden && document.querySelector(".asked").textContent === "";
    await hands.waitForFunction(isOff, { timeout: LIMIT_MS });
  },

  async "nothing went elsewhere, nothing was sent, nothing threw"() {
    assert.deepEqual(abroad, []);
    assert.deepEqual(faults, []);
  },
};

for (const [what, step] of Object.entries(steps)) {
  const began_ms = Date.now();
  const said = await step().catch((error) => fail(what, error));
  console.log(`${what} (${((Date.now() - began_ms) / 1000).toFixed(1)} s)${said ? `: ${said}` : ""}`);
}
await browser.close();
