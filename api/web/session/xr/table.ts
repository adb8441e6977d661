// The farm as a table, 1:500: who looks at it is 500 times larger, so that a hand that moves a
// centimetre moves what it holds by five metres.
import { Vector3 } from 'three';
import { at_place, at_scene, type Place } from '../scene/axes';
import type { Session } from '../session/state';
import type { Presses } from './presses';
import type { HandReading, Side } from './reading';
import type { Rig } from './rig';

export const TABLE_SCALE = 500;
const AHEAD_M = 0.6; // of the head, as it stood when the table was laid
const BELOW_M = 0.5;
const WITHIN_M = 0.03; // of the finger tips, what they take hold of
const STAYS_M = 0.01; // pressed and let go so near was a choice, not a move

/** What the table shows the middle of: the chosen vehicle, else the middle of the vehicles. */
export function table_middle(session: Session, chosen: number | null): Vector3 {
  const pose = chosen === null ? undefined : session.poses.get(chosen);
  const of = pose === undefined ? [...session.poses.values()] : [pose];
  const middle = new Vector3();
  for (const it of of) middle.addScaledVector(at_place(it), 1 / of.length);
  return middle.setY(0);
}

/** Lays it in front of the head, or at a place that the headset found. */
export function lay_table(rig: Rig, middle: Vector3, at: Vector3 | null): void {
  const ahead = new Vector3(0, 0, -1).applyQuaternion(rig.head.quaternion).setY(0);
  if (ahead.length() < 1e-6) ahead.set(0, 0, -1);
  const before = rig.head.position.clone().addScaledVector(ahead.normalize(), AHEAD_M);
  before.y -= BELOW_M;
  rig.bring(at ?? before, middle, TABLE_SCALE);
}

/** What the hands do to a table. */
export interface TableDeeds {
  places(): readonly Place[] | null; // of the way under edit
  pick(nth: number): void;
  move(to: Place): void; // of the picked one, level
  lift(up_m: number): void;
  let_go(): void;
  vehicles(): readonly (Place & { vehicle: number })[];
  choose(vehicle: number): void;
}

type Held =
  | { is: 'place'; nth: number; from: Vector3; of: Vector3 }
  | { is: 'vehicle'; vehicle: number; from: Vector3 }
  | { is: 'table'; from: Vector3 };

/** The nearest within reach of the finger tips. */
function taken_at<T extends Place>(at: Vector3, places: readonly T[], within_m: number): T | null {
  let best: T | null = null;
  let least_m = within_m;
  for (const place of places) {
    const away_m = at_place(place).distanceTo(at);
    if (away_m > least_m) continue;
    least_m = away_m;
    best = place;
  }
  return best;
}

export class TableHand {
  private held: Held | null = null;
  private by: Side | null = null;

  constructor(
    private readonly rig: Rig,
    private readonly deeds: TableDeeds,
  ) {}

  /** Each frame; a side that is busy presses something else. */
  take(hands: readonly HandReading[], presses: Presses, busy: ReadonlySet<Side>): void {
    if (this.by !== null && !presses.is_held(this.by)) {
      const holder = hands.find((it) => it.side === this.by);
      if (holder?.is_tracked === true && !holder.is_pressed) this.let_go();
      else this.lose();
    }
    const pressed = hands.filter((it) => presses.is_held(it.side) && !busy.has(it.side));
    for (const hand of pressed) {
      const at = hand.press_at === null ? null : this.rig.in_scene(hand.press_at);
      if (at === null) continue;
      if (this.held === null && presses.begins(hand.side)) this.hold(hand.side, at);
      // The other hand pressed too: up and down on its plumb line.
      if (hand.side === this.by) this.carry(at, pressed.length > 1);
    }
  }

  /** The hand is gone: what it held is left as it is, and nothing is chosen. */
  lose(): void {
    if (this.held?.is === 'vehicle') this.held = null;
    this.let_go();
  }

  /** The hand opened. */
  private let_go(): void {
    const { held } = this;
    if (held?.is === 'place') this.deeds.let_go();
    if (held?.is === 'vehicle') this.deeds.choose(held.vehicle);
    this.held = null;
    this.by = null;
  }

  private hold(side: Side, at: Vector3): void {
    const within_m = WITHIN_M * this.rig.scale;
    const places = (this.deeds.places() ?? []).map((it, nth) => ({ ...it, nth }));
    const place = taken_at(at, places, within_m);
    const vehicle = place === null ? taken_at(at, this.deeds.vehicles(), within_m) : null;
    this.by = side;
    if (place !== null) {
      this.held = { is: 'place', nth: place.nth, from: at, of: at_place(place) };
      this.deeds.pick(place.nth);
    } else if (vehicle !== null) this.held = { is: 'vehicle', vehicle: vehicle.vehicle, from: at };
    else this.held = { is: 'table', from: at };
  }

  private carry(at: Vector3, is_up_and_down: boolean): void {
    const { held, rig } = this;
    if (held === null) return;
    const moved = at.clone().sub(held.from);
    if (held.is === 'place') {
      const to = held.of.clone().add(moved);
      if (is_up_and_down) this.deeds.lift(to.y);
      else this.deeds.move(at_scene(to.setY(held.of.y)));
    } else if (held.is === 'vehicle') {
      if (moved.length() > STAYS_M * rig.scale) this.held = { is: 'table', from: held.from };
    } else rig.move(moved.setY(0).negate()); // what was under the hand stays under it
  }
}
