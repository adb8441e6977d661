// Looks at a page in Chromium as somebody whom a planted text would harm: what was called, asked for, made or refused by the
// page's policy is a fault. Tells all that the page shows: its texts, the values of its fields, what its pictures are called.
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { read } from "./payloads.mjs";

export const LIMIT_MS = 60000; // generous: sanitizers, a machine that does other things too
export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

export function launch(modules) {
  const require = createRequire(join(resolve(modules), "/"));
  return require("puppeteer-core").launch({
    executablePath: process.env.SLACKWATER_BROWSER,
    args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
    timeout: 2 * LIMIT_MS,
    protocolTimeout: 2 * LIMIT_MS,
  });
}

/** Runs in the page before all else. */
function wait_for_harm() {
  window.harm = [];
  window.planted = (n) => window.harm.push(`field ${n} ran`);
  document.addEventListener("securitypolicyviolation", (event) =>
    window.harm.push(`against the policy: ${event.violatedDirective} ${event.blockedURI} ${event.sample}`),
  );
}

/** Runs in the page: what no page of ours has, and a payload would make. */
function harm_in_page() {
  const elements_of = "img[src=x], [src*='planted'], #implant, [onerror], [onload], [href^='javascript:' i]";
  const made = `${elements_of}, iframe, object, embed, base`;
  const elements = [...document.querySelectorAll(made)].map((it) => `an element: ${it.outerHTML.slice(0, 120)}`);
  const scripts = [...document.scripts].filter((it) => it.type !== "application/json" && it.text.includes("planted("));
  return [...window.harm, ...elements, ...scripts.map((it) => `a script: ${it.text.slice(0, 120)}`)];
}

/** Runs in the page: its texts, a line each. */
function shown_in_page() {
  const texts = [document.title];
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
  for (let it = walk.nextNode(); it; it = walk.nextNode()) {
    if (it.nodeType === Node.TEXT_NODE) {
      if (!["SCRIPT", "STYLE"].includes(it.parentNode.nodeName)) texts.push(it.data);
    } else {
      for (const name of ["aria-label", "title", "alt", "aria-valuetext", "placeholder"]) texts.push(it.getAttribute(name) ?? "");
      if ("value" in it && typeof it.value === "string") texts.push(it.value);
    }
  }
  return texts.join("\n");
}

export class Looker {
  faults = [];
  #seen = new Map();

  constructor(browser) {
    this.browser = browser;
  }

  /** Opens a page in a context of its own, which may ask nobody but where it is at home. */
  async open(name, address, home = address) {
    const page = await (await this.browser.createBrowserContext()).newPage();
    const fault = (what) => this.faults.push(`${name}: ${what}`);
    const { origin, protocol } = new URL(home);
    await page.setViewport({ width: 1100, height: 800 });
    await page.evaluateOnNewDocument(wait_for_harm);
    page.on("dialog", (dialog) => {
      fault(`a dialog: ${dialog.message()}`);
      dialog.dismiss().catch(() => {});
    });
    page.on("pageerror", (error) => fault(`it throws: ${error.message}`));
    // Chromium tells as an error, too, that a product has nothing at a place (404), or that a server is busy (503).
    page.on(
      "console",
      (said) => said.type() === "error" && !/status of (?:404|503)/u.test(said.text()) && fault(`it says: ${said.text()}`),
    );
    page.on("request", (request) => {
      const to = new URL(request.url());
      const is_own = protocol === "file:" ? to.protocol === "file:" : to.origin === origin;
      if (!(is_own || ["data:", "blob:"].includes(to.protocol)) || to.pathname.endsWith("/x")) fault(`asks for ${request.url()}`);
    });
    // Each page that is served forbids what it does not need.
    page.on("response", (answer) => {
      const told = answer.headers();
      if (!told["content-type"]?.startsWith("text/html") || protocol === "file:") return;
      if (!told["content-security-policy"]?.startsWith("default-src 'none'")) fault(`${answer.url()} has no policy`);
      if (told["x-content-type-options"] !== "nosniff") fault(`${answer.url()} may be sniffed`);
    });
    await page.goto(address, { timeout: LIMIT_MS });
    return page;
  }

  /** Notes what is shown now, and what has gone wrong until now. */
  async look(name, page) {
    for (const harm of await page.evaluate(harm_in_page)) this.faults.push(`${name}: ${harm}`);
    const shown = this.#seen.get(name) ?? "";
    this.#seen.set(name, `${shown}\n${read(await page.evaluate(shown_in_page))}`);
  }

  /** Opens, acts, looks, closes. */
  async visit(name, address, act = async () => {}) {
    const page = await this.open(name, address);
    await act(page);
    await this.look(name, page);
    await page.browserContext().close();
  }

  /** On which pages a text was seen. */
  where(text) {
    return [...this.#seen].filter(([, shown]) => shown.includes(read(text))).map(([name]) => name);
  }
}

/** Has each chart of a page that a command wrote tell what it tells under the mouse, in HTML. Gives how many tips came. */
export function tell_tips(page) {
  return page.evaluate(async () => {
    const charts = [...document.querySelectorAll("[_echarts_instance_]")].map((it) => echarts.getInstanceByDom(it));
    let tips = 0;
    for (const chart of charts)
      for (const [seriesIndex, { data = [] }] of (chart.getOption()?.series ?? []).entries())
        for (const dataIndex of new Set([0, Math.floor(data.length / 2)])) {
          chart.dispatchAction({ type: "showTip", seriesIndex, dataIndex });
          await new Promise((done) => setTimeout(done)); // what was made is asked for
          tips += [...chart.getDom().querySelectorAll("div")].some((it) => !it.querySelector("svg") && it.innerText !== "");
        }
    return tips;
  });
}
