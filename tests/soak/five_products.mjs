// five_products.mjs MODULES PROGRAM STORE MAKE FOLDER: see `five-products` beside it.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, program, store, make, folder] = process.argv.slice(2);
const puppeteer = createRequire(join(resolve(modules), "package.json"))("puppeteer-core");

const LIMIT_MS = 120_000;
const FIRST_VIEW_BYTES = 400_000; // as it is sent, without the coast
const WHOLE_BYTES = 1_500_000; // and with it, until the page rests
const USABLE_MS = 2_000;
const STEP_MS = 50; // of script
const MODELS_MS = 4_000; // from the page's beginning until every product stands in the tables
const STEPS = 40;
const PRODUCTS = 5;

async function serve(...more) {
  const server = spawn(program, ["--store", store, "serve", "--port", "0", ...more]);
  let said = "";
  server.stdout.on("data", (data) => (said += data));
  server.stderr.on("data", (data) => (said += data));
  for (let waited_ms = 0; waited_ms < LIMIT_MS; waited_ms += 50) {
    const address = /http:\/\/127\.0\.0\.1:\d+/.exec(said)?.[0];
    if (address && (await fetch(address).catch(() => null))) return { server, address };
    await new Promise((done) => setTimeout(done, 50));
  }
  server.kill("SIGKILL");
  throw new Error(`the server did not begin: ${said}`);
}
const json = async (url) => (await fetch(url)).json();

// The files are of the hours of the forecast; the server's clock stands an hour after its issue.
let { server, address } = await serve();
const { forecast, place } = (await json(`${address}/sites`)).sites.find((it) => it.forecast !== null);
server.kill();
execFileSync(make, [folder, String(place.latitude_deg), String(place.longitude_deg), forecast.valid_from]);
const files = readdirSync(folder).map((name) => join(folder, name));
assert.equal(files.length, PRODUCTS);
execFileSync(program, ["--store", store, "ingest", ...files]);
const at = new Date(Date.parse(forecast.issued) + 3_600_000).toISOString().replace(/\.\d+Z$/, "Z");
({ server, address } = await serve("--at", at));
const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu"],
});
const { collections } = await json(`${address}/collections`);
const stored = collections.filter(({ keywords }) => keywords.includes("product")).length;
const faults = [];
/** Prints a figure beside its budget, and keeps what is beyond it for the end. */
function held(what, value, most, unit) {
  console.log(`${what}: ${value.toFixed(value < 10 ? 1 : 0)} ${unit} (at most ${most})`);
  if (!(value <= most)) faults.push(`${what}: ${value} ${unit}, at most ${most}`);
}

try {
  const page = await browser.newPage();
  await page.setViewport({ width: 1440, height: 900 });
  page.on("pageerror", (error) => faults.push(error.message));
  const network = await page.createCDPSession();
  await network.send("Network.enable");
  const url_of = new Map();
  const sent = []; // [url, bytes]
  network.on("Network.responseReceived", ({ requestId, response }) => url_of.set(requestId, response.url));
  network.on("Network.loadingFinished", ({ requestId, encodedDataLength }) =>
    sent.push([url_of.get(requestId) ?? "", encodedDataLength]));
  const bytes = (of = () => true) => sent.filter(([url]) => of(url)).reduce((sum, [, some]) => sum + some, 0);
  const is_page = (url) => new URL(url).pathname === "/" || /\/desk\/page\.(js|css)$/.test(url);

  const from_ms = performance.now();
  await page.goto(`${address}/#panel=place&depth=10`, { timeout: LIMIT_MS });
  await page.waitForSelector(".facts dd", { timeout: LIMIT_MS });
  const usable_ms = performance.now() - from_ms;
  // What the store had before stands there too.
  await page.waitForFunction(
    (all, least) => {
      const says = [...document.querySelectorAll(".models tbody tr")].map((row) => row.children[1]?.textContent ?? "");
      return says.length >= all && says.filter((text) => / m/.test(text)).length >= least;
    },
    { timeout: LIMIT_MS, polling: 20 },
    stored,
    PRODUCTS,
  );
  const models_ms = performance.now() - from_ms;
  await page.waitForNetworkIdle({ timeout: LIMIT_MS });

  const before = await page.metrics();
  const chosen = await page.$eval(".time-chosen", (it) => it.textContent);
  await page.focus("#time input");
  let longest_ms = 0;
  let last = before.ScriptDuration;
  for (let i = 0; i < STEPS; i += 1) {
    await page.keyboard.press(i < STEPS - 5 ? "ArrowRight" : "ArrowLeft");
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
    const { ScriptDuration } = await page.metrics();
    longest_ms = Math.max(longest_ms, 1000 * (ScriptDuration - last));
    last = ScriptDuration;
  }
  assert.notEqual(await page.$eval(".time-chosen", (it) => it.textContent), chosen);
  const rows = await page.$$eval(".models tbody tr", (all) => all.map((row) => row.textContent));
  console.log(`${rows.length} rows of models`);
  held("the page itself, as sent", bytes(is_page) / 1000, FIRST_VIEW_BYTES / 1000, "kB");
  held("all until it rests, as sent", bytes() / 1000, WHOLE_BYTES / 1000, "kB");
  held("usable after", usable_ms, USABLE_MS, "ms");
  held("a step of the slider, mean", (1000 * (last - before.ScriptDuration)) / STEPS, STEP_MS, "ms");
  held("a step of the slider, longest", longest_ms, 2 * STEP_MS, "ms");
  held("models side by side after", models_ms, MODELS_MS, "ms");
  assert.deepEqual(faults, []);
} finally {
  await browser.close();
  server.kill();
}
