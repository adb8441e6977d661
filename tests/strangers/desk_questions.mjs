// desk_questions.mjs MODULES PROGRAM STORE: what a coordinator asks in the morning, each answered by the page / within three
// clicks, and every number on it what the server answers. Exit 77 where the program was built without the page's script.
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, program, store] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const LIMIT_MS = 60_000; // generous: sanitizers, two cores
const MOST_CLICKS = 3;
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const json = async (address) => (await fetch(address)).json();

async function serve(...more) {
  const server = spawn(program, ["serve", "--store", store, "--port", "0", ...more]);
  let said = "";
  server.stdout.on("data", (data) => (said += data));
  for (let waited_ms = 0; waited_ms < LIMIT_MS; waited_ms += 50) {
    const address = /http:\/\/127\.0\.0\.1:\d+/.exec(said)?.[0];
    if (address) return { server, address };
    await sleep(50);
  }
  server.kill("SIGKILL");
  throw new Error(`the server did not begin: ${said}`);
}

let { server, address } = await serve();
const script = await (await fetch(`${address}/desk/page.js`)).text();
const [{ id, forecast }] = (await json(`${address}/sites`)).sites;
server.kill();
if (script === "") {
  console.log("skipped: the program was built without the page's script");
  process.exit(77);
}
const at = new Date(Date.parse(forecast.issued) + 3_600_000).toISOString().replace(/\.\d+Z$/, "Z");
({ server, address } = await serve("--at", at));
const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu"],
});

