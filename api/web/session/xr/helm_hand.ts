// A hand in the headset as a hand on the session's stick. Squeezed, a controller's thumb-sticks
// lean it, as those of a gamepad do; a bare hand that pinches leans it by how far it was moved and
// turned since. It tells the one Stick that keys and gamepads tell; who may send what is known
// there. What an axis of a controller means hangs on how many there are: where one comes or goes in
// the middle of a squeeze, the hand is lost.
import { Quaternion, Vector3 } from 'three';
import { beyond } from '../../look/beyond';
import { beyond_dead_zone } from '../drive/gamepad';
import { NO_LEAN, type Lean, type Stick } from '../drive/stick';
import { SIDES, type HandReading, type Side } from './reading';

const OLDEST_MS = 500; // of a frame of the headset; a loop that stalls is a hand that is gone
const REST_M = 0.02;
const FULL_M = 0.12;
const REST_RAD = 0.14;
const FULL_RAD = 0.7;

const seen_controllers = (hands: readonly HandReading[]): HandReading[] =>
  hands.filter((it) => it.kind === 'controller' && it.is_tracked);

/** Left stick ahead and turn, right stick sideways and up and down; one alone ahead and turn. */
export function controllers_lean(hands: readonly HandReading[]): Lean {
  const there = seen_controllers(hands);
  const right = there.length > 1 ? there.find((it) => it.side === 'right') : undefined;
  const left = there.find((it) => it !== right);
  const axis = (value: number | undefined): number => beyond_dead_zone(value ?? 0);
  return {
    surge: axis(left?.stick.up),
    yaw: axis(left?.stick.right),
    sway: axis(right?.stick.right),
    heave: 0 - axis(right?.stick.up),
  };
}

export interface PinchedFrom {
  at: Vector3;
  turned: Quaternion;
  ahead_rad: number; // where the head looked, against the clock
}

/** Ahead, right and down of who pinches; the wrist's turn about the vertical is the vehicle's. */
export function moved_lean(from: PinchedFrom, at: Vector3, turned: Quaternion): Lean {
  const moved = at.clone().sub(from.at);
  moved.applyAxisAngle(new Vector3(0, 1, 0), -from.ahead_rad);
  const since = turned.clone().multiply(from.turned.clone().invert());
  const twist_rad = 2 * Math.atan2(since.y, since.w);
  const within_rad = Math.atan2(Math.sin(twist_rad), Math.cos(twist_rad));
  return {
    surge: beyond(0 - moved.z, REST_M, FULL_M),
    sway: beyond(moved.x, REST_M, FULL_M),
    heave: beyond(0 - moved.y, REST_M, FULL_M),
    yaw: beyond(0 - within_rad, REST_RAD, FULL_RAD),
  };
}

/** Squeezed, or a bare hand's thumb and index together. */
const is_dead_man = (hand: HandReading): boolean =>
  hand.kind === 'hand' ? hand.is_pressed : hand.is_squeezed;

const sides_of = (hands: readonly HandReading[]): string =>
  seen_controllers(hands)
    .map((it) => it.side)
    .sort()
    .join();

export class HelmHand {
  private holder: Side | null = null;
  private held_among = ''; // the controllers that were seen when the squeeze began
  private from: PinchedFrom | null = null;
  private lean: Lean = NO_LEAN;
  private is_lost = true; // since somebody looked
  private taken_ms = -Infinity;
  // Not seen open since they were lost, or held while they might not be on the stick.
  private readonly must_open = new Set<Side>(SIDES);

  /** The dead-man is held. */
  get held_by(): Side | null {
    return this.holder;
  }

  /** Each frame. `may`: whether a hand may be on the stick, and does nothing else. */
  take(
    hands: readonly HandReading[],
    ahead_rad: number,
    may: (hand: HandReading) => boolean,
    now_ms: number,
  ): void {
    this.taken_ms = now_ms;
    for (const side of SIDES) {
      const hand = hands.find((it) => it.side === side);
      if (hand === undefined || !hand.is_tracked) this.must_open.add(side);
      else if (!is_dead_man(hand)) this.must_open.delete(side);
      else if (!may(hand)) this.must_open.add(side);
    }
    if (this.holder !== null) {
      const holder = hands.find((it) => it.side === this.holder);
      if (holder === undefined || !holder.is_tracked) return this.lose();
      if (holder.kind === 'controller' && sides_of(hands) !== this.held_among) return this.lose();
      if (!may(holder) || !is_dead_man(holder)) this.let_go();
    }
    if (this.holder === null) {
      const found = hands.find((it) => is_dead_man(it) && !this.must_open.has(it.side));
      if (found === undefined) return;
      this.holder = found.side;
      this.held_among = sides_of(hands);
      if (found.kind === 'hand' && found.press_at !== null && found.grip !== null)
        this.from = { at: found.press_at, turned: found.grip.turned, ahead_rad };
    }
    const holder = hands.find((it) => it.side === this.holder)!;
    if (holder.kind === 'controller') this.lean = controllers_lean(hands);
    else if (this.from !== null && holder.press_at !== null && holder.grip !== null)
      this.lean = moved_lean(this.from, holder.press_at, holder.grip.turned);
    else this.lean = NO_LEAN;
  }

  /** The hand or the headset is gone: zero, and it must be seen open before it drives again. */
  lose(): void {
    this.let_go();
    this.is_lost = true;
    for (const side of SIDES) this.must_open.add(side);
  }

  /** Twenty times a second, with the other hands on the stick. */
  look(stick: Stick, now_ms: number): void {
    if (!(now_ms - this.taken_ms <= OLDEST_MS)) this.lose();
    if (this.is_lost) stick.lose('headset');
    else stick.set('headset', this.holder !== null, this.lean);
    this.is_lost = false;
  }

  private let_go(): void {
    this.holder = null;
    this.from = null;
    this.lean = NO_LEAN;
  }
}
