// behind_a_proxy.mjs MODULES WORK SERVE LIVE WATCH: the pages behind nginx (ports of its doors), in Chromium, by somebody who knows the password.
import { strict as assert } from "node:assert";
import { createHash, X509Certificate } from "node:crypto";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, work, serve, live, watch] = process.argv.slice(2);
const puppeteer = createRequire(join(resolve(modules), "/"))("puppeteer-core");
const LIMIT_MS = 60000; // generous: sanitizers, two cores
const at = (port, path) => `https://ocean.example.org:${port}${path}`;

// Chromium trusts this one key: the certificate is checked, not waved through.
const certificate = readFileSync(join(work, "nginx/certificate.pem"));
const key = new X509Certificate(certificate).publicKey.export({ type: "spki", format: "der" });
const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  userDataDir: join(work, "browser"),
  timeout: LIMIT_MS,
  args: [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--host-resolver-rules=MAP ocean.example.org 127.0.0.1",
    `--ignore-certificate-errors-spki-list=${createHash("sha256").update(key).digest("base64")}`,
  ],
});

/** A page at this door; what of it was refused (404 is an answer), and what its scripts complained of. */
async function opened(port, path) {
  const page = await browser.newPage();
  const refused = [];
  page.on("response", (answer) => answer.status() >= 400 && answer.status() !== 404 && refused.push(`${answer.status()} ${answer.url()}`));
  page.on("pageerror", (problem) => refused.push(String(problem)));
  await page.goto(at(port, path), { waitUntil: "load", timeout: LIMIT_MS });
  return { page, refused };
}
const until = (page, look, ...given) =>
  page.waitForFunction(look, { timeout: LIMIT_MS, polling: 100 }, ...given);

try {
  const stranger = await browser.newPage();
  const answer = await stranger.goto(at(serve, "/")).catch((problem) => problem);
  assert.ok(!(answer?.status?.() === 200), "the desk opens without a password");
  await stranger.close();

  // The password is typed once a door; the browser knows it from then on, for scripts as well.
  for (const port of [serve, live, watch]) {
    const page = await browser.newPage();
    await page.authenticate({ username: "anna", password: "a-word-for-tests" });
    await page.goto(at(port, "/session/page.css"), { timeout: LIMIT_MS });
    await page.close();
  }

  const desk = await opened(serve, "/");
  await until(desk.page, () => document.querySelectorAll("#map svg, #map canvas").length > 0);
  assert.deepEqual(desk.refused, []);
  await desk.page.close();

  const seat = await opened(live, "/session");
  await seat.page.waitForSelector("form.join option", { timeout: LIMIT_MS });
  await seat.page.type("form.join input[type=text]", "Bob");
  await seat.page.type("form.join input[type=password]", "bob-0123456789abcdef");
  await seat.page.click("form.join button[type=submit]");
  await until(seat.page, () => document.documentElement.dataset.link === "seated");
  assert.deepEqual(seat.refused, []);
  await seat.page.close();

  const log = await opened(watch, "/session");
  await until(log.page, () => document.documentElement.dataset.link === "seated");
  assert.deepEqual(log.refused, []);
  console.log("the desk, a seat in a run and a log open in Chromium behind nginx");
} finally {
  await browser.close();
}
