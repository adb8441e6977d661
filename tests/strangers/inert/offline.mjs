// The pages that commands write, opened from their files, with the tips of their charts.
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { tell_tips } from "./look.mjs";

// Whether it has charts.
const PAGES = { forecast: true, report: false, verify: true, check: true, run: true, rehearsal: true, inspection: true, seen: false };

export async function look_offline(looker, work) {
  for (const [name, has_charts] of Object.entries(PAGES)) {
    const told = async (page) => {
      if (has_charts && (await tell_tips(page)) === 0) looker.faults.push(`${name}.html: no chart has told a tip`);
    };
    await looker.visit(`${name}.html`, pathToFileURL(join(work, `${name}.html`)).href, told);
  }
}
