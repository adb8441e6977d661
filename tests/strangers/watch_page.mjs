// watch_page.mjs MODULES ADDRESS WORK take-part: people take part in the live session at ADDRESS, by plain sockets.
// watch_page.mjs MODULES ADDRESS WORK watch PROCESS: its log, served at ADDRESS by PROCESS, is watched in Chromium: played, sought by
// hand, keys and actions, looked at with axe-core at three widths (pictures in WORK), until PROCESS is interrupted.
import { strict as assert } from "node:assert";
import { readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, address, work, what, server] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const LIMIT_MS = 30000; // generous: sanitizers, two cores
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  userDataDir: join(work, `browser-${what}`),
  args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
  timeout: 2 * LIMIT_MS,
});
const page = await browser.newPage();
const failures = [];
page.on("pageerror", (error) => failures.push(`the page throws: ${error.message}`));
page.on("console", (message) => {
  if (message.type() === "error" && !message.text().includes("ERR_CONNECTION")) failures.push(`the page says: ${message.text()}`);
});

/** Runs in the page, of whose origin the sockets are. */
async function deeds() {
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  class Seat {
    static async take(name) {
      const seat = new Seat();
      const token = `${name.toLowerCase()}-0123456789abcdef`;
      seat.socket = new WebSocket(`ws://${location.host}/sessions/run/socket`, ["slackwater.session.v1", `bearer.${token}`]);
      seat.answers = new Map();
      seat.id = 0;
      const welcome = new Promise((done) => {
        seat.socket.onmessage = ({ data }) => {
          if (typeof data !== "string") return;
          const told = JSON.parse(data);
          if (told.is === "answer") seat.answers.get(told.id)?.(told);
          if (told.is === "welcome") done(told);
        };
      });
      await new Promise((done) => (seat.socket.onopen = done));
      seat.socket.send(JSON.stringify({ do: "hello", id: -1, name }));
      const told = await welcome;
      seat.ahead_ms = told.clock - performance.now();
      seat.number = told.number;
      return seat;
    }
    asks(message) {
      const id = (this.id += 1);
      this.socket.send(JSON.stringify({ ...message, id }));
      return new Promise((done) => this.answers.set(id, done));
    }
    orders(what, vehicle, more = {}) {
      const at = Math.floor(performance.now() + this.ahead_ms);
      return this.asks({ do: what, vehicle, number: (this.number += 1), at, until: at + 900, ...more });
    }
    async drives(vehicle, velocity, for_ms) {
      for (let ms = 0; ms < for_ms; ms += 100) {
        await this.orders("stick", vehicle, { velocity });
        await wait(100);
      }
    }
  }
  const taken = [];
  const keep = async (answer) => {
    const told = await answer;
    taken.push(told.taken ? "taken" : told.text);
  };
  const [ann, bob, sue] = [await Seat.take("Ann"), await Seat.take("Bob"), await Seat.take("Sue")];
  await wait(700);
  await keep(ann.asks({ do: "ask", vehicle: 0 }));
  await ann.drives(0, [0.5, 0, 0, 0.12], 3000);
  await keep(bob.asks({ do: "ask", vehicle: 0 }));
  await keep(ann.asks({ do: "deny", vehicle: 0 }));
  await keep(bob.orders("home", 0)); // refused: it is hers
  await ann.drives(0, [0.3, 0.2, 0.2, 0], 1500);
  await keep(bob.asks({ do: "ask", vehicle: 1 }));
  const place = (east_m, north_m, up_m) => ({ east_m, north_m, up_m, speed_m_s: 0.6 });
  await keep(bob.orders("waypoints", 1, { places: [place(20, 0, -12)] })); // refused: into the pile
  await keep(bob.orders("waypoints", 1, { places: [place(-2, -18, -14), place(12, -14, -16)] }));
  await wait(1500);
  const joins = { model: "bluerov2_heavy", name: "rov 3", east_m: -12, north_m: 8, up_m: -6, heading_deg: 90 };
  await keep(sue.asks({ do: "spawn", ...joins }));
  await wait(1500);
  await keep(sue.orders("hold", 0));
  await keep(sue.asks({ do: "take_back", vehicle: 1, reason: "too near the pile" }));
  await wait(1500);
  await keep(sue.asks({ do: "give_back", vehicle: 0 }));
  await keep(ann.asks({ do: "say", text: "thank you, all" }));
  await wait(1500);
  return taken;
}

