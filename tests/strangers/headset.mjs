// headset.mjs MODULES ADDRESS WORK: Ann at a desk, Hal with a headset and Pia with a telephone in the session at ADDRESS, each with
// the page in Chromium as it is (people_in_a_session.mjs).
import { strict as assert } from "node:assert";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { TELEPHONE, telephone_drives } from "./headset_telephone.mjs";
import { endInZero, EYES_M, isZero, moved_m, near, Person, sleep, Wearer } from "./people_in_a_session.mjs";

const [modules, address, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const iwer = readFileSync(join(resolve(modules), "node_modules/iwer/build/iwer.min.js"), "utf8");

const LIMIT_MS = 30000; // generous: sanitizers, two cores
const BED_M = -60; // of the scenario
const AT = { address, iwer, fail };

let ann, hal, pia;
const browsers = [];
async function fail(what, error) {
  console.log(`FAILED: ${what}: ${error.message}`);
  for (const person of [ann, hal, pia].filter(Boolean)) console.log(`${person.name} sees ${await person.shown().catch(String)}`);
  for (const browser of browsers) process.kill(-browser.process().pid, "SIGKILL"); // with its children
  process.exit(1);
}

for (let i = 0; i < 2; ++i) {
  browsers.push(await puppeteer.launch({
    executablePath: process.env.SLACKWATER_BROWSER,
    userDataDir: join(work, `browser${i}`),
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader"],
    timeout: 2 * LIMIT_MS,
  }));
}

const steps = {
  async "ways into the scene are offered where there is a headset, and axe-core finds nothing"() {
    ann = await Person.sitDown("Ann", browsers[0], AT);
    hal = await Wearer.sitDown("Hal", browsers[1], AT, { wears: true });
    await ann.press("Ask for the helm");
    await ann.reads(".helm-state", /^You drive/);
    for (const person of [ann, hal]) await person.press("Scene");
    await sleep(300);
    const offered = (person) => person.page.$$eval(".scene-tools button", (all) =>
      all.filter((it) => !it.hidden && /VR|AR/.test(it.textContent)).map((it) => it.textContent));
    assert.deepEqual(await offered(ann), []);
    assert.deepEqual(await offered(hal), ["Enter VR", "Table (AR)"]);
    await ann.press("Scene"); // two scenes are slow to draw
    await hal.page.setViewport({ width: 640, height: 480 });
    await hal.page.evaluate(axe);
    const faults = await hal.page.evaluate(async () => {
      const found = await axe.run(document, { iframes: false });
      return found.violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.target).join(" ")}`);
    });
    assert.deepEqual(faults, []);
    await hal.page.setViewport({ width: 320, height: 180 }); // SwiftShader is slow
    return "Enter VR, Table (AR)";
  },

  async "VR begins, frames are drawn, both controllers are seen"() {
    const words = await hal.enter("Enter VR", /^In the headset \(VR\): left controller, right controller\.$/);
    const since_ms = await hal.now();
    await hal.change(() => {});
    await hal.says("saw", since_ms);
    const picture = await hal.picture();
    writeFileSync(join(work, "vr.png"), picture);
    assert(picture.length > 5000, `a picture of one colour: ${picture.length} bytes`);
    return words;
  },

  async "a throw with the trigger brings one as far as a ball flies"() {
    const before = await hal.look();
    // 0.4 m before the head, 0.3 m below it, 20 degrees up, straight ahead.
    const [ahead_m, below_m, up_rad] = [0.4, 0.3, Math.PI / 9];
    await hal.aim("right", [0, EYES_M - below_m, -ahead_m], [0, Math.sin(up_rad), -Math.cos(up_rad)]);
    await hal.value("right", "trigger", 1);
    writeFileSync(join(work, "throw.png"), await hal.picture());
    await hal.value("right", "trigger", 0);
    const after = await hal.look();
    const fall_m = before.from.up_m - below_m - BED_M;
    const [up_m_s, level_m_s] = [10 * Math.sin(up_rad), 10 * Math.cos(up_rad)];
    const flies_m = (level_m_s / 9.81) * (up_m_s + Math.sqrt(up_m_s ** 2 + 2 * 9.81 * fall_m));
    // Places are told to the centimetre.
    near(moved_m(before, after), ahead_m + flies_m, 0.03, "moved, m");
    near(after.from.up_m, BED_M + EYES_M, 0.03, "eyes over the bed, m");
    const to_deg = (Math.atan2(after.from.east_m - before.from.east_m, after.from.north_m - before.from.north_m) * 180) / Math.PI;
    near((to_deg - before.heading_deg + 540) % 360, 180, 0.6, "off the way that one looked, degrees");
    return `${moved_m(before, after).toFixed(2)} m, expected ${(ahead_m + flies_m).toFixed(2)} m`;
  },

  async "pointing tells the others what the ray meets"() {
    // 45 degrees down from 1.3 m over the bed, 0.4 m before the head.
    await hal.aim("right", [0, EYES_M - 0.3, -0.4], [0, -1, -1]);
    await hal.value("right", "a-button", 1);
    const { from, point } = await hal.look();
    near(point.up_m, BED_M, 0.02, "pointed at the bed, m");
    near(Math.hypot(point.east_m - from.east_m, point.north_m - from.north_m), 0.4 + 1.3, 0.03, "away on the level, m");
    await hal.value("right", "a-button", 0);
    assert.equal((await hal.look()).point, null);
  },

  async "a push of the stick turns by 30 degrees, once, about the head"() {
    const before = await hal.look();
    await hal.stick("right", 1, 0);
    await hal.change(() => {});
    const turned = await hal.look();
    near((turned.heading_deg - before.heading_deg + 360) % 360, 30, 1, "turned, degrees"); // each is told to a degree
    near(moved_m(before, turned), 0, 0.02, "moved, m");
    await hal.stick("right", 0, 0);
    await hal.stick("right", -1, 0);
    await hal.stick("right", 0, 0);
    near((await hal.look()).heading_deg, before.heading_deg, 1, "turned back, degrees");
    return `${before.heading_deg} to ${turned.heading_deg} degrees`;
  },

  async "without the helm a squeeze sends nothing"() {
    const since_ms = await hal.now();
    await hal.stick("left", 0, -1);
    await hal.value("left", "squeeze", 1);
    await sleep(500);
    await hal.value("left", "squeeze", 0);
    await hal.stick("left", 0, 0);
    assert.deepEqual(await hal.said("stick", since_ms), []);
  },

  async "the helm goes from the desk to the headset: asked for on the board, granted at the desk"() {
    await hal.board("Ask for the helm");
    const hers = await ann.reads(".helm-state", /Hal asks for the helm/);
    await ann.press("Grant");
    await hal.reads(".helm-state", /^You drive/);
    await ann.reads(".helm-state", /^Hal drives/);
    return hers;
  },

  async "squeeze and stick drive through the server, released the vehicle stops"() {
    await hal.page.bringToFront();
    const since_ms = await hal.now();
    await hal.stick("left", 0, -1);
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
    await ann.until("a vehicle that moves", () => parseFloat(document.querySelector(".vehicles tbody td:nth-of-type(3)").textContent) >= 0.2);
    const sticks = (await hal.said("stick", since_ms)).filter((it) => it.velocity[0] > 0.1);
    const longest_ms = Math.max(...sticks.map((it) => it.until - it.at));
    assert(longest_ms <= 400, `a stick is valid for ${longest_ms} ms`);
    const taken = await hal.reads(".taken", /Taken at step \d+/);
    await hal.value("left", "squeeze", 0); // the stick stays where it is
    const released_ms = await hal.now();
    await ann.until("a vehicle at rest", () => parseFloat(document.querySelector(".vehicles tbody td:nth-of-type(3)").textContent) <= 0.05);
    assert(isZero((await hal.said("stick")).at(-1)), "the last stick");
    assert((await hal.said("stick", released_ms)).length <= 1, "more sticks after the release");
    await hal.stick("left", 0, 0);
    return `${sticks.length} sticks; ${taken}`;
  },

  async "HOLD in the middle of a squeeze holds: no stick follows it, not even a zero"() {
    const since_ms = await hal.now();
    await hal.stick("left", 0, -1);
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
    await hal.value("right", "b-button", 1);
    await hal.value("right", "b-button", 0);
    const hold = await hal.says("hold", since_ms);
    await sleep(400);
    assert.deepEqual(await hal.said("stick", hold.at_ms), [], "squeezed on");
    await hal.value("left", "squeeze", 0);
    await sleep(400);
    assert.deepEqual(await hal.said("stick", hold.at_ms), [], "let go");
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", hold.at_ms, (it) => it.velocity[0] > 0.1); // squeezed anew
    await hal.value("left", "squeeze", 0);
    await hal.stick("left", 0, 0);
    return hal.reads(".asked", /^Stick at rest/);
  },

  async "hidden by the system's menu it lets go, and wants a new squeeze"() {
    const since_ms = await hal.now();
    await hal.stick("left", 0, -1);
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
    const before_ms = await hal.now();
    await hal.change(() => device.updateVisibilityState("visible-blurred"));
    const blurred_ms = await hal.now();
    await sleep(500);
    await hal.change(() => device.updateVisibilityState("visible"));
    await sleep(500);
    assert(isZero((await hal.said("stick")).at(-1)), "the last stick");
    endInZero(await hal.said("stick", before_ms), blurred_ms, "under the menu, and after it");
    await hal.value("left", "squeeze", 0);
  },

  async "a controller that is lost in the middle of a squeeze is zero"() {
    const since_ms = await hal.now();
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
    const before_ms = await hal.now();
    await hal.change(() => (device.controllers.left.connected = false));
    const lost_ms = await hal.now();
    await hal.reads(".scene-tools > .note", /^In the headset \(VR\): right controller\.$/);
    await sleep(400);
    await hal.change(() => (device.controllers.left.connected = true));
    await sleep(400);
    assert(isZero((await hal.said("stick")).at(-1)), "the last stick");
    endInZero(await hal.said("stick", before_ms), lost_ms, "without a hand");
    await hal.value("left", "squeeze", 0);
  },

  async "a session that is lost in the middle of a squeeze sends zero, and is entered again"() {
    const since_ms = await hal.now();
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
    const before_ms = await hal.now();
    await hal.page.evaluate(() => device.activeSession.end());
    const lost_ms = await hal.now();
    await hal.until("the buttons", () => [...document.querySelectorAll(".scene-tools button")].some((it) => it.textContent === "Enter VR" && it.offsetParent));
    await sleep(500);
    assert(isZero((await hal.said("stick")).at(-1)), "the last stick");
    endInZero(await hal.said("stick", before_ms), lost_ms, "without a headset");
    // The desk's view is drawn again, where it was.
    const at_desk = await hal.look();
    await hal.enter("Enter VR", /left controller, right controller/);
    await sleep(500);
    endInZero(await hal.said("stick", before_ms), lost_ms, "squeezed since before");
    const in_it = await hal.look();
    for (const axis of ["east_m", "north_m", "up_m"]) near(in_it.from[axis], at_desk.from[axis], 0.05, `begins at the desk's ${axis}`);
    await hal.value("left", "squeeze", 0);
    const again_ms = await hal.now();
    await hal.value("left", "squeeze", 1);
    await hal.says("stick", again_ms, (it) => it.velocity[0] > 0.1);
    await hal.value("left", "squeeze", 0);
    await hal.stick("left", 0, 0);
  },

  async "a headset that is put down gives the desk its view back"() {
    const covers = () => hal.page.$eval(".scene-cover", (it) => !it.hidden && /The scene is in the headset/.test(it.textContent));
    assert.equal(await covers(), true);
    await hal.page.evaluate(() => device.updateVisibilityState("hidden"));
    await hal.until("the buttons", () => [...document.querySelectorAll(".scene-tools button")].some((it) => it.textContent === "Enter VR" && it.offsetParent));
    assert.equal(await covers(), false);
    await hal.page.evaluate(() => device.updateVisibilityState("visible"));
    return hal.enter("Enter VR", /left controller, right controller/);
  },

  async "two hands are drawn with 25 joints each, and a pinched one drives by how far it moved"() {
    await hal.change(() => (device.primaryInputMode = "hand"));
    const words = await hal.reads(".scene-tools > .note", /left hand \(25 joints\), right hand \(25 joints\)/);
    await hal.change(() => {
      device.hands.left.position.set(-0.2, 1.2, -0.4);
      device.hands.right.position.set(0.2, 1.2, -0.4);
    });
    writeFileSync(join(work, "hands.png"), await hal.picture());
    const since_ms = await hal.now();
    await hal.change(() => device.hands.right.updatePinchValue(1));
    const still = await hal.says("stick", since_ms);
    assert(isZero(still), "a pinch that has not moved asks for no way");
    // Ahead 7 cm: half of what is between rest, 2 cm, and full, 12 cm.
    await hal.change(() => device.hands.right.position.set(0.2, 1.2, -0.47));
    await sleep(300);
    const half = (await hal.said("stick")).at(-1).velocity;
    await hal.change(() => device.hands.right.position.set(0.2, 1.2, -0.6));
    await sleep(300);
    const full = (await hal.said("stick")).at(-1).velocity;
    near(half[0] / full[0], 0.5, 0.01, "share of full at 7 cm");
    assert.deepEqual([half.slice(1), full.slice(1)], [[0, 0, 0], [0, 0, 0]]);
    await hal.change(() => device.hands.right.updatePinchValue(0));
    await sleep(300);
    assert(isZero((await hal.said("stick")).at(-1)), "let go, the last stick");
    await hal.change(() => (device.primaryInputMode = "controller"));
    return `${words} ${half[0]} and ${full[0]} m/s`;
  },

  async "on the table, 1:500, a pinch moves a place by what the hand moved, and another chooses a vehicle"() {
    await hal.page.evaluate(() => device.activeSession.end());
    await hal.press("Edit the way");
    const since_ms = await hal.now();
    await hal.press("Add a place");
    const { places: [placed] } = await hal.says("waypoints", since_ms);
    await hal.enter("Table (AR)", /^In the headset \(AR\): left controller, right controller\.$/);
    await hal.change(() => (device.primaryInputMode = "hand"));
    const fingers = () => hal.page.evaluate(() => seen.fingers.right);
    const put = (at) => hal.change((at) => device.hands.right.position.set(...at), at);
    const pinch = (value) => hal.change((value) => device.hands.right.updatePinchValue(value), value);
    const from = [0.5, 1.4, 0];
    await put(from);
    await pinch(1);
    const off = (await fingers()).map((it, i) => it - from[i]); // of the finger tips from the hand
    await pinch(0);
    // The middle of the table, at sea level under the vehicle's place: 0.6 m before the head, 0.5 m below it.
    const at = [placed.east_m / 500, EYES_M - 0.5 + placed.up_m / 500, -0.6 - placed.north_m / 500];
    await put(at.map((it, i) => it - off[i]));
    writeFileSync(join(work, "table.png"), await hal.picture());
    await pinch(1);
    const held_ms = await hal.now();
    const [right_m, back_m] = [0.031, -0.022]; // 15.5 m to the east, 11 m to the north
    await put([at[0] - off[0] + right_m, at[1] - off[1], at[2] - off[2] + back_m]);
    await pinch(0);
    await sleep(600); // a trial each 200 ms
    const trials = await hal.said("waypoints", held_ms);
    assert(trials.length > 0 && trials.every((it) => it.is_trial), `${trials.length} trials, or more than trials`);
    const moved = trials.at(-1).places[0];
    // Places of a way are kept to 0.1 m.
    near(moved.east_m - placed.east_m, 500 * right_m, 0.11, "to the east, m");
    near(moved.north_m - placed.north_m, -500 * back_m, 0.11, "to the north, m");
    assert.equal(moved.up_m, placed.up_m);
    const verdict = await hal.reads(".reply", /^The server would take this way|^Refused/);
    // The other vehicle stands 40 m to the west and 30 m to the south of this one's start, 32 m deep.
    const there = [-40 / 500, EYES_M - 0.5 - 32 / 500, -0.6 + 30 / 500];
    await put(there.map((it, i) => it - off[i]));
    await pinch(1);
    await pinch(0);
    const chosen = await hal.reads(".target", /^For rov 2/);
    await hal.page.evaluate(() => device.activeSession.end());
    return `${(moved.east_m - placed.east_m).toFixed(1)} m and ${(moved.north_m - placed.north_m).toFixed(1)} m; ${verdict} ${chosen}`;
  },

  async "the helm goes back to the desk: asked for there, granted on the board"() {
    await hal.page.$eval(".vehicles .choose", (first) => first.click());
    await hal.reads(".target", /^For rov 1/);
    await hal.page.evaluate(() => (device.primaryInputMode = "controller"));
    await hal.enter("Enter VR", /left controller, right controller/);
    const since_ms = await hal.now();
    await hal.value("right", "b-button", 1);
    await hal.value("right", "b-button", 0);
    await hal.says("hold", since_ms);
    await ann.reads(".log li", /Hal hold rov 1/);
    await ann.press("Ask for the helm");
    await hal.reads(".helm-state", /Ann asks for the helm/);
    await hal.board("Grant");
    await ann.reads(".helm-state", /^You drive/);
    return hal.reads(".helm-state", /^Ann drives/);
  },

  async "a telephone beside them takes the helm, drives by touch, and looks about in the scene"() {
    pia = await Person.sitDown("Pia", browsers[0], AT, { viewport: TELEPHONE });
    return telephone_drives(ann, hal, pia);
  },
};

const began_ms = Date.now();
for (const [what, step] of Object.entries(steps)) {
  const from_ms = Date.now();
  const saw = await step().catch((error) => fail(what, error));
  console.log(`${what}: ${saw ?? "yes"} (${((Date.now() - from_ms) / 1000).toFixed(1)} s)`);
}
console.log(`all in ${((Date.now() - began_ms) / 1000).toFixed(0)} s`);
await Promise.all(browsers.map((browser) => browser.close()));
