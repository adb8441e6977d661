// session_behind_tls.mjs MODULES ADDRESS WORK: a pilot at the page of ADDRESS (https), in Chromium; and a page of another origin.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { createHash, X509Certificate } from "node:crypto";
import { createRequire } from "node:module";
import { request } from "node:https";
import { join, resolve } from "node:path";

const [modules, address, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const TOKEN = "ann-0123456789abcdef";
const LIMIT_MS = 30000; // generous: sanitizers, two cores
const certificate = readFileSync(join(work, "cert.pem"));

/** The status that a handshake of this origin gets. */
function shake_hands(origin) {
  return new Promise((done, fail) => {
    const asked = request(`${address}/sessions/run/socket`, {
      ca: certificate,
      headers: {
        Origin: origin,
        Connection: "Upgrade",
        Upgrade: "websocket",
        "Sec-WebSocket-Version": "13",
        "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
        "Sec-WebSocket-Protocol": `slackwater.session.v1, bearer.${TOKEN}`,
      },
    });
    asked.on("response", (answer) => (answer.resume(), done(answer.statusCode)));
    asked.on("upgrade", (answer, socket) => (socket.destroy(), done(answer.statusCode)));
    asked.on("error", fail);
    asked.end();
  });
}
assert.equal(await shake_hands("https://evil.example"), 403);
assert.equal(await shake_hands(address), 101);

// Chromium trusts this one key: the certificate is checked, not waved through.
const key = new X509Certificate(certificate).publicKey.export({ type: "spki", format: "der" });
const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  userDataDir: join(work, "browser"),
  timeout: 2 * LIMIT_MS,
  args: [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    `--ignore-certificate-errors-spki-list=${createHash("sha256").update(key).digest("base64")}`,
  ],
});
try {
  const page = await browser.newPage();
  await page.evaluateOnNewDocument(() => {
    window.sockets = [];
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (data) {
      if (!window.sockets.includes(this.url)) window.sockets.push(this.url);
      return send.call(this, data);
    };
  });
  await page.goto(`${address}/session`);
  await page.waitForSelector("form.join option", { timeout: LIMIT_MS });
  await page.type("form.join input[type=text]", "Ann");
  await page.type("form.join input[type=password]", TOKEN);
  await page.click("form.join button[type=submit]");
  const until = (look, ...given) => page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given);
  await until(() => document.documentElement.dataset.link === "seated");
  const press = (text) =>
    until((text) => {
      const button = [...document.querySelectorAll("button")].find((it) => it.textContent === text && !it.disabled);
      button?.click();
      return Boolean(button);
    }, text);
  await press("Ask for the helm");
  await until(() => /^You drive/.test(document.querySelector(".helm-state")?.textContent ?? ""));
  await press("HOLD");
  await until(() => /HOLD .*taken at step/.test(document.querySelector("#notice").textContent));
  const sockets = await page.evaluate(() => window.sockets);
  assert.ok(sockets.length > 0 && sockets.every((url) => url.startsWith("wss://")), String(sockets));
} finally {
  await browser.close();
}