/** Waits until `look`, in the page, finds something true, and gives that. */
async function until(about, look, ...given) {
  const found = await page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given).catch(async () => {
    const texts = await page.evaluate(() =>
      [".run", ".way-text", "#notice", ".problem", ".log .head"].map((at) => `${at} "${document.querySelector(at)?.textContent}"`).join(", "),
    );
    throw new Error(`${about} did not come; ${texts}`);
  });
  return found.jsonValue();
}
/** Waits until the text at `at` is like `pattern`, and gives the text. */
const reads = (at, pattern) =>
  until(`${pattern} at ${at}`, (at, pattern) => {
    const text = document.querySelector(at)?.textContent ?? "";
    return new RegExp(pattern).test(text) && text;
  }, at, pattern.source);
const press = (text) =>
  until(`a button "${text}"`, (text) => {
    const button = [...document.querySelectorAll("button")].find((it) => it.textContent === text && it.offsetParent && !it.disabled);
    button?.click();
    return Boolean(button);
  }, text);
/** Of "0:12 of 1:30": seconds. */
const inSeconds = (clock) => clock.split(":").reduce((sum, it) => 60 * sum + Number(it), 0);
const head = async () => inSeconds((await reads(".way-text", / of /)).split(" of ")[0]);
const end = async () => inSeconds((await reads(".way-text", / of /)).split(" of ")[1]);

