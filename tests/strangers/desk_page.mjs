// desk_page.mjs MODULES PROGRAM STORE WORK: `PROGRAM serve` over STORE, and its page / in Chromium (puppeteer-core, axe-core).
// Exit 77 where the program was built without the page's script.
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, program, store, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const LIMIT_MS = 30000; // generous: sanitizers, two cores
const IDLE_LIMIT_MS = 180000; // until a whole morning is worked out
const STEP_LIMIT_MS = 50; // of script, from the slider to the picture
const FIRST_VIEW_LIMIT_BYTES = 400_000;
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** Starts the server at its own or at a given port; gives it with its address. */
async function serve(port, ...more) {
  const server = spawn(program, ["serve", "--store", store, "--port", String(port), ...more]);
  let said = "";
  server.stdout.on("data", (data) => (said += data));
  server.stderr.on("data", (data) => (said += data));
  for (let waited_ms = 0; waited_ms < LIMIT_MS; waited_ms += 50) {
    const address = /http:\/\/127\.0\.0\.1:\d+/.exec(said)?.[0];
    if (address && (await fetch(address).catch(() => null))) return { server, address };
    await sleep(50);
  }
  server.kill("SIGKILL");
  throw new Error(`the server did not begin: ${said}`);
}
const json = async (address) => (await fetch(address)).json();

let { server, address } = await serve(0);
const port = new URL(address).port;
if ((await (await fetch(`${address}/desk/page.js`)).text()) === "") {
  server.kill();
  console.log("skipped: the program was built without the page's script");
  process.exit(77);
}
// The demo is of a past day: the server's clock stands an hour after the issue.
const [{ id, forecast }] = (await json(`${address}/sites`)).sites;
const at = new Date(Date.parse(forecast.issued) + 3_600_000).toISOString().replace(/\.\d+Z$/, "Z");
const restart = async () => ({ server } = await serve(port, "--at", at));
const gone = async () => {
  server.kill();
  while (await fetch(address).catch(() => null)) await sleep(20);
};
await gone();
await restart();

const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu"],
});
const faults = [];
async function open(hash, width = 1440, height = 900) {
  const page = await browser.newPage();
  await page.setViewport({ width, height });
  page.on("pageerror", (error) => faults.push(`the page throws: ${error.message}`));
  page.on("request", (request) => {
    const to = request.url();
    if (!to.startsWith(address) && !to.startsWith("data:")) faults.push(`asks another: ${to}`);
  });
  await page.goto(`${address}/#${hash}`);
  return page;
}
const text = (page, where) => page.$eval(where, (node) => node.textContent);
const until = (page, look, ...given) =>
  page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given).catch((cause) => {
    throw new Error(`it never came true: ${look}`, { cause });
  });
const shows_place = (page) => page.waitForSelector(".facts dd", { timeout: LIMIT_MS });

