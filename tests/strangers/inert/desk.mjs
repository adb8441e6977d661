// The desk at /: its three panels, with the lists that are folded away opened, and what was recorded before.
import { LIMIT_MS } from "./look.mjs";

const PANELS = { decide: ".tasks > li", place: ".facts dd", what_if: ".limit-list input" };

async function unfold(page) {
  await page.$$eval("details", (all) => all.forEach((it) => (it.open = true)));
  await page.waitForNetworkIdle({ timeout: LIMIT_MS, idleTime: 300 });
}

export async function look_at_desk(looker, address) {
  const page = await looker.open("desk", `${address}/#site=planted&panel=decide`);
  for (const [panel, what] of Object.entries(PANELS)) {
    await page.evaluate((panel) => (location.hash = `site=planted&panel=${panel}`), panel);
    await page.waitForSelector(what, { timeout: LIMIT_MS });
    await unfold(page);
    await looker.look(`desk, ${panel}`, page);
  }
  await page.browserContext().close();
}
