// From what a hand before a webcam wishes (api/web/hands) to orders to the camera.
//
// - A wish counts for 0.3 s from the moment of its picture, however long it was on its way: where
//   none comes the camera stands. Times are of the clock that all windows share.
// - Where nothing may be sent nothing is kept for later, and after it the hand has to rest once.
// - Each order is a row of the record: so many a second at most, and none that changes nothing.
import {
  is_rest,
  NO_TURN,
  WISH_IS_VALID_MS,
  type CameraWish,
  type Turn,
} from '../../look/camera_wish';
import type { CameraPointing } from '../session/message';

export const ORDER_EVERY_MS = 250;
const LEAST_TURN_DEG = 0.1;
const LEAST_ZOOM = 0.01;
/** A page that slept did not turn the camera meanwhile. */
const LONGEST_STEP_MS = 100;
/** The server has told by then where an order left the camera. */
const TOLD_BY_MS = 1500;

export class CameraHand {
  private wish: Turn = NO_TURN;
  private picture_ms = Number.NEGATIVE_INFINITY; // of the wish
  private must_rest = false;
  private turned: CameraPointing | null = null; // where the hand has it, while it moves
  private sent: CameraPointing | null = null;
  private sent_ms = Number.NEGATIVE_INFINITY;
  private tick_ms = Number.NaN;

  take(wish: CameraWish, now_ms: number): void {
    this.wish = wish;
    this.picture_ms = Math.min(wish.picture_ms, now_ms); // nothing counts from later on
    if (is_rest(wish)) this.must_rest = false;
  }

  /** The hand has to rest before it counts again: refused, or there is another vehicle. */
  drop(): void {
    this.must_rest = true;
    this.turned = null;
    this.sent = null;
  }

  /** Another hand of this station has turned the camera: what comes next begins there. */
  overrule(camera: CameraPointing, now_ms: number): void {
    this.drop();
    this.sent = { ...camera };
    this.sent_ms = now_ms;
  }

  has_to_rest(): boolean {
    return this.must_rest;
  }

  is_turning(): boolean {
    return this.turned !== null;
  }

  /**
   * What is to be sent now, or null.
   * @param may an order may be sent
   * @param camera where it looks, as the server has it
   */
  tick(now_ms: number, may: boolean, camera: CameraPointing | null): CameraPointing | null {
    const step_ms = now_ms - this.tick_ms;
    const step_s = Math.min(step_ms > 0 ? step_ms : 0, LONGEST_STEP_MS) / 1000;
    this.tick_ms = now_ms;
    const is_old = now_ms - this.picture_ms > WISH_IS_VALID_MS;
    const wish = is_old ? NO_TURN : this.wish;
    if (!may || camera === null) {
      if (!is_rest(wish)) this.must_rest = true;
      this.turned = null;
      return null;
    }
    if (is_rest(wish) || this.must_rest) {
      this.turned = null;
      return null;
    }
    if (this.turned === null) {
      const is_told = this.sent === null || now_ms - this.sent_ms > TOLD_BY_MS;
      this.sent = is_told ? { ...camera } : this.sent;
      this.turned = { ...(this.sent ?? camera) };
    }
    this.turned = turned_on(this.turned, wish, step_s);
    if (now_ms - this.sent_ms < ORDER_EVERY_MS || is_same(this.turned, this.sent)) return null;
    this.sent = { ...this.turned };
    this.sent_ms = now_ms;
    return this.sent;
  }
}

function turned_on(from: CameraPointing, wish: Turn, step_s: number): CameraPointing {
  const within = (value: number, low: number, high: number): number =>
    Math.min(Math.max(value, low), high);
  return {
    pan_deg: within(from.pan_deg + wish.pan_deg_s * step_s, -180, 180),
    tilt_deg: within(from.tilt_deg + wish.tilt_deg_s * step_s, -90, 90),
    zoom: within(from.zoom * Math.exp(wish.zoom_per_s * step_s), 1, 10),
  };
}

function is_same(a: CameraPointing, b: CameraPointing | null): boolean {
  return (
    b !== null &&
    Math.abs(a.pan_deg - b.pan_deg) < LEAST_TURN_DEG &&
    Math.abs(a.tilt_deg - b.tilt_deg) < LEAST_TURN_DEG &&
    Math.abs(a.zoom - b.zoom) < LEAST_ZOOM
  );
}
