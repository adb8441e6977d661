// scene_stills.mjs MODULES SCRIPT STYLE OUT: the pictures of the scene in the docs, drawn by Chromium.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const [modules, script, style, out] = process.argv.slice(2);
const require = createRequire(join(resolve(modules), "/"));
const browser = await require("puppeteer-core").launch({
  executablePath: process.env.SLACKWATER_BROWSER,
  args: ["--no-sandbox", "--disable-dev-shm-usage"],
});
const noon = { sun: { elevation_deg: 59, azimuth_deg: 164 }, seen_m: 8, slice_up_m: null, palette: "day" };
const stills = {
  day: { ...noon, chosen: 1, turn: [0.3, -0.1], closer: 0.25 },
  dusk: { ...noon, sun: { elevation_deg: 0, azimuth_deg: 313 }, chosen: 1, turn: [-1.6, -0.12], closer: 0.02 },
  under_water: { ...noon, chosen: 0, turn: [0.9, -0.1], closer: 1.5, seen_m: 15, slice_up_m: -12 },
  turbid: { ...noon, chosen: 0, turn: [0.9, -0.1], closer: 1, seen_m: 3 },
  night: { ...noon, sun: { elevation_deg: -12, azimuth_deg: 353 }, chosen: 1, turn: [0.3, -0.05], closer: 0.15, palette: "night" },
  table: { ...noon, chosen: 1, turn: [0, 0], closer: 1, is_table: true },
};
for (const [name, choice] of Object.entries(stills)) {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 720 });
  await page.setContent(
    `<!doctype html><title></title><style>${readFileSync(style, "utf8")}</style><body style="display: block; margin: 0">
    <div style="position: relative; width: 1280px; height: 720px"><canvas id="scene-canvas"></canvas><div class="scene-labels"></div></div>`,
  );
  await page.evaluate((asked) => (window.choice = asked), choice);
  await page.addScriptTag({ path: script });
  await page.waitForFunction(() => document.title === "drawn", { timeout: 60000 });
  await page.screenshot({ path: `${out}/scene_${name}.jpg`, type: "jpeg", quality: 80 });
  await page.close();
}
await browser.close();
