// From a hand, picture by picture, to what is asked of the camera.
//
// - Thumb and index pinched: where they are then is rest. Moved from there, the camera pans and
//   tilts that way, faster the farther.
// - Two fingers up: apart zooms in, together out.
// - All else is rest: an open hand, a fist, no hand, a hand that is not sure or jumps, a picture
//   that is old. A second hand is not looked at.
import { beyond } from '../../look/beyond';
import {
  MOST,
  NO_TURN,
  WISH_IS_VALID_MS,
  type CameraWish,
  type Turn,
} from '../../look/camera_wish';
import {
  at,
  distance,
  MIDDLE_KNUCKLE,
  pinch_point,
  size_of,
  spread_of,
  type Hand,
  type Point,
} from './hand';
import { eased } from './rate';
import { shape_of, type Shape } from './shape';

const LEAST_SURENESS = 0.7;
/** A shape is meant once it was seen in so many pictures one after the other. */
const PICTURES_TO_MEAN = 2;
/** How far a pinch is moved, in sizes of the hand. */
const MOVE_DEAD = 0.2;
const MOVE_FULL = 1.2;
/** How far two fingertips are apart, in sizes of the hand: of the middle between in and out. */
const SPREAD_MIDDLE = 0.4;
const SPREAD_DEAD = 0.12;
const SPREAD_FULL = 0.27;
const SMOOTHED_OVER_MS = 120;
/** From rest to the full rate. */
const RISE_MS = 400;
/** Between two pictures a hand moves and grows no more, in its own sizes. */
const MOST_JUMP = 1.5;
const MOST_GROWTH = 1.5;

export type Seen = Shape | 'none' | 'unsure' | 'jump';

export class Follower {
  seen: Seen = 'none';
  /** The camera's picture is as in a mirror already. */
  is_mirrored = false;
  private shape: Shape = 'other';
  private pictures = 0; // that have shown this shape, one after the other
  private anchor: { point: Point; size: number } | null = null;
  private smoothed: { point: Point; spread: number } | null = null;
  private last: { point: Point; size: number } | null = null;
  private picture_ms = Number.NEGATIVE_INFINITY;
  private turn: Turn = NO_TURN;

  /** @param picture_ms when the picture was taken, by the clock of `wish_at` */
  take(hand: Hand | null, picture_ms: number): void {
    const since_ms = picture_ms - this.picture_ms;
    if (!(since_ms > 0)) return;
    this.picture_ms = picture_ms;
    if (hand === null) return this.rest('none');
    const is_whole = hand.landmarks.length === 21 && hand.landmarks.every(is_finite);
    if (!is_whole || !(hand.sureness >= LEAST_SURENESS)) return this.rest('unsure');
    if (this.jumps(hand)) return this.rest('jump');
    const shape = shape_of(hand, this.shape);
    if (shape !== this.shape) {
      this.rest(shape);
      this.shape = shape;
    }
    this.seen = shape;
    this.pictures += 1;
    this.smooth(hand, since_ms);
    if (this.pictures >= PICTURES_TO_MEAN) this.follow(hand, since_ms);
  }

  wish_at(now_ms: number): CameraWish {
    const age_ms = now_ms - this.picture_ms;
    const is_of_now = age_ms <= WISH_IS_VALID_MS && age_ms >= 0;
    return is_of_now
      ? { ...this.turn, picture_ms: this.picture_ms }
      : { ...NO_TURN, picture_ms: now_ms };
  }

  /** The camera is off, or another one: nothing that was seen counts any more. */
  forget(): void {
    this.rest('none');
    this.picture_ms = Number.NEGATIVE_INFINITY;
  }

  private rest(seen: Seen): void {
    this.seen = seen;
    this.shape = 'other';
    this.pictures = 0;
    this.anchor = null;
    this.smoothed = null;
    this.turn = NO_TURN;
    if (seen === 'none' || seen === 'unsure') this.last = null;
  }

  /** Another hand than in the picture before, or another person's. */
  private jumps(hand: Hand): boolean {
    const before = this.last;
    const now = { point: at(hand, MIDDLE_KNUCKLE), size: size_of(hand) };
    this.last = now;
    if (before === null) return false;
    const growth = Math.max(now.size / before.size, before.size / now.size);
    return distance(now.point, before.point) > MOST_JUMP * before.size || !(growth <= MOST_GROWTH);
  }

  private smooth(hand: Hand, since_ms: number): void {
    const point = pinch_point(hand);
    const spread = spread_of(hand);
    if (this.smoothed === null) {
      this.smoothed = { point, spread };
      return;
    }
    const share = 1 - Math.exp(-since_ms / SMOOTHED_OVER_MS);
    const before = this.smoothed;
    this.smoothed = {
      point: {
        x: before.point.x + share * (point.x - before.point.x),
        y: before.point.y + share * (point.y - before.point.y),
      },
      spread: before.spread + share * (spread - before.spread),
    };
  }

  private follow(hand: Hand, since_ms: number): void {
    if (this.smoothed === null) return;
    const { point, spread } = this.smoothed;
    const change = since_ms / RISE_MS;
    const towards = (now: number, share: number, most: number): number =>
      eased(now, share * most, most * change);
    if (this.shape === 'pinch') {
      this.anchor ??= { point, size: size_of(hand) };
      const { anchor } = this;
      // The picture's right is the left of who stands before the camera, unless it is a mirror.
      const right = (this.is_mirrored ? 1 : -1) * (point.x - anchor.point.x);
      const up = anchor.point.y - point.y;
      const share = (offset: number): number => beyond(offset / anchor.size, MOVE_DEAD, MOVE_FULL);
      this.turn = {
        ...NO_TURN,
        pan_deg_s: towards(this.turn.pan_deg_s, share(right), MOST.pan_deg_s),
        tilt_deg_s: towards(this.turn.tilt_deg_s, share(up), MOST.tilt_deg_s),
      };
    } else if (this.shape === 'two') {
      const share = beyond(spread - SPREAD_MIDDLE, SPREAD_DEAD, SPREAD_FULL);
      const zoom_per_s = towards(this.turn.zoom_per_s, share, MOST.zoom_per_s);
      this.turn = { ...NO_TURN, zoom_per_s };
    }
  }
}

function is_finite(point: Point): boolean {
  return Number.isFinite(point.x) && Number.isFinite(point.y);
}
