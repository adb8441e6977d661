// in_browser.mjs MODULES SCRIPT [MINUTES]: runs the script in Chromium. It leaves {said, fault} as JSON in the title; a fault, or an
// error that nobody caught, fails. MINUTES: how long its session is (drawn_long.ts); it may take the longer.
import { strict as assert } from "node:assert";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, script, told] = process.argv.slice(2);
const minutes = Number(told ?? 0);
const LIMIT_MS = 120000 + 6000 * minutes; // generous: the machine of a test is busy with something else, too
const require = createRequire(join(resolve(modules), "/"));
const browser = await require("puppeteer-core").launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  args: ["--no-sandbox", "--disable-dev-shm-usage"],
  protocolTimeout: LIMIT_MS,
});
const page = await browser.newPage();
let thrown = "";
page.on("pageerror", (error) => (thrown ||= error.message));
page.on("console", (said) => (thrown ||= said.type() === "error" ? said.text() : ""));
await page.setContent("<!doctype html><title></title>");
const devtools = await page.createCDPSession();
await page.exposeFunction("heap_bytes", async () => {
  await devtools.send("HeapProfiler.collectGarbage");
  return (await devtools.send("Runtime.getHeapUsage")).usedSize;
});
await page.evaluate((told) => (window.minutes = told), minutes);
await page.addScriptTag({ path: script });
await page.waitForFunction(() => document.title !== "", { timeout: LIMIT_MS, polling: 100 }).catch(() => {});
const title = await page.title();
await browser.close();
assert.equal(thrown, "");
assert.notEqual(title, "", "it did not end");
const { said, fault } = JSON.parse(title);
console.log(said);
assert.equal(fault, "");
