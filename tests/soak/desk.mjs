// desk.mjs MODULES PROGRAM STORE MINUTES SITES: see `desk` beside it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, program, store, minutes, sites] = process.argv.slice(2);
const puppeteer = createRequire(join(resolve(modules), "package.json"))("puppeteer-core");

const LIMIT_MS = 120_000;
const USABLE_LIMIT_MS = 10_000; // on the slow link; 2 s on loopback
const MOST_GROWTH = 0.1; // of the page's memory, from the first third to the end
const SERVER_GROWTH_BYTES = 20e6;
// A telephone at the edge of its cell: Chromium's "Slow 4G" is 1.6 Mbit/s and 150 ms.
const SLOW_LINK = { download: (1.6e6 / 8) * 0.9, upload: (0.75e6 / 8) * 0.9, latency: 150 };
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

async function serve(...more) {
  const server = spawn(program, ["--store", store, "serve", "--port", "0", ...more]);
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
const sites_of = async (address) => (await (await fetch(`${address}/sites`)).json()).sites;

// A demonstration is of a past day: the server's clock stands an hour after its issue.
let { server, address } = await serve();
const { forecast } = (await sites_of(address)).find((site) => site.forecast !== null);
server.kill();
const at = new Date(Date.parse(forecast.issued) + 3_600_000).toISOString().replace(/\.\d+Z$/, "Z");
({ server, address } = await serve("--at", at));
const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu", "--js-flags=--expose-gc"],
});
const server_bytes = () =>
  1024 * Number(/VmRSS:\s*(\d+)/.exec(readFileSync(`/proc/${server.pid}/status`, "utf8"))[1]);

try {
  // Usable: the hour can be moved and numbers of a place are there.
  async function opened(page) {
    const from_ms = Date.now();
    await page.goto(`${address}/#panel=place`, { timeout: LIMIT_MS });
    await page.waitForSelector("#time input", { timeout: LIMIT_MS });
    await page.waitForSelector(".facts dd", { timeout: LIMIT_MS });
    return Date.now() - from_ms;
  }
  const slow = await browser.newPage();
  await slow.setViewport({ width: 390, height: 844, isMobile: true, hasTouch: true });
  await slow.emulateNetworkConditions(SLOW_LINK);
  const slow_ms = await opened(slow);
  console.log(`usable on a slow link after ${(slow_ms / 1000).toFixed(1)} s`);
  assert.ok(slow_ms < USABLE_LIMIT_MS);
  await slow.close();

  const page = await browser.newPage();
  await page.setViewport({ width: 1440, height: 900 });
  const faults = [];
  page.on("pageerror", (error) => faults.push(error.message));
  console.log(`usable from this machine after ${((await opened(page)) / 1000).toFixed(1)} s`);
  assert.ok((await sites_of(address)).length > Number(sites));
  await page.evaluate(() => document.getElementById("tab-decide").click());
  await page.waitForSelector(".board summary", { timeout: LIMIT_MS });
  await page.evaluate(() => document.querySelector(".board summary").click());
  const listed = (most) => document.querySelectorAll(".board tbody").length > most;
  await page.waitForFunction(listed, { timeout: LIMIT_MS }, Number(sites));

  // A minute of somebody's morning: hours, panels, places, the map.
  async function used() {
    for (const panel of ["decide", "place", "what_if", "place"]) {
      await page.evaluate((of) => document.getElementById(`tab-${of}`).click(), panel);
      await page.focus("#time input");
      for (let i = 0; i < 12; i += 1) await page.keyboard.press(i % 3 === 2 ? "ArrowLeft" : "ArrowRight");
      await page.evaluate(() => document.querySelector(".picture").focus());
      for (const key of ["+", "ArrowLeft", "Enter", "-", "ArrowRight", "Enter"]) await page.keyboard.press(key);
      await sleep(15_000);
    }
  }
  async function heap_bytes() {
    await page.evaluate(() => gc());
    return (await page.metrics()).JSHeapUsedSize;
  }
  const nodes = async () => (await page.metrics()).Nodes;
  const rounds = Number(minutes);
  let first;
  for (let round = 1; round <= rounds; round += 1) {
    await used();
    const now = { heap: await heap_bytes(), nodes: await nodes(), server: server_bytes() };
    const mb = (bytes) => (bytes / 1e6).toFixed(1);
    console.log(`${round} min: page ${mb(now.heap)} MB, ${now.nodes} nodes; server ${mb(now.server)} MB`);
    if (round === Math.max(1, Math.floor(rounds / 3))) first = now;
    if (round < rounds) continue;
    assert.ok(now.heap < first.heap * (1 + MOST_GROWTH), "the page's memory grows");
    assert.ok(now.nodes < first.nodes * (1 + MOST_GROWTH), "the page's nodes grow");
    assert.ok(now.server < first.server + SERVER_GROWTH_BYTES, "the server's memory grows");
  }
  assert.deepEqual(faults, []);
} finally {
  await browser.close();
  server.kill();
}
