// in_browser.mjs MODULES SCRIPT: runs the script in Chromium. It leaves {said, fault} as JSON in the title; a fault, or an error
// that nobody caught, fails.
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
let thrown = "";
page.on("pageerror", (error) => (thrown ||= error.message));
page.on("console", (said) => (thrown ||= said.type() === "error" ? said.text() : ""));
await page.setContent("<!doctype html><title></title>");
await page.addScriptTag({ path: script });
await page.waitForFunction(() => document.title !== "", { timeout: 60000 }).catch(() => {});
const title = await page.title();
await browser.close();
assert.equal(thrown, "");
assert.notEqual(title, "", "it did not end");
const { said, fault } = JSON.parse(title);
console.log(said);
assert.equal(fault, "");
