// session_page.mjs MODULES ADDRESS WORK: people take part in the session at ADDRESS, each with the page in Chromium as it is (two
// browsers, puppeteer-core, axe-core): they drive, hand the helm over, are overruled, pause, edit a way, reload and are cut off.
// What a page says to the server is heard by wrapping WebSocket.prototype.send.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, address, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const TOKENS = { Ann: "ann-0123456789abcdef", Bob: "bob-0123456789abcdef", Sue: "sue-0123456789abcdef" };
const PILE = { east_m: 20, north_m: 0 }; // of the scenario, 10 m thick
const LEAST_CUT_MS = process.env.SLACKWATER_LONG_CUT ? 24000 : 8000; // the seat is kept 30 s, and the page tries each 4 s
const VIEW = { width: 1024, height: 640 }; // the scene is drawn without a graphics card: its time goes by its area
const LIMIT_MS = 30000; // generous: sanitizers, two cores
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** Hears what a page says, and reads the session's clock beside the page's. Runs in the page, before its script. */
function hear() {
  const heard = { said: [], sockets: [], ahead_ms: -Infinity };
  window.heard = heard;
  const send = WebSocket.prototype.send;
  WebSocket.prototype.send = function (data) {
    if (!heard.sockets.includes(this)) {
      heard.sockets.push(this);
      this.addEventListener("message", ({ data }) => {
        const told = typeof data === "string" ? JSON.parse(data) : {};
        // Of all that came the quickest: the others were on their way longer.
        if (told.is === "clock") heard.ahead_ms = Math.max(heard.ahead_ms, told.clock - performance.now());
      });
    }
    heard.said.push({ ...JSON.parse(data), at_ms: performance.now() });
    return send.call(this, data);
  };
}

const asked_for = { inside: 0, links: 0, outside: [] };