try {
  // What is shown is what EDR answers, and the first view is light.
  let page = await open("panel=place&depth=10&palette=day");
  await shows_place(page);
  const hour = at.replace(/T(\d\d):.*/, "T$1:00:00Z");
  const { place } = await json(`${address}/sites/${id}`);
  const coords = `POINT(${place.longitude_deg} ${place.latitude_deg})`;
  const asked = new URLSearchParams({ coords, z: "10", datetime: hour, f: "CoverageJSON" });
  const { ranges } = await json(`${address}/collections/currents/position?${asked}`);
  const speed = ranges.sea_water_speed.values[0].toFixed(2);
  const to = String(Math.round(ranges.sea_water_velocity_to_direction.values[0]) % 360).padStart(3, "0");
  assert.equal(await text(page, ".facts dd"), `${speed} m/s to ${to}°`);
  const { gzipSync } = await import("node:zlib");
  const parts = await Promise.all(["/", "/desk/page.css", "/desk/page.js"].map((path) => fetch(address + path, { headers: { Accept: "text/html" } })));
  const bytes = (await Promise.all(parts.map(async (part) => gzipSync(await part.text()).length))).reduce((a, b) => a + b);
  console.log(`the first view is ${Math.round(bytes / 1000)} kB`);
  assert.ok(bytes < FIRST_VIEW_LIMIT_BYTES);

  // The slider, by keys: another hour, at once, and nothing is asked for it.
  await page.waitForNetworkIdle({ timeout: IDLE_LIMIT_MS });
  const asks = () => page.evaluate(() => performance.getEntriesByType("resource").length);
  const before = [await text(page, ".time-chosen"), await asks(), await page.metrics()];
  await page.focus("#time input");
  const STEPS = 20;
  for (let i = 0; i < STEPS; i += 1) {
    await page.keyboard.press("ArrowRight");
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
  }
  const step_ms = (1000 * ((await page.metrics()).ScriptDuration - before[2].ScriptDuration)) / STEPS;
  console.log(`a step of the slider takes ${step_ms.toFixed(1)} ms of script`);
  assert.ok(step_ms < STEP_LIMIT_MS);
  assert.notEqual(await text(page, ".time-chosen"), before[0]);
  assert.equal(await asks(), before[1]);

  // The map by keys: zoomed, moved, and the place in the middle taken; a link shows the same.
  await page.evaluate(() => document.querySelector(".picture").focus());
  for (const key of ["+", "ArrowLeft", "ArrowUp", "+", "Enter"]) await page.keyboard.press(key);
  // The address is written a moment after the last key: it is whole once it stays the same.
  const settled = (of) =>
    until(of, () => {
      const is_same = window.hash_before === location.hash && Date.now() - window.hash_since > 500;
      if (window.hash_before !== location.hash) [window.hash_before, window.hash_since] = [location.hash, Date.now()];
      return is_same && location.hash.includes("place=") && location.hash.includes("map=");
    });
  await settled(page);
  const hash = await page.evaluate(() => location.hash);
  const other = await open(hash.slice(1));
  await shows_place(other);
  await settled(other);
  assert.equal(await other.evaluate(() => location.hash), hash);
  for (const where of [".time-chosen", ".place-part h2", ".facts"]) assert.equal(await text(other, where), await text(page, where));
  await other.close();

  // A place that no forecast reaches: once, in the server's words, with what to do.
  await page.evaluate((to) => (location.hash = to), "#panel=place&place=10,10");
  await until(page, () => document.querySelector(".place-part [role=status]").textContent.includes("Choose a place nearer"));
  assert.equal(await page.$(".place-part section:not([hidden], .models)"), null);
  await until(page, () => document.querySelector(".models").textContent.includes("No product is stored that reaches this place"));

  // The server goes and comes back; the page says so, and goes on by itself.
  await gone();
  await page.evaluate((to) => (location.hash = to), `#panel=place&place=${place.latitude_deg},${place.longitude_deg}`);
  await until(page, () => !document.querySelector("#notice").hidden);
  assert.match(await text(page, "#notice"), /does not answer.* last heard .*UTC/);
  assert.equal(await page.$eval(".top .status", (badge) => badge.dataset.status), "gone");
  await restart();
  await until(page, () => document.querySelector("#notice").hidden);
  await shows_place(page);
  await page.close();

  // Three widths, three palettes, three panels: nothing against it, nothing sticks out at the side.
  for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]])
    for (const [palette, panel] of [["day", "decide"], ["night", "place"], ["dusk", "what_if"], ["day", "place"]]) {
      page = await open(`palette=${palette}&panel=${panel}`, width, height);
      await page.waitForNetworkIdle({ timeout: IDLE_LIMIT_MS });
      await page.screenshot({ path: join(work, `${width}_${palette}_${panel}.png`) });
      await page.evaluate(axe);
      const [found, wide] = await page.evaluate(async () => [
        (await axe.run(document)).violations.map((it) => `${it.id}: ${it.nodes.map((node) => node.target).join(" ")}`),
        document.documentElement.scrollWidth,
      ]);
      console.log(`${width} px, ${palette}, ${panel}: ${found.join("; ") || "no faults"}`);
      assert.deepEqual(found, []);
      assert.ok(wide <= width, `${wide} px wide in ${width}`);
      await page.close();
    }
  assert.deepEqual(faults, []);
} finally {
  await browser.close();
  server.kill();
}
