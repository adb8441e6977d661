// People in a session for tests: each sits at the page in Chromium as it is. What a page says to the server is heard by wrapping
// WebSocket.prototype.send. A headset is iwer's: WebXR as the page calls it, with a head, controllers and hands that the test moves.
import { strict as assert } from "node:assert";

const TOKENS = { Ann: "ann-0123456789abcdef", Hal: "hal-0123456789abcdef", Pia: "pia-0123456789abcdef" };
const LIMIT_MS = 30000; // generous: sanitizers, two cores
export const EYES_M = 1.6; // over the floor
export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

export const near = (found, expected, within, what) =>
  assert(Math.abs(found - expected) <= within, `${what}: ${found}, expected ${expected} within ${within}`);
export const moved_m = (a, b) => Math.hypot(b.from.east_m - a.from.east_m, b.from.north_m - a.from.north_m);
export const isZero = (it) => it.velocity.every((axis) => axis === 0);
/** Of sticks since before a loss: a zero went out, and nothing else from where it was seen on. */
export function endInZero(sticks, seen_ms, what) {
  assert(sticks.some(isZero), `${what}: no zero goes out`);
  const after = sticks.filter((it) => it.at_ms >= seen_ms);
  assert(after.every(isZero), `${what}: ${JSON.stringify(after.map((it) => it.velocity))}`);
}

/** Hears what a page says. Runs in the page, before its script. */
function hear() {
  window.heard = [];
  const send = WebSocket.prototype.send;
  WebSocket.prototype.send = function (data) {
    heard.push({ ...JSON.parse(data), at_ms: performance.now() });
    return send.call(this, data);
  };
}

/** Puts a headset on. Runs in the page, before its script, after iwer's. */
function wear() {
  window.device = new IWER.XRDevice(IWER.metaQuest3, { stereoEnabled: true });
  device.installRuntime({ forceInstall: true });
  device.position.set(0, 1.6, 0);
  window.seen = { frames: 0, fingers: {} };
  const ask = XRSession.prototype.requestAnimationFrame;
  XRSession.prototype.requestAnimationFrame = function (callback) {
    return ask.call(this, (now, frame) => {
      seen.frames += 1;
      const space = device.viewerSpace;
      for (const { hand, handedness } of this.inputSources) {
        if (!hand) continue;
        const at = (joint) => frame.getJointPose(hand.get(joint), space).transform.position;
        const [thumb, index] = [at("thumb-tip"), at("index-finger-tip")];
        seen.fingers[handedness] = ["x", "y", "z"].map((it) => (thumb[it] + index[it]) / 2 + device.position[it]);
      }
      callback(now, frame);
    });
  };
}