/** A person at the page. */
class Person {
  constructor(name, page) {
    this.name = name;
    this.page = page;
  }
  static async sitDown(name, browser, search = "") {
    const context = await browser.createBrowserContext();
    const person = new Person(name, await context.newPage());
    await person.page.setViewport(VIEW);
    await person.page.evaluateOnNewDocument(hear);
    person.page.on("pageerror", (error) => fail(`the page of ${name} throws`, error));
    const took = (url, from) => {
      const { protocol, origin } = new URL(url);
      if (origin === from || protocol === "data:" || protocol === "blob:") asked_for.inside += 1;
      else asked_for.outside.push(url);
    };
    person.page.on("request", (it) => took(it.url(), address));
    // Links are no requests to puppeteer; those that never said a word count, too.
    const devtools = await person.page.createCDPSession();
    await devtools.send("Network.enable");
    devtools.on("Network.webSocketCreated", ({ url }) => {
      asked_for.links += 1;
      took(url, address.replace("http:", "ws:"));
    });
    await person.page.goto(`${address}/session${search}`);
    await person.page.waitForSelector("form.join option", { timeout: LIMIT_MS });
    return person;
  }
  async join(token = TOKENS[this.name]) {
    await this.page.type("form.join input[type=text]", this.name);
    await this.page.type("form.join input[type=password]", token);
    await this.page.click("form.join button[type=submit]");
  }
  /** Waits until `look`, in the page, finds something true, and gives that. */
  async until(what, look, ...given) {
    const found = await this.page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given).catch(async () => {
      throw new Error(`${this.name}: ${what} did not come; ${await this.shown()}`);
    });
    return found.jsonValue();
  }
  /** What a reader of a failure wants to know. */
  shown() {
    return this.page.evaluate(() => {
      const places = ".problem .helm-state .countdown .run .time .age .cut .asked .taken .reply #notice .log>li".split(" ");
      const texts = places.map((at) => [at, document.querySelector(at)?.textContent]).filter(([, text]) => text);
      return JSON.stringify({ link: document.documentElement.dataset.link, ...Object.fromEntries(texts) });
    });
  }
  /** Waits until the text at `at` is like `pattern`, and gives the text. */
  reads(at, pattern) {
    const read = (at, pattern) => {
      const text = document.querySelector(at)?.textContent ?? "";
      return new RegExp(pattern).test(text) && text;
    };
    return this.until(`${pattern} at ${at}`, read, at, pattern.source);
  }
  seated() {
    return this.until("a seat with a picture of now", () => {
      const grade = document.querySelector(".age")?.dataset.grade;
      return document.documentElement.dataset.link === "seated" && (grade === "fresh" || grade === "amber");
    });
  }
  press(text) {
    return this.until(`a button "${text}"`, (text) => {
      const all = [...document.querySelectorAll("button")];
      const button = all.find((it) => it.textContent === text && it.offsetParent && !it.disabled);
      button?.click();
      return Boolean(button);
    }, text);
  }
  /** The scene in the place of the plan, or the plan. */
  async showScene(is_wanted) {
    const is_shown = await this.page.evaluate(() => !document.querySelector("#scene").hidden);
    if (is_shown !== is_wanted) await this.press("Scene");
    await this.until("the scene or the plan", (is_wanted) => document.querySelector("#scene").hidden !== is_wanted, is_wanted);
  }
  async takeHelm() {
    await this.press("Ask for the helm");
    return this.reads(".helm-state", /^You drive/);
  }
  async giveBack() {
    await this.press("Give back");
    await this.reads(".helm-state", /^Nobody drives/);
  }
  /** To the front, with no field in focus: the keys are the stick's. */
  async takeKeys() {
    await this.page.bringToFront();
    await this.until("the focus", () => (document.activeElement?.blur(), document.hasFocus() && !document.hidden));
  }
  async pressDeadMan() {
    await this.page.keyboard.down("Space");
    await this.page.keyboard.down("w");
  }
  async letGo() {
    await this.page.keyboard.up("Space");
    await this.page.keyboard.up("w");
    await this.reads(".asked", /^Stick at rest/);
  }
  now() {
    return this.page.evaluate(() => performance.now());
  }
  said(what, since_ms = 0) {
    const choose = (what, since_ms) => heard.said.filter((it) => it.do === what && it.at_ms >= since_ms);
    return this.page.evaluate(choose, what, since_ms);
  }
  /**
   * Holds the dead-man until so many sticks in a row went out. Where the machine is so slow that the picture is old, the page
   * wants it let go and held again.
   */
  async drive(count) {
    for (const from_ms = Date.now(); Date.now() < from_ms + LIMIT_MS; ) {
      const since_ms = await this.now();
      await this.pressDeadMan();
      const look = (count, since_ms) => {
        const sticks = heard.said.filter((it) => it.do === "stick" && it.at_ms >= since_ms && it.velocity[0] > 0);
        if (sticks.length >= count) return "driven";
        return document.querySelector(".asked").textContent.startsWith("Let the stick go") && "blocked";
      };
      if ((await this.until(`${count} sticks`, look, count, since_ms)) === "driven") return since_ms;
      await this.letGo();
    }
    throw new Error(`${this.name}'s page never sends ${count} sticks in a row`);
  }
  /** Nothing of the stick goes out for so long, though the page goes on telling the server what it saw. */
  async saysNoStick(for_ms, since_ms) {
    await sleep(for_ms);
    assert.deepEqual(await this.said("stick", since_ms), [], `${this.name}'s page sends a stick`);
  }
  async close() {
    await this.page.browserContext().close();
  }
}

async function fail(what, error) {
  console.log(`FAILED: ${what}: ${error.message}`);
  for (const person of [ann, bob, sue].filter(Boolean)) console.log(`${person.name} sees ${await person.shown().catch(String)}`);
  for (const browser of browsers) process.kill(-browser.process().pid, "SIGKILL"); // with its children
  process.exit(1);
}

const browsers = [];
for (let i = 0; i < 2; ++i) {
  const browser = await puppeteer.launch({
    executablePath: process.env.SLACKWATER_BROWSER,
    userDataDir: join(work, `browser${i}`),
    args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
    timeout: 2 * LIMIT_MS,
  });
  browsers.push(browser);
}
let ann, bob, sue;

