// A telephone beside a desk and a headset: it takes the helm from the desk, drives by touch, and looks about in the scene.
import { strict as assert } from "node:assert";
import { isZero, near, sleep } from "./people_in_a_session.mjs";

export const TELEPHONE = { width: 390, height: 844, isMobile: true, hasTouch: true };
const LIMIT_MS = 30000;

/** Ann drives, Hal looks on with a headset, Pia has the telephone. */
export async function telephone_drives(ann, hal, pia) {
  await pia.press("Ask for the helm");
  await ann.press("Grant");
  await pia.reads(".helm-state", /^You drive/);
  await hal.reads(".helm-state", /^Pia drives/);
  const ring = await pia.page.waitForSelector(".touch-stick .ring", { visible: true, timeout: LIMIT_MS });
  await ring.scrollIntoView();
  const { x, y, width, height } = await ring.boundingBox();
  const [middle, upper] = [{ x: x + width / 2, y: y + height / 2 }, { x: x + width / 2, y: y + 0.1 * height }];
  const since_ms = await pia.now();
  await pia.page.touchscreen.touchStart(middle.x, middle.y);
  await pia.page.touchscreen.touchMove(upper.x, upper.y);
  const driven = await pia.says("stick", since_ms, (it) => it.velocity[0] > 0.1);
  await hal.until("a vehicle that moves", () => parseFloat(document.querySelector(".vehicles tbody td:nth-of-type(3)").textContent) >= 0.1);
  await pia.page.touchscreen.touchEnd();
  await sleep(400);
  assert(isZero((await pia.said("stick")).at(-1)), "the last stick");
  await pia.press("Give back");

  await pia.press("Scene");
  const before = await pia.says("look", since_ms);
  const canvas = await pia.page.$("#scene-canvas");
  await canvas.scrollIntoView();
  const box = await canvas.boundingBox();
  const across = { y: box.y + box.height / 2, from: box.x + 0.3 * box.width, to: box.x + 0.3 * box.width + 100 };
  await pia.page.touchscreen.touchStart(across.from, across.y);
  await pia.page.touchscreen.touchMove(across.to, across.y);
  await pia.page.touchscreen.touchEnd();
  // 100 pixels are 0.6 radians (scene_panel.ts).
  const turn_deg = (100 * 0.006 * 180) / Math.PI;
  const turned = await pia.says("look", since_ms, (it) => Math.abs(it.heading_deg - before.heading_deg) > 2);
  const by_deg = Math.abs(((turned.heading_deg - before.heading_deg + 540) % 360) - 180);
  near(by_deg, turn_deg, 1, "turned by a finger, degrees");
  return `${driven.velocity[0]} m/s; a finger turns the view by ${by_deg} degrees`;
}