try {
  const report = await json(`${address}/sites/${id}/report`);
  const scan = report.tasks.find(({ task }) => task === "blade_scan");
  let page, clicks;
  const click = async (what) => {
    clicks += 1;
    await what.click();
  };
  const tab = async (name) => click(await page.waitForSelector(`::-p-aria([name="${name}"][role="tab"])`));
  const shows = (look, ...given) => page.waitForFunction(look, { timeout: LIMIT_MS, polling: 100 }, ...given);
  const text = (where) => page.$eval(where, (node) => node.innerText);
  const task_text = () =>
    page.$$eval(".tasks > li", (all, name) => all.find((it) => it.innerText.includes(name)).innerText.replace(/\s+/g, " "), scan.name);
  const facts = () =>
    page.$$eval(".facts > *", (all) => all.map((it) => it.innerText.replace(/\s+/g, " ")).join("; "));
  const edr = async (collection, more) => {
    const { place } = await json(`${address}/sites/${id}`);
    const coords = `POINT(${place.longitude_deg} ${place.latitude_deg})`;
    const asked = new URLSearchParams({ coords, f: "CoverageJSON", ...more });
    const { ranges } = await json(`${address}/collections/${collection}/position?${asked}`);
    return Object.fromEntries(Object.entries(ranges).map(([name, { values }]) => [name, values[0]]));
  };
  const hour = at.replace(/T(\d\d):.*/, "T$1:00:00Z");
  const degrees = (value) => `${String(Math.round(value) % 360).padStart(3, "0")}°`;

  const questions = {
    "May we go tomorrow?": async () => {
      const said = await page.$$eval(".day-head", (all) => all.at(-1).innerText);
      assert.ok(said.includes(report.headline), said);
    },
    "What is left of today?": async () => assert.ok((await text(".day-head")).includes(report.today.headline)),
    "What stops the blade scan?": async () =>
      assert.ok((await task_text()).includes(scan.best.stopped_by.split(", exceeded at ")[0]), await task_text()),
    "How sure is that?": async () => {
      const [low, high] = scan.best.interval_95.map((share) => Math.round(100 * share));
      assert.ok((await task_text()).includes(`(${low} to ${high} %)`), await task_text());
    },
    "How often were past goes right?": async () => assert.match(await task_text(), /past mornings?/),
    "Why not at noon?": async () => {
      const windows = await json(`${address}/sites/${id}/windows?from=${report.from}&to=${report.to}`);
      const { starts } = windows.tasks.find(({ task }) => task === "blade_scan");
      const noon = starts.findIndex(({ start }) => start.includes("T12:00"));
      await shows(() => document.querySelector(".windows-section svg.starts"));
      await click(
        await page.evaluateHandle(
          (name) => [...document.querySelectorAll(".windows-section button")].find((it) => it.innerText.startsWith(name)),
          day(report.from),
        ),
      );
      await shows((name) => [...document.querySelectorAll(".task-row")].some((it) => it.innerText.includes(name)), scan.name);
      const box = await page.evaluateHandle(
        (name) => [...document.querySelectorAll(".task-row")].find((it) => it.innerText.includes(name)).querySelector("svg.starts"),
        scan.name,
      );
      clicks += 1;
      const { width, height } = await box.boundingBox();
      await box.click({ offset: { x: ((noon + 0.5) * width) / starts.length, y: height / 2 } });
      await shows(() => document.querySelector(".start-detail"));
      assert.ok((await text(".start-detail")).includes(starts[noon].binding.limit), await text(".start-detail"));
    },
    "What does nobody check?": async () => {
      const more = await page.evaluateHandle(
        (name) => [...document.querySelectorAll(".tasks > li")].find((it) => it.innerText.includes(name)).querySelector("summary"),
        scan.name,
      );
      await click(more);
      for (const limit of scan.not_checked) assert.ok((await task_text()).includes(limit), `${limit}\n${await task_text()}`);
    },
    "How strong is the current at 20 m, and which way?": async () => {
      await tab("Water at the place");
      clicks += 1;
      await page.select("#map select", "20");
      const { sea_water_speed: speed, sea_water_velocity_to_direction: to } = await edr("currents", { z: "20", datetime: hour });
      await shows((said) => document.querySelector(".facts")?.innerText.includes(said), `${speed.toFixed(2)} m/s to ${degrees(to)}`);
      assert.match(await facts(), /Current at 20 m/);
    },
    "When is slack at 20 m?": async () => {
      await tab("Water at the place");
      clicks += 1;
      await page.select("#map select", "20");
      const { slack } = await json(`${address}/sites/${id}/slack?depth=20`);
      const next = slack.find(({ to }) => to >= at);
      const till = next.ends_after ? "the end" : next.to.slice(11, 16);
      await shows((said) => document.querySelector(".slack").innerText.includes(said), `to ${till}`);
      assert.match(await text(".slack"), /^Slack at 20 m: .*below 0.50 m\/s, UTC/);
    },
    "How high are the waves, and from where?": async () => {
      await tab("Water at the place");
      const { sea_surface_wave_significant_height: height, sea_surface_wave_from_direction: from } = await edr("waves", { datetime: hour });
      await shows((said) => document.querySelector(".facts")?.innerText.includes(said), `${height.toFixed(1)} m from ${degrees(from)}`);
    },
    "What if the scan bore more wind?": async () => {
      await tab("What if");
      const limit = await page.waitForSelector(".limit-list input");
      await limit.click({ count: 3 });
      clicks += 1;
      await page.keyboard.type("16");
      await page.keyboard.press("Tab");
      await shows((name) => document.querySelector(".what-if-result")?.innerText.includes(name), scan.name);
    },
    "Did yesterday's forecast beat the tide alone?": async () => {
      await shows(() => document.querySelector(".before-section table"));
      assert.match(await text(".before-section table"), /This forecast/);
    },
  };
  function day(time) {
    return new Intl.DateTimeFormat("en-GB", { weekday: "short", timeZone: "UTC" }).format(new Date(time));
  }

  for (const [question, answer] of Object.entries(questions)) {
    page = await browser.newPage();
    await page.setViewport({ width: 1440, height: 900 });
    await page.goto(address);
    await page.waitForSelector(".tasks > li", { timeout: LIMIT_MS });
    clicks = 0;
    await answer();
    console.log(`${question} ${clicks} clicks`);
    assert.ok(clicks <= MOST_CLICKS, question);
    if (question !== Object.keys(questions).at(-1)) await page.close();
  }

  // Every number of the page is the server's.
  await page.waitForNetworkIdle({ timeout: LIMIT_MS });
  const shown = await page.$$eval("[data-from]", (all) => all.map((it) => ({ ...it.dataset })));
  const answers = {};
  for (const { from, key, value } of shown) {
    answers[from] ??= await json(address + from);
    const there = key.split(".").reduce((whole, part) => whole?.[part], answers[from]);
    assert.equal(value, typeof there === "string" ? there : JSON.stringify(there ?? null), `${from} ${key}`);
  }
  console.log(`${shown.length} values of ${Object.keys(answers).length} answers are the server's`);
  assert.ok(shown.length > 100);
} finally {
  await browser.close();
  server.kill();
}
