// drawn_sea.mjs MODULES SCRIPT: runs the script in Chromium, and holds what it found to within 1 cm.
import { strict as assert } from "node:assert";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, script] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const browser = await require("puppeteer-core").launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  args: ["--no-sandbox", "--disable-dev-shm-usage"],
});
const page = await browser.newPage();
let fault = "";
page.on("pageerror", (error) => (fault = error.message));
page.on("console", (said) => (fault ||= said.type() === "error" ? said.text() : ""));
await page.setContent("<!doctype html><title></title>");
await page.addScriptTag({ path: script });
await page.waitForFunction(() => document.title !== "", { timeout: 60000 }).catch(() => {});
const title = await page.title();
await browser.close();
assert.equal(fault, "");
const found = JSON.parse(title);
assert.equal(found.length, 18);
const most_m = Math.max(...found.map((it) => Math.abs(it.drawn_m - it.is_m)));
const height_m = Math.max(...found.map((it) => Math.abs(it.is_m)));
console.log(`18 heights of up to ${height_m.toFixed(2)} m, drawn within ${(1000 * most_m).toFixed(1)} mm`);
assert(height_m > 0.5, "a sea that hardly moves proves nothing");
assert(most_m < 0.01, JSON.stringify(found));
