// sessions_page.mjs MODULES ADDRESS WORK: at the server at ADDRESS a supervisor begins sessions with the page in Chromium as it is
// (puppeteer-core, axe-core), and an operator chooses among them. WORK has the scenarios, one of which is broken on the way.
import { strict as assert } from "node:assert";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, address, work] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const puppeteer = require("puppeteer-core");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const SUE = "sue-0123456789abcdef";
const ANN = "ann-0123456789abcdef";
const LIMIT_MS = 30000; // generous: sanitizers, two cores

const browser = await puppeteer.launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  args: ["--no-sandbox", "--disable-dev-shm-usage"],
});

async function openPage(query = "") {
  const page = await (await browser.createBrowserContext()).newPage();
  page.on("pageerror", (error) => {
    console.error("the page throws", error);
    process.exit(1);
  });
  await page.goto(`${address}/session${query}`);
  await until(page, "the buttons to begin", () => document.querySelectorAll("[aria-label='Begin a session'] button").length === 2);
  return page;
}

async function until(page, what, look, ...given) {
  const found = await page.waitForFunction(look, { timeout: LIMIT_MS, polling: 50 }, ...given).catch(async () => {
    const shown = await page.evaluate(() => document.querySelector("form.join")?.innerText);
    throw new Error(`${what} did not come; the page shows: ${shown}`);
  });
  return found.jsonValue();
}

const typeToken = async (page, token) => {
  await page.$eval("form.join input[type=password]", (it) => (it.value = ""));
  await page.type("form.join input[type=password]", token);
};
const begin = (page, name) =>
  page.evaluate((name) => {
    [...document.querySelectorAll("button")].find((it) => it.textContent === `Begin ${name}`).click();
  }, name);
const problem = (page, words) =>
  until(page, words, (words) => {
    const it = document.querySelector("form.join .problem");
    return !it.hidden && it.textContent.includes(words) && it.textContent;
  }, words);
const chosen = (page, id, state) =>
  until(page, `${id}, ${state}`, (id, state) => {
    const option = document.querySelector("form.join select").selectedOptions[0];
    return option?.value === id && option.textContent.includes(state) && option.textContent;
  }, id, state);

const sue = await openPage();
await problem(sue, "There is no session now. With the token of a supervisor you may begin one.");

await typeToken(sue, ANN);
await begin(sue, "The dawn");
console.log(`who may not begin one is told so: ${await problem(sue, "your role is operator")}`);

await typeToken(sue, SUE);
await begin(sue, "The dawn");
console.log(`a session is begun and chosen: ${await chosen(sue, "dawn", "running")}`);
assert.equal(await sue.$eval("form.join .problem", (it) => it.hidden), true, "what was wrong is wrong no more");
await begin(sue, "The dusk");
console.log(`and another: ${await chosen(sue, "dusk", "running")}`);
await begin(sue, "The dawn");
console.log(`the next run of the first is told from it by its id: ${await chosen(sue, "dawn-2", "The dawn, dawn-2 (running")}`);
await begin(sue, "The dusk");
console.log(`no more than may be: ${await problem(sue, "found 3 sessions under way")}`);

// An address names the session; the token is typed.
const ann = await openPage("?session=dusk");
await chosen(ann, "dusk", "running");
await typeToken(ann, ANN);
await ann.click("form.join button[type=submit]");
await until(ann, "a seat", () => document.documentElement.dataset.link === "seated");
const seen = await until(ann, "its vehicle", () => document.body.innerText.match(/rov of \w+/)?.[0]);
assert.equal(seen, "rov of dusk");
console.log(`an operator sits in the one that the address names, and sees ${seen}`);
assert.ok(!(await ann.evaluate(() => location.href)).includes("0123456789abcdef"), "no token in an address");

// It ends under her; a run that fails says why to whoever began it.
const ended = await fetch(`${address}/sessions/dusk/end`, { method: "POST", headers: { Authorization: `Bearer ${SUE}` } });
assert.equal(ended.status, 202);
console.log(`whose run has ended is told so: ${await problem(ann, "over")}`);
// Its place is free once its log is written.
const state = async () => (await (await fetch(`${address}/sessions/dusk`)).json()).state;
for (const since = Date.now(); (await state()) !== "over"; ) assert.ok(Date.now() < since + LIMIT_MS, "dusk does not end");
writeFileSync(join(work, "dawn.yaml"), "name: The dawn\nseed: many\n");
await begin(sue, "The dawn");
console.log(`a run that fails says why: ${await problem(sue, "seed: found 'many'")}`);

await sue.evaluate(axe);
const { violations } = await sue.evaluate(() => window.axe.run());
assert.deepEqual(violations.map((it) => it.id), []);
console.log("axe-core finds nothing");
await browser.close();