const watching = {
  async "it opens by itself, without a token, and asks for none"() {
    await page.setViewport({ width: 1440, height: 900 });
    await page.goto(`${address}/session`);
    await until("the scrubber", () => document.querySelector("#playback")?.offsetParent);
    assert.equal(await page.$eval("#join", (it) => it.hidden), true);
    await reads(".run", /^Recording, paused/);
    return reads(".way-text", /^0:00 of /);
  },

  async "nothing to drive with is there"() {
    const shown = await page.evaluate(() =>
      [...document.querySelectorAll("button, input, select")].filter((it) => it.offsetParent).map((it) => it.textContent || it.ariaLabel || it.type),
    );
    const driving = ["HOLD", "Home", "Resume", "Ask for the helm", "Give back", "Take back", "Go on", "Step", "Edit the way", "Say", "Leave"];
    assert.deepEqual(shown.filter((it) => driving.includes(it)), []);
    assert.equal(await page.$eval("#orders", (it) => it.hidden), true);
    return `${shown.length} things to press`;
  },

  async "it plays, at other rates too, and stays where it is paused"() {
    await press("Play");
    await reads(".run", /plays 1×/);
    await page.select("#playback select", "10");
    await reads(".run", /plays 10×/);
    await until("10 s", () => /^0:[1-5]\d/.test(document.querySelector(".way-text").textContent));
    await press("Pause");
    await reads(".run", /^Recording, paused/);
    const paused_s = await head();
    await sleep(600);
    assert.equal(await head(), paused_s);
    return `paused at ${paused_s} s`;
  },

  async "the keys of the scrubber move it, and it says where it is"() {
    await page.focus(".scrub input");
    await page.keyboard.press("Home");
    await reads(".way-text", /^0:00 of/);
    await page.keyboard.press("ArrowRight");
    await until("a step", () => !document.querySelector(".way-text").textContent.startsWith("0:00"));
    const step_s = await head();
    await page.keyboard.press("End");
    const last_s = await end();
    await until("the end", (last_s) => Number(document.querySelector(".scrub input").value) > last_s - 1, last_s);
    const words = await page.$eval(".scrub input", (it) => it.getAttribute("aria-valuetext"));
    assert.match(words, /^05:\d\d:\d\d UTC, (\d+:\d\d) of \1$/);
    return `a step is ${step_s} s; "${words}"`;
  },

  async "an action that is clicked is where the head goes, and its row is marked"() {
    const asked = await page.evaluate(() => {
      const row = [...document.querySelectorAll(".log li")].find((it) => /Bob waypoints rov 2.*waypoints$/.test(it.textContent));
      row.click();
      return row.querySelector("button").textContent;
    });
    await reads(".head-time", new RegExp(`^${asked}`));
    const marked = await reads(".log [aria-current]", /waypoints/);
    await until("a helm of Bob's", () => /Bob/.test(document.querySelector(".vehicles tbody tr:nth-child(2)").textContent));
    assert.match(await page.$eval(".vehicles tbody tr:nth-child(3)", (it) => it.textContent), /rov 3not there/);
    return marked;
  },

  async "the next and the previous action are one press away"() {
    const row = () => page.$eval(".log [aria-current]", (it) => [...it.parentNode.children].indexOf(it));
    const before = await row();
    await press("Next action");
    await until("the next row", (before) => [...document.querySelectorAll(".log li")].findIndex((it) => it.ariaCurrent) > before, before);
    const next = await row();
    await press("Previous action");
    await until("the row before", (next) => [...document.querySelectorAll(".log li")].findIndex((it) => it.ariaCurrent) < next, next);
    return `rows ${before}, ${next}, ${await row()}`;
  },

  async "refused actions have another shape on the bar than those taken"() {
    const count = await page.$$eval(".log .refused", (all) => all.length);
    assert.equal(count, 2);
    return reads(".legend", /× one that was refused/);
  },

  async "Space plays it to its end, where it stops, and what was done is told as it goes"() {
    await press("Previous action");
    await page.select("#playback select", "50");
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press("Space");
    await reads(".run", /plays 50×/);
    await reads(".run", /^Recording, paused/);
    const [at_s, end_s] = [await head(), await end()];
    assert.equal(at_s, end_s);
    await reads("#notice", /^The recording is at its end/);
    await until("the last row", () => document.querySelector(".log li:last-child").ariaCurrent === "true");
    return `${at_s} s`;
  },

  async "axe-core finds nothing, and nothing is wider than its window"() {
    await page.select("#playback select", "10");
    await page.focus("#plan");
    await page.keyboard.press("Space"); // at its end: from the beginning
    await until("what is looked at", () => /^0:4/.test(document.querySelector(".way-text").textContent));
    await page.keyboard.press("Space");
    await reads(".run", /^Recording, paused/);
    await page.evaluate(() => document.activeElement.blur());
    await page.evaluate(axe);
    let looks = 0;
    for (const palette of ["day", "dusk", "night"])
      for (const width of [1440, 1024, 390]) {
        await page.setViewport({ width, height: width === 390 ? 844 : 900 });
        await page.evaluate((palette) => {
          const choice = [...document.querySelectorAll("dialog select")].find((it) => it.querySelector("[value=night]"));
          choice.value = palette;
          choice.dispatchEvent(new Event("change"));
        }, palette);
        await until("the width", (width) => innerWidth === width, width);
        await sleep(300);
        const faults = await page.evaluate(async () => {
          const found = await axe.run(document, { iframes: false });
          return found.violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.target).join(" ")}`);
        });
        assert.deepEqual(faults, [], `${palette}, ${width} px`);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert(wide <= width, `${palette}: ${wide} px wide in a window of ${width}`);
        const outside = await page.$$eval("#playback button, #playback select, #playback input", (all) =>
          all.filter((it) => it.getBoundingClientRect().right > innerWidth || it.scrollWidth > it.clientWidth + 1).map((it) => it.textContent || it.type),
        );
        assert.deepEqual(outside, [], `${palette}, ${width} px`);
        await page.screenshot({ path: join(work, `watch-${palette}-${width}.png`) });
        looks += 1;
      }
    return `${looks} looks; a picture is ${statSync(join(work, "watch-day-1440.png")).size} bytes`;
  },

  async "when it is not served any more the page says so"() {
    process.kill(Number(server), "SIGINT");
    return reads(".problem", /not served any more/);
  },
};

const began_ms = Date.now();
try {
  if (what === "take-part") {
    await page.goto(`${address}/session`);
    const taken = await page.evaluate(deeds);
    const words = taken.map((it) => (it === "taken" ? "" : it));
    assert.deepEqual(words.map((it) => it !== ""), [false, false, false, true, false, true, false, false, false, false, false, false], words.join("; "));
    assert.match(words[3], /has the helm of rov 1/);
    assert.match(words[5], /lies in structure 1/);
    console.log("took part");
  } else {
    for (const [about, step] of Object.entries(watching)) {
      const from_ms = Date.now();
      const saw = await step().catch((error) => {
        throw new Error(`${about}: ${error.message}`);
      });
      console.log(`${about}: ${saw} (${((Date.now() - from_ms) / 1000).toFixed(1)} s)`);
    }
    assert.deepEqual(failures, []);
  }
} catch (error) {
  console.log(`FAILED: ${error.message}`, failures);
  await page.screenshot({ path: join(work, "failed.png") }).catch(() => undefined);
  process.kill(-browser.process().pid, "SIGKILL"); // with its children
  process.exit(1);
}
console.log(`all in ${((Date.now() - began_ms) / 1000).toFixed(0)} s`);
await browser.close();