const steps = {
  async "an operator joins and takes the helm"() {
    ann = await Person.sitDown("Ann", browsers[0]);
    await ann.join();
    await ann.seated();
    return ann.takeHelm();
  },

  async "held, the dead-man sends sticks, and the vehicle moves"() {
    await ann.takeKeys();
    const since_ms = await ann.drive(40);
    const speed = await ann.reads(".vehicles tbody tr:first-child td:nth-of-type(3)", /^0\.[1-9]|^[1-9]/);
    const taken = await ann.reads(".taken", /Taken at step \d+/);
    const sticks = await ann.said("stick", since_ms);
    const per_s = (1000 * (sticks.length - 1)) / (sticks.at(-1).at_ms - sticks[0].at_ms);
    assert(per_s > 8 && per_s < 30, `${per_s} sticks a second`);
    sticks.slice(1).forEach((it, i) => assert(it.number > sticks[i].number, "numbers rise"));
    const ahead_ms = await ann.page.evaluate(() => heard.ahead_ms);
    const valid_ms = Math.max(...sticks.map((it) => it.until - it.at_ms - ahead_ms));
    assert(valid_ms > 0 && valid_ms < 500, `valid for ${valid_ms} ms: 400, and what two readings of a clock differ by`);
    return `${sticks.length} sticks, ${per_s.toFixed(1)} a second, valid ${valid_ms.toFixed(0)} ms at most; ${speed}; ${taken}`;
  },

  async "let go, it sends zero once, not the last stick, and then nothing"() {
    await ann.page.keyboard.up("Space"); // and W stays down
    const released_ms = await ann.now();
    await ann.reads(".asked", /^Stick at rest/);
    await sleep(1000);
    const after = await ann.said("stick", released_ms);
    assert(after.length <= 1, `${after.length} sticks after the release`);
    const last = (await ann.said("stick")).at(-1);
    assert.deepEqual(last.velocity, [0, 0, 0, 0], "the last stick");
    await ann.page.keyboard.up("w");
    return `last ${JSON.stringify(last.velocity)}`;
  },

  async "a hidden tab sends nothing, and after its return nothing before the dead-man is pressed anew"() {
    await ann.drive(5);
    const other = await ann.page.browserContext().newPage();
    await other.bringToFront();
    await ann.until("being hidden", () => document.hidden);
    const since_ms = await ann.now();
    await ann.saysNoStick(1200, since_ms);
    await ann.page.bringToFront();
    await ann.until("being seen", () => !document.hidden && document.hasFocus());
    await ann.seated();
    await ann.pressDeadMan(); // as a held key repeats
    await ann.saysNoStick(800, since_ms);
    const asked = await ann.reads(".asked", /./);
    await ann.letGo();
    await ann.drive(5);
    await ann.letGo();
    await other.close();
    return `held over its return: "${asked}"`;
  },

  async "the settings drop no helm"() {
    await ann.press("Settings");
    await ann.until("the dialog", () => document.querySelector("dialog[open]") !== null);
    await sleep(500);
    const state = await ann.reads(".helm-state", /^You drive/);
    await ann.press("Close");
    return state;
  },

  async "another asks: both count down, and the holder denies"() {
    bob = await Person.sitDown("Bob", browsers[1]);
    await bob.join();
    await bob.seated();
    await bob.reads(".helm-state", /^Ann drives/);
    await bob.press("Ask for the helm");
    const hers = await ann.reads(".countdown", /To answer: \d+ s/);
    const his = await bob.reads(".countdown", /Waiting for Ann: \d+ s/);
    const isLess = (before) => {
      const text = document.querySelector(".countdown").textContent;
      return /To answer|Waiting/.test(text) && Number(text.match(/\d+/)) < Number(before.match(/\d+/)) && text;
    };
    const later = await Promise.all([ann.until("less", isLess, hers), bob.until("less", isLess, his)]);
    await ann.press("Deny");
    await bob.reads(".helm-state", /^Ann drives\.$/);
    await ann.reads(".helm-state", /^You drive\.$/);
    return `"${hers}" then "${later[0]}"; "${his}" then "${later[1]}"`;
  },

  async "asks again, and is granted it"() {
    await bob.press("Ask for the helm");
    await ann.press("Grant");
    await ann.reads(".helm-state", /^Bob drives/);
    return bob.reads(".helm-state", /^You drive/);
  },

  async "a supervisor's HOLD works without the helm, and takes it"() {
    sue = await Person.sitDown("Sue", browsers[1], "?class");
    await sue.join();
    await sue.seated();
    await sue.reads(".helm-state", /^Bob drives/);
    await sue.takeKeys();
    await sue.page.keyboard.press("h");
    await sue.reads(".helm-state", /^You drive/);
    const his = await bob.reads(".helm-state", /^Sue drives/);
    await sue.giveBack();
    return `Bob reads "${his}"`;
  },

  async "a supervisor takes a helm back, with a reason that all can read"() {
    await bob.takeHelm();
    await sue.page.bringToFront();
    await sue.press("Take back");
    await sue.page.keyboard.type("too near the pile");
    await sue.press("Take back now");
    await bob.until("the loss of the helm", () => !document.querySelector(".helm-state").textContent.startsWith("You drive"));
    await bob.reads("#notice", /Taken back: too near the pile/);
    return bob.reads(".log li", /Sue .*too near the pile/);
  },

  async "a supervisor's pause, step and go on are seen by the others"() {
    await sue.press("Pause");
    const paused = await bob.reads(".run", /^Paused by Sue/);
    const time = await bob.reads(".time", /./);
    await sue.page.$eval("[aria-label=Steps]", (field) => (field.value = 60));
    await sue.press("Step");
    const later = await bob.until("the time after 60 steps, 3 s", (before) => {
      const text = document.querySelector(".time").textContent;
      const second = (text) => Number(text.match(/:(\d\d) /)[1]);
      return (second(text) - second(before) + 60) % 60 >= 2 && text;
    }, time);
    await bob.reads(".run", /^Paused/);
    await sue.press("Go on");
    return `${paused}; ${time}, ${later}; ${await bob.reads(".run", /^Running/)}`;
  },

  async "a place dragged into a pile is refused by the server before it is let go"() {
    const state = await sue.reads(".helm-state", /./);
    if (state.startsWith("You drive")) await sue.giveBack();
    await ann.takeHelm();
    await ann.takeKeys();
    await ann.press("Edit the way");
    const since_ms = await ann.now();
    const lastPlace = (since_ms) => heard.said.findLast((it) => it.do === "waypoints" && it.at_ms >= since_ms)?.places.at(-1);
    const box = await (await ann.page.$("#plan")).boundingBox();
    const at = { x: box.x + box.width / 2 + 40, y: box.y + box.height / 2 - 60 };
    await ann.page.mouse.click(at.x, at.y);
    const placed = await ann.until("a trial of a place", lastPlace, since_ms);
    await ann.page.mouse.move(at.x, at.y);
    await ann.page.mouse.down();
    // How much a pixel is, from a first pull.
    await ann.page.mouse.move(at.x + 20, at.y);
    const pulled = await ann.until("a trial of the pull", (since_ms, east_m) => {
      const place = heard.said.findLast((it) => it.do === "waypoints" && it.at_ms >= since_ms).places.at(-1);
      return place.east_m > east_m && place;
    }, since_ms, placed.east_m);
    const per_m = 20 / (pulled.east_m - placed.east_m);
    const pile = { x: at.x + (PILE.east_m - placed.east_m) * per_m, y: at.y - (PILE.north_m - placed.north_m) * per_m };
    await ann.page.mouse.move(pile.x, pile.y, { steps: 20 });
    const refused = await ann.reads(".reply", /^Refused: .* lies in structure 1/);
    assert((await ann.said("waypoints", since_ms)).every((it) => it.is_trial), "only trials go out while it is dragged");
    await ann.page.mouse.move(at.x, at.y, { steps: 20 });
    await ann.reads(".reply", /^The server would take this way/);
    await ann.page.mouse.up();
    await ann.press("Send the way");
    await ann.reads("#notice", /^The way is taken/);
    const sent = (await ann.said("waypoints", since_ms)).filter((it) => !it.is_trial);
    assert.equal(sent.length, 1);
    await ann.reads(".log li", /Ann waypoints rov 1/);
    return refused;
  },

  async "a reload keeps the seat and the helm"() {
    const seats = await ann.reads(".seats", /Ann/);
    await ann.page.reload();
    await ann.seated();
    const state = await ann.reads(".helm-state", /^You drive/);
    assert.equal(await ann.reads(".seats", /Ann/), seats);
    await ann.takeKeys();
    await ann.drive(5);
    const taken = await ann.reads(".taken", /Taken at step \d+/);
    await ann.letGo();
    return `${state} ${taken}`;
  },

  async "a duplicated tab is no rival"() {
    const KEY = "slackwater.session.seat";
    const kept = await ann.page.evaluate((key) => sessionStorage.getItem(key), KEY);
    const twin = new Person("the tab beside Ann", await ann.page.browserContext().newPage());
    await twin.page.evaluateOnNewDocument((key, kept) => sessionStorage.setItem(key, kept), KEY, kept);
    await twin.page.goto(`${address}/session`);
    await twin.until("its giving up the seat", (key) => sessionStorage.getItem(key) === null, KEY);
    await twin.until("the form", () => document.querySelector("form.join").offsetParent !== null);
    await twin.until("no seat", () => document.documentElement.dataset.link !== "seated");
    await twin.page.close();
    await ann.page.bringToFront();
    await ann.seated();
    return ann.reads(".helm-state", /^You drive/);
  },

  async "a link that is cut comes back to its seat and its helm, and sends nothing of the past"() {
    await ann.takeKeys();
    await ann.drive(5);
    // The goodbye goes through, then nothing does. The page tries again soon: where it is quicker than we, once more.
    for (let is_cut = false; !is_cut; is_cut = await ann.page.evaluate(() => document.documentElement.dataset.link === "cut")) {
      await ann.page.setOfflineMode(false);
      await ann.page.evaluate(() => new Promise((done) => {
        heard.sockets.at(-1).addEventListener("close", done);
        heard.sockets.at(-1).close();
      }));
      await ann.page.setOfflineMode(true);
      await sleep(500);
    }
    const cut = await ann.reads(".cut", /^No link/);
    const since_ms = await ann.now();
    const cut_ms = Date.now();
    const his = await bob.reads(".helm-state", /^Ann's link is down/);
    await sleep(cut_ms + LEAST_CUT_MS - Date.now());
    await ann.page.setOfflineMode(false);
    await ann.seated();
    await ann.reads(".helm-state", /^You drive/);
    await ann.pressDeadMan(); // as a held key repeats
    await ann.saysNoStick(1000, since_ms);
    const said = await ann.page.evaluate((since_ms) => heard.said.filter((it) => it.at_ms >= since_ms), since_ms);
    const kinds = [...new Set(said.map((it) => it.do))];
    assert(kinds.every((it) => ["hello", "saw", "time"].includes(it)), `it says ${kinds}`);
    await ann.letGo();
    await ann.drive(5);
    await ann.letGo();
    return `"${cut}", Bob reads "${his}"; back it says ${kinds}`;
  },

  async "a wrong token is refused in words and written nowhere"() {
    const eve = await Person.sitDown("Eve", browsers[1]);
    const wrong = "wrong-0123456789abcdef";
    await eve.join(wrong);
    const words = await eve.reads(".problem", /token/);
    for (const [person, token] of [[eve, wrong], [ann, TOKENS.Ann]]) {
      const look = () => JSON.stringify([location.href, { ...localStorage }, { ...sessionStorage }]);
      const written = await person.page.evaluate(look);
      assert(!written.includes(token), `${person.name}'s token is in ${written}`);
    }
    assert(!words.includes(wrong));
    await eve.close();
    return words;
  },

  async "the scene shows the vehicles where the plan does, and gives the plan back"() {
    await ann.press("Scene");
    const label = await ann.until("a vehicle in the scene", () => {
      const shown = [...document.querySelectorAll(".scene-label")].find((it) => !it.hidden && it.textContent.startsWith("rov 1"));
      return shown?.textContent;
    });
    assert.match(label, /m deep$/);
    await ann.press("On board");
    await ann.page.focus("#scene-canvas");
    await ann.page.keyboard.press("ArrowLeft");
    await ann.until("a name that is not its own", () => [...document.querySelectorAll(".scene-label")].some((it) => it.hidden));
    await ann.press("Scene");
    await ann.until("the plan", () => document.querySelector("#scene").hidden);
    return label;
  },

  async "a note in the scene is there for the others, until it is taken away"() {
    for (const person of [ann, sue]) await person.press("Scene");
    await sue.page.bringToFront();
    await sue.page.click(".scene-words summary");
    await ann.page.bringToFront();
    await ann.page.type(".scene-note input", "loose anode");
    await ann.press("Put");
    await sue.page.bringToFront();
    const note = await sue.reads(".scene-notes", /Ann: loose anode/);
    await sue.reads(".scene-words", /Vehicles are as the twin has them/);
    await sue.press("Take away");
    await sue.until("no note", () => document.querySelector(".scene-notes").textContent === "");
    await ann.press("Scene");
    return note;
  },

  async "a place of a way is put into the scene and lifted without a key"() {
    await sue.takeKeys();
    await sue.page.keyboard.press("h"); // whoever has the helm
    await sue.reads(".helm-state", /^You drive/);
    await sue.press("Edit the way");
    await sue.press("Place");
    const since_ms = await sue.now();
    const trial = (since_ms) => heard.said.findLast((it) => it.do === "waypoints" && it.at_ms >= since_ms)?.places.at(-1);
    await sue.page.focus("#scene-canvas");
    await sue.page.keyboard.press("Enter"); // in the middle: at the vehicle that is followed, or near it
    const placed = await sue.until("a trial of the place", trial, since_ms);
    await sue.press("Up");
    await sue.press("Up");
    // Half a metre twice; each time it is rounded to a tenth, so up to 0.05 m off, and a little for the fractions themselves.
    const lifted = await sue.until("a trial of the lift", (since_ms, up_m) => {
      const place = heard.said.findLast((it) => it.do === "waypoints" && it.at_ms >= since_ms).places.at(-1);
      return place.up_m > up_m + 0.9 && place;
    }, since_ms, placed.up_m);
    assert(Math.abs(lifted.up_m - placed.up_m - 1) < 0.11 && lifted.east_m === placed.east_m, JSON.stringify([placed, lifted]));
    assert((await sue.said("waypoints", since_ms)).every((it) => it.is_trial), "nothing is sent but trials");
    await sue.press("Delete");
    await sue.press("Drop the changes");
    await sue.giveBack();
    return `${placed.east_m} E, ${placed.north_m} N, ${-placed.up_m} then ${-lifted.up_m} m deep`;
  },

  async "what somebody looks at is kept when that is wanted, and not before"() {
    const hover = async (at) => (await sue.page.$(at)).hover();
    await hover(".weather h2");
    await sue.page.waitForFunction(() => new Promise((done) => setTimeout(() => done(true), 800)));
    assert.deepEqual(await sue.said("attend"), [], "nothing without being asked");
    await sue.press("Keep what I look at");
    await hover(".weather h2");
    await sue.until("the panel looked at", () => heard.said.some((it) => it.do === "attend" && it.on === "Weather" && it.by === "pointer"));
    await sue.press("What I look at is kept");
    await sue.until("its end", () => heard.said.some((it) => it.do === "attend" && it.by === "off"));
    const rows = await bob.page.evaluate(() => document.querySelector(".log").textContent);
    assert(!rows.includes("attend"), "the others are told nothing of it");
    return (await sue.said("attend")).map((it) => `${it.by} ${it.on ?? ""}`).join(", ");
  },

  async "a lesson is done with the weather, for all, and given back"() {
    await sue.showScene(false);
    await sue.press("Battery against current");
    await sue.press("About eight times as much");
    await sue.reads(".lessons", /^.*Yes\./s);
    await sue.press("Do it");
    await sue.reads(".lessons", /The charge falls faster/);
    await bob.page.bringToFront();
    const led = await bob.reads(".weather .facts", /0\.\d\d m\/s to 090. · set by hand/);
    await sue.page.bringToFront();
    await sue.press("Back to the lessons");
    await bob.page.bringToFront();
    await bob.until("the run's own current", () => !document.querySelector(".weather").textContent.includes("set by hand"));
    await sue.page.bringToFront();
    await sue.page.click(".own-weather summary");
    const [wind] = await sue.page.$$(".own-weather input");
    await wind.focus();
    await sue.page.keyboard.press("ArrowRight");
    await sue.reads(".own-weather", /set by hand/);
    await bob.page.bringToFront();
    const slid = await bob.reads(".weather .facts", /Wind at 10 m[^·]* · set by hand/);
    await sue.page.bringToFront();
    await sue.press("All by itself");
    await bob.page.bringToFront();
    await bob.until("the run's own wind", () => !document.querySelector(".weather").textContent.includes("set by hand"));
    await sue.page.bringToFront();
    await sue.press("Why an inspection missed a crack"); // for axe-core
    return `${led}; ${slid}`;
  },

  async "axe-core finds nothing, and nothing is wider than its window"() {
    const eve = await Person.sitDown("Eve", browsers[1]);
    let looks = 0;
    for (const [person, role, widths] of [[sue, "supervisor", [1280, 1024, 390]], [eve, "who joins", [390]]]) {
      await person.page.bringToFront();
      await person.page.evaluate(axe);
      for (const palette of ["day", "night"])
        for (const width of widths) {
          await person.page.setViewport({ width, height: 844 });
          await person.page.evaluate((palette) => {
            const choice = [...document.querySelectorAll("dialog select")].find((it) => it.querySelector("[value=night]"));
            choice.value = palette;
            choice.dispatchEvent(new Event("change"));
          }, palette);
          await person.until("the width", (width) => innerWidth === width, width);
          if (person === sue) await sue.showScene(palette === "day" ? width === 1280 : width === 390);
          const faults = await person.page.evaluate(async () => {
            const found = await axe.run(document, { iframes: false });
            return found.violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.target).join(" ")}`);
          });
          assert.deepEqual(faults, [], `${role}, ${palette}, ${width} px`);
          const wide = await person.page.evaluate(() => document.documentElement.scrollWidth);
          assert(wide <= width, `${role}, ${palette}: ${wide} px wide in a window of ${width}`);
          looks += 1;
        }
    }
    await eve.close();
    return `${looks} looks`;
  },

  async "no request leaves the machine"() {
    assert.deepEqual(asked_for.outside, []);
    assert(asked_for.inside > 10, `${asked_for.inside} requests were seen`); // a page is three, and there are four people at least
    assert(asked_for.links >= 3, `${asked_for.links} links were seen`); // one of each seat
    return `${asked_for.inside} requests, ${asked_for.links} of them links, all to ${address}`;
  },

  async "who leaves is told so, and the others see it"() {
    await ann.press("Leave");
    const left = await ann.reads(".problem", /left/);
    await bob.until("Ann's leaving", () => !document.querySelector(".seats").textContent.includes("Ann"));
    return left;
  },
};

const began_ms = Date.now();
for (const [what, step] of Object.entries(steps)) {
  const from_ms = Date.now();
  const saw = await step().catch((error) => fail(what, error));
  console.log(`${what}: ${saw} (${((Date.now() - from_ms) / 1000).toFixed(1)} s)`);
}
console.log(`all in ${((Date.now() - began_ms) / 1000).toFixed(0)} s`);
await Promise.all(browsers.map((browser) => browser.close()));
