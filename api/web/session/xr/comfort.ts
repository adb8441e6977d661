// What keeps stomachs at ease: turns by steps, flight that begins slowly, and a view that narrows
// while one is moved.
import { Vector3 } from 'three';
import { beyond_dead_zone } from '../drive/gamepad';

const SNAP_RAD = Math.PI / 6;
export const SEATED_LIFT_M = 0.45; // from a seated to a standing person's eyes

const [PUSHED, BACK] = [0.7, 0.3];

/** A push of the thumb-stick is one step, and the next one needs it back in the middle first. */
export class SnapTurn {
  private is_ready = true;

  /** To the right; 0: no step now. */
  step(right: number): number {
    if (Math.abs(right) < BACK) this.is_ready = true;
    if (!this.is_ready || Math.abs(right) < PUSHED) return 0;
    this.is_ready = false;
    return Math.sign(right) * SNAP_RAD;
  }
}

const FIRST_M_S = 3;
const MOST_M_S = 30;
const GROWS_IN_S = 1.5;
const LONGEST_STEP_S = 0.1; // a frame that was late throws nobody far

/** Ahead is where one looks, also up and down. */
export class Flight {
  private for_s = 0;

  /** How far in this step, in the scene's metres where the rig is not enlarged. */
  step(look: Vector3, move: { right: number; up: number }, rise: number, step_s: number): Vector3 {
    const ahead = beyond_dead_zone(move.up);
    const right = beyond_dead_zone(move.right);
    const up = beyond_dead_zone(rise);
    const way = look.clone().multiplyScalar(ahead);
    const level = new Vector3(-look.z, 0, look.x);
    if (level.length() > 1e-6) way.addScaledVector(level.normalize(), right);
    way.y += up;
    if (way.length() === 0) {
      this.for_s = 0;
      return way;
    }
    const passed_s = Math.min(LONGEST_STEP_S, Math.max(0, step_s));
    this.for_s += passed_s;
    const speed_m_s = Math.min(MOST_M_S, FIRST_M_S * Math.exp(this.for_s / GROWS_IN_S));
    return way.multiplyScalar(speed_m_s * passed_s);
  }
}

const LEAST_OVER_BED_M = 0.3;

/** By how much who flew into the bed is lifted out of it. */
export function out_of_bed_m(eye_up_m: number, bed_m: number | null): number {
  return bed_m === null ? 0 : Math.max(0, bed_m + LEAST_OVER_BED_M - eye_up_m);
}

const NARROWS_IN_S = 0.15;

/** How narrow the view is: 0 open, 1 a tunnel. */
export function narrowed(before: number, is_moved: boolean, step_s: number): number {
  const on = (is_moved ? 1 : -1) * (step_s / NARROWS_IN_S);
  return Math.max(0, Math.min(1, before + on));
}