export class Person {
  constructor(name, page) {
    this.name = name;
    this.page = page;
  }
  /**
   * `at`: the session's address, iwer's script, and `fail`, which is told where a page throws.
   * `how`: `wears` a headset, has another `viewport`.
   */
  static async sitDown(name, browser, at, how = {}) {
    const { wears = false, viewport = { width: 320, height: 180 } } = how;
    const page = await browser.newPage();
    const person = new this(name, page);
    await page.setViewport(viewport);
    await page.evaluateOnNewDocument(hear);
    if (wears) {
      await page.evaluateOnNewDocument(at.iwer);
      await page.evaluateOnNewDocument(wear);
    }
    page.on("pageerror", (error) => at.fail(`the page of ${name} throws`, error));
    page.on("console", (said) => said.type() === "error" && console.log(`${name}'s console: ${said.text()}`));
    await page.goto(`${at.address}/session`);
    await page.waitForSelector("form.join option", { timeout: LIMIT_MS });
    await page.type("form.join input[type=text]", name);
    await page.type("form.join input[type=password]", TOKENS[name]);
    await page.click("form.join button[type=submit]");
    await person.until("a seat", () => document.documentElement.dataset.link === "seated" && document.querySelector(".age").dataset.grade);
    return person;
  }
  async until(what, look, ...given) {
    const found = await this.page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given).catch(async () => {
      throw new Error(`${this.name}: ${what} did not come; ${await this.shown()}`);
    });
    return found.jsonValue();
  }
  shown() {
    return this.page.evaluate(() => {
      const places = ".problem .helm-state .countdown .run .age .asked .taken .target .reply #notice .scene-tools>.note".split(" ");
      const texts = places.map((at) => [at, document.querySelector(at)?.textContent]).filter(([, text]) => text);
      return JSON.stringify(Object.fromEntries(texts));
    });
  }
  reads(at, pattern) {
    const read = (at, pattern) => {
      const text = document.querySelector(at)?.textContent ?? "";
      return new RegExp(pattern).test(text) && text;
    };
    return this.until(`${pattern} at ${at}`, read, at, pattern.source);
  }
  press(text) {
    return this.until(`a button "${text}"`, (text) => {
      const all = [...document.querySelectorAll("button")];
      const button = all.find((it) => it.textContent === text && it.offsetParent && !it.disabled);
      button?.click();
      return Boolean(button);
    }, text);
  }
  now() {
    return this.page.evaluate(() => performance.now());
  }
  said(what, since_ms = 0) {
    return this.page.evaluate((what, since_ms) => heard.filter((it) => it.do === what && it.at_ms >= since_ms), what, since_ms);
  }
  /** The first thing said of a kind, after a moment, that is as asked. */
  async says(what, since_ms, is_it = () => true) {
    for (const from_ms = Date.now(); Date.now() < from_ms + LIMIT_MS; await sleep(50)) {
      const found = (await this.said(what, since_ms)).find(is_it);
      if (found) return found;
    }
    throw new Error(`${this.name}: no ${what} as asked is said; ${await this.shown()}`);
  }
}

/** Hal and what the headset does. */
export class Wearer extends Person {
  /** Runs a change of the device in the page, and waits for two frames after it. */
  async change(how, ...given) {
    await this.page.evaluate(how, ...given);
    const frames = await this.page.evaluate(() => seen.frames);
    await this.until("frames of the headset", (frames) => seen.frames >= frames + 2, frames);
  }
  async enter(text, pattern) {
    await this.press(text);
    return this.reads(".scene-tools > .note", pattern);
  }
  /** A controller there, pointing along a direction. */
  aim(side, at, ahead) {
    return this.change((side, at, ahead) => {
      // From -z to `ahead`: about their cross product, by half the angle.
      const [x, y, z] = ahead.map((it) => it / Math.hypot(...ahead));
      const q = [y, -x, 0, 1 - z];
      const size = Math.hypot(...q);
      device.controllers[side].position.set(...at);
      device.controllers[side].quaternion.set(...q.map((it) => it / size));
    }, side, at, ahead);
  }
  value(side, button, value) {
    return this.change((side, button, value) => device.controllers[side].updateButtonValue(button, value), side, button, value);
  }
  stick(side, x, y) {
    return this.change((side, x, y) => device.controllers[side].updateAxes("thumbstick", x, y), side, x, y);
  }
  /** Presses a button of the board with the right hand's ray from the head: the desk says where each is. */
  async board(text) {
    const at = await this.until(`"${text}" on the board`, (text) => {
      const button = [...document.querySelectorAll(".on-board li")].find((it) => it.textContent === text);
      return button && button.dataset.atM.split(" ").map(Number);
    }, text);
    const head = [0, EYES_M, 0];
    await this.aim("right", head, at.map((it, i) => it - head[i]));
    await this.value("right", "trigger", 1);
    await this.value("right", "trigger", 0);
  }
  /** What the headset shows, without what the desk has over it. */
  async picture() {
    const cover = (is_there) => this.page.$eval(".scene-cover", (it, is_there) => (it.style.visibility = is_there ? "" : "hidden"), is_there);
    await cover(false);
    const picture = await this.page.screenshot();
    await cover(true);
    return picture;
  }
  /** Where the others are told that one's head is. */
  async look() {
    await sleep(600); // told four times a second
    return (await this.said("look")).at(-1);
  }
}
