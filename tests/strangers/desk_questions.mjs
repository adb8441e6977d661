// desk_questions.mjs MODULES PROGRAM STORE: what a coordinator asks in the morning, each answered by the page / within three
// clicks, and every number on it what the server answers. Exit 77 where the program was built without the page's script.
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const [modules, program, store] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const LIMIT_MS = 120_000; // generous: sanitizers, two cores
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
if (script === "") {
  server.kill();
  console.log("skipped: the program was built without the page's script");
  process.exit(77);
}
const at = new Date(Date.parse(forecast.issued) + 3_600_000).toISOString().replace(/\.\d+Z$/, "Z");
// A ship on its way to the site, slow enough for its last report to stay fresh.
const { place } = await json(`${address}/sites/${id}`);
server.kill();
const heard = join(mkdtempSync(join(tmpdir(), "desk-questions-")), "heard.csv");
writeFileSync(
  heard,
  "MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,VesselType,Length,Width,TransceiverClass\n" +
    `227000001,${at.slice(0, -1)},${place.latitude_deg - 0.0135},${place.longitude_deg},2.9,0,0,<b>SLOW & NEAR</b>,70,90,14,A\n`,
);
({ server, address } = await serve("--at", at, "--ais", heard));
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

  // As a person reads a chance: never nothing, never certain, and no rule reached that is missed.
  const percent = (share) => {
    if (share < 0.005) return "under 1 %";
    if (share >= 0.995) return "over 99 %";
    const whole = Math.round(100 * share);
    return `${[0.9, 0.5].some((rule) => share < rule && whole >= 100 * rule) ? whole - 1 : whole} %`;
  };

  const questions = {
    "May we go tomorrow?": async () => {
      const said = await page.$$eval(".day-head", (all) => all.at(-1).innerText);
      assert.ok(said.includes(report.headline), said);
    },
    "What is left of today?": async () => assert.ok((await text(".day-head")).includes(report.today.headline)),
    "What stops the blade scan?": async () =>
      assert.ok((await task_text()).includes(scan.best.stopped_by.split(", exceeded at ")[0]), await task_text()),
    "How sure is that?": async () => {
      const [low, high] = scan.best.interval_95.map((share) => percent(share).replace(" %", ""));
      const interval = low === high ? percent(scan.best.interval_95[0]) : `${low} to ${high} %`;
      assert.ok((await task_text()).includes(`${percent(scan.best.probability)} (${interval})`), await task_text());
    },
    // Held against the numbers themselves; where there are none the page has to say that nobody knows.
    "How often were past goes right?": async () => {
      const { past } = scan;
      const said = await task_text();
      if (past === null || past.mornings === 0) assert.match(said, /No past morning could be held against what came/);
      else if (past.goes === 0) assert.match(said, new RegExp(`no start was a go over ${past.mornings} past morning`));
      else assert.match(said, new RegExp(`of ${past.goes} goe?s? ${past.goes_held} held over ${past.mornings} past morning`));
    },
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
    "What ship comes too near?": async () => {
      await shows(() => document.querySelector(".vessel-list summary")?.textContent.includes("1 marked"));
      await click(await page.$(".vessel-list summary"));
      const [vessel] = (await json(`${address}/sites/${id}/traffic`)).vessels;
      assert.equal(vessel.alarm, "closing");
      const said = await page.$eval(".vessel-list tbody tr", (row) => row.innerText.replace(/\s+/g, " "));
      assert.ok(said.includes("<b>SLOW & NEAR</b>"), said); // text, and no more
      assert.ok(said.includes(`${Math.round(vessel.told.cpa_m)} m from`), said);
      assert.match(said, /in 1\d min ! nearer than 500 m within 30 min 1\.5 m\/s to 000°/);
    },
    "When is slack at 20 m?": async () => {
      await tab("Water at the place");
      clicks += 1;
      await page.select("#map select", "20");
      const { slack } = await json(`${address}/sites/${id}/slack?depth=20`);
      const next = slack.find(({ to }) => to >= at);
      const till = next.ends_after ? "the end" : next.to.slice(11, 16);
      await shows((said) => document.querySelector(".slack").innerText.includes(said), `to ${till} (`);
      const sure = next.sure_from === null ? "at no time nearly sure" : `nearly sure ${next.sure_from.slice(11, 16)} to ${next.sure_to.slice(11, 16)}`;
      assert.match(await text(".slack"), new RegExp(`^Slack at 20 m: below 0.50 m/s, UTC: likely .*${sure}`));
    },
    "How high are the waves, and from where?": async () => {
      await tab("Water at the place");
      const { sea_surface_wave_significant_height: height, sea_surface_wave_from_direction: from } = await edr("waves", { datetime: hour });
      await shows((said) => document.querySelector(".facts")?.innerText.includes(said), `${height.toFixed(1)} m from ${degrees(from)}`);
    },
    "What does the wave product say, and we?": async () => {
      await tab("Water at the place");
      const { collections } = await json(`${address}/collections`);
      const { id: product } = collections.find(({ keywords }) => keywords.includes("product") && keywords.includes("waves"));
      const said = async (collection) => {
        const { sea_surface_wave_significant_height: height, sea_surface_wave_from_direction: from } = await edr(collection, { datetime: hour });
        return `${height.toFixed(1)} m from ${degrees(from)}`;
      };
      const row = [await said(product), await said("waves")];
      await shows((cells) => [...document.querySelectorAll(".models tbody tr")].some((it) => cells.every((cell, i) => it.cells[i + 1].innerText === cell)), row);
    },
    "What if the scan bore more wind?": async () => {
      await tab("What if");
      await page.waitForSelector(".limit-list input");
      const [label, now] = await page.$eval(".limit-list input", (input) => [input.closest(".field").querySelector("label").innerText, input.value]);
      assert.match(label, /wind.* at most \(m\/s\)/);
      const more = String(Number(now) + 4);
      const task = await page.$eval(".what-if-fields select", (select) => select.value);
      const coming = page.waitForResponse((it) => it.url().endsWith("/what-if"), { timeout: LIMIT_MS });
      await (await page.$(".limit-list input")).click({ count: 3 });
      clicks += 1;
      await page.keyboard.type(more);
      await page.keyboard.press("Tab");
      const response = await coming;
      const { texts } = JSON.parse(response.request().postData());
      assert.deepEqual(Object.keys(texts), ["tasks"]);
      assert.match(texts.tasks[task], new RegExp(`wind\\w*: *${more}\\b`));
      const told = await response.json();
      const changed = told.windows.tasks.find((it) => it.task === task);
      const best = changed.starts.find(({ start }) => start === changed.best?.start) ?? changed.starts.reduce((a, b) => (b.worth > a.worth ? b : a));
      const row = `${percent(best.probability)} at ${best.start.slice(11, 16)}`;
      await shows(
        (name, said) => [...document.querySelectorAll(".what-if-result tbody tr")].some((it) => it.innerText.includes(name) && it.children[2].innerText.replace(/\s+/g, " ").includes(said)),
        changed.name,
        row,
      );
    },
    "Did yesterday's forecast beat the tide alone?": async () => {
      await shows(() => document.querySelector(".before-section table"));
      const scores = await json(`${address}/sites/${id}/verification`);
      const rows = await page.$$eval(".before-section table tbody tr", (all) =>
        all.map((row) => [row.cells[0].innerText, row.querySelector("[data-key]")?.dataset.key, row.cells[1].innerText]),
      );
      // Ours and the tide's, of the same issue and lead: which is less is to be read off the two.
      const ours = rows.find(([name]) => name === "This forecast");
      const tide = rows.find(([name]) => /^Tide alone/.test(name));
      for (const [, key, shown] of [ours, tide]) {
        const [index, name] = key.split(".");
        assert.ok(shown.startsWith(scores[index][name].toFixed(2)), `${shown} is not ${scores[index][name]}`);
      }
      const [a, b] = [ours, tide].map(([, key]) => scores[key.split(".")[0]]);
      assert.deepEqual([a.issued, a.lead_h, a.variable], [b.issued, b.lead_h, b.variable]);
      assert.equal(/less than ours/.test(tide[2]), b.rmse_m_s < a.rmse_m_s && b.rmse_m_s.toFixed(2) !== a.rmse_m_s.toFixed(2));
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
  const shown = await page.$$eval("[data-from]", (all) => all.map((it) => ({ ...it.dataset, text: it.textContent })));
  const answers = {};
  // What is read, by the name of the value; what is drawn has no text.
  const reads = {
    probability: percent,
    worth: percent,
    start: (time) => time.slice(11, 16),
    rmse: (error) => error.toFixed(2),
    rmse_m_s: (error) => error.toFixed(2),
    rival_rmse: (error) => error.toFixed(2),
    value: (worth) => worth.toFixed(2),
    verdict: (verdict) => ({ go: "Go", marginal: "Marginal", "no-go": "No-go" })[verdict],
    headline: (words) => words,
    futures: String,
    name: (words) => words,
    sha256: (sum) => sum.slice(0, 12),
  };
  let read = 0;
  for (const { from, key, value, text: words } of shown) {
    answers[from] ??= await json(address + from);
    const there = key.split(".").reduce((whole, part) => whole?.[part], answers[from]);
    assert.equal(value, typeof there === "string" ? there : JSON.stringify(there ?? null), `${from} ${key}`);
    const as_read = reads[key.split(".").at(-1)];
    if (words === "" || as_read === undefined || there === null) continue;
    assert.ok(words.includes(as_read(there)), `${from} ${key}: "${words}" is not ${as_read(there)}`);
    read += 1;
  }
  console.log(`${shown.length} values of ${Object.keys(answers).length} answers are the server's, ${read} of them read as text`);
  assert.ok(read > 40);
  assert.ok(shown.length > 100);
} finally {
  await browser.close();
  server.kill();
}
