// session_sleeps.mjs MODULES ADDRESS: a tab with the page of a session is hidden and frozen, as browsers do to save power, and woken
// after SLACKWATER_ASLEEP_S (20) seconds: within 1 s it shows the newest frame, over the same link or a new one; no frame of meanwhile is replayed,
// and nothing is sent for the time that is past. SLACKWATER_PAGE: a folder with another page.js and page.css than the server's own.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, address] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const ASLEEP_S = Number(process.env.SLACKWATER_ASLEEP_S ?? 20);
const AWAKE_WITHIN_MS = 1000;
const LIMIT_MS = 30000;
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** Hears what the page says and is told. Runs in the page, before its script. */
function hear() {
  const heard = { said: [], frames: [], sockets: 0, closed: [], shown: [] };
  window.heard = heard;
  const send = WebSocket.prototype.send;
  const known = new Set();
  WebSocket.prototype.send = function (data) {
    if (!known.has(this)) {
      known.add(this);
      heard.sockets += 1;
      this.addEventListener("close", ({ code, reason }) => heard.closed.push({ code, reason, at_ms: Date.now() }));
      this.addEventListener("message", ({ data }) => typeof data !== "string" && heard.frames.push(Date.now()));
    }
    heard.said.push({ what: JSON.parse(data).do, at_ms: Date.now() });
    return send.call(this, data);
  };
  addEventListener("DOMContentLoaded", () =>
    new MutationObserver(() => {
      const [age, time] = [".age", ".time"].map((at) => document.querySelector(at));
      heard.shown.push({ grade: age?.dataset.grade, time: time?.textContent, at_ms: Date.now() });
    }).observe(document.body, { subtree: true, attributes: true, attributeFilter: ["data-grade"], childList: true }),
  );
}

const browser = await require("puppeteer-core").launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  args: ["--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader"],
});
try {
  const page = await browser.newPage();
  await page.setViewport({ width: 1000, height: 700 });
  await page.evaluateOnNewDocument(hear);
  if (process.env.SLACKWATER_PAGE) {
    await page.setRequestInterception(true);
    page.on("request", (request) => {
      const name = new URL(request.url()).pathname.match(/^\/session\/(page\.(?:js|css))$/)?.[1];
      if (name === undefined) return request.continue();
      const contentType = name.endsWith("js") ? "text/javascript" : "text/css";
      return request.respond({ contentType, body: readFileSync(join(process.env.SLACKWATER_PAGE, name)) });
    });
  }
  await page.goto(`${address}/session`);
  await page.waitForSelector("form.join option", { timeout: LIMIT_MS });
  await page.type("form.join input[type=text]", "Wen");
  await page.type("form.join input[type=password]", "wen-0123456789abcdef");
  await page.click("form.join button[type=submit]");
  const is_fresh = () => ["fresh", "amber"].includes(document.querySelector(".age")?.dataset.grade); // younger than 0.5 s
  await page.waitForFunction(is_fresh, { timeout: LIMIT_MS, polling: 50 });
  await sleep(2000);

  const other = await browser.newPage();
  await other.bringToFront();
  await page.waitForFunction(() => document.hidden, { timeout: LIMIT_MS, polling: 50 });
  const devtools = await page.createCDPSession();
  await devtools.send("Page.setWebLifecycleState", { state: "frozen" });
  const asleep_ms = Date.now();
  await sleep(1000 * ASLEEP_S);
  const woken_ms = Date.now();
  await devtools.send("Page.setWebLifecycleState", { state: "active" });
  await page.bringToFront();
  await page.waitForFunction((since) => window.heard.shown.some((it) => it.at_ms > since + 1500), { timeout: LIMIT_MS, polling: 50 }, woken_ms);
  const heard = await page.evaluate(() => window.heard);

  // It did sleep: of the 20 frames a second, and of timers each 100 ms, nothing was heard and said.
  const meanwhile = (it) => (it.at_ms ?? it) > asleep_ms + 1000 && (it.at_ms ?? it) < woken_ms;
  assert.equal(heard.said.filter(meanwhile).length + heard.frames.filter(meanwhile).length, 0, "it did not sleep");
  const fresh = heard.shown.find((it) => it.at_ms >= woken_ms && it.grade !== "red" && it.grade !== undefined);
  assert(fresh !== undefined, "no fresh picture came");
  const took_ms = fresh.at_ms - woken_ms;
  assert(took_ms < AWAKE_WITHIN_MS, `the newest picture was there after ${took_ms} ms`);
  // Nobody reads for a frozen tab: the server may have ended the link meanwhile, and it is made anew.
  assert(heard.sockets <= 2, `${heard.sockets} links`);
  // 20 of the first second, 20 that the server may have sent ahead of what the page said it saw, 5 for uneven timers.
  const MOST_FRAMES = 45;
  // The second that it fell asleep at, the next one where frames were sent ahead; that of its waking, and the next.
  const MOST_TIMES = 4;
  // Of 45 frames 9 times `saw`, 3 more by time, a `hello` and 6 times `time` over a new link are 19, and as many again for a slow
  // machine. Timers of 20 s that are made up for were 50 times `saw` and 10 times `time` more.
  const MOST_SAID = 40;
  const soon = (at_ms) => at_ms >= woken_ms && at_ms < woken_ms + 1000;
  const frames = heard.frames.filter(soon).length;
  assert(frames <= MOST_FRAMES, `${frames} frames in the first second: those of the past, too`);
  const times = new Set(heard.shown.filter((it) => soon(it.at_ms)).map((it) => it.time));
  assert(times.size <= MOST_TIMES, `it went through ${[...times].join(", ")}`);
  const said = heard.said.filter((it) => soon(it.at_ms)).map((it) => it.what);
  assert(said.every((it) => ["time", "saw", "hello"].includes(it)) && said.length <= MOST_SAID, `it said ${said.join()}`);
  console.log(`asleep for ${ASLEEP_S} s, then the newest frame ${took_ms} ms after waking, over ${heard.sockets === 1 ? "the same" : "a new"} link; ${frames} frames and ${said.length} words in the first second`);
} finally {
  await browser.close();
}
