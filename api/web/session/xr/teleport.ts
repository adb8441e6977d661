// Where a throw from the hand comes down: a deck, the bed, or the level of the sea. The way is that
// of a ball that is thrown along the ray. Crossings with levels and walls are solved; that with the
// bed is come to by looks, each at the height of the bed where the one before it came down.
import { Vector3 } from 'three';
import type { Structure } from '../session/message';

export interface Ground {
  structures: readonly Structure[];
  /** How high the bed is under a place of the scene; nothing: nobody knows. */
  bed_under: (at: Vector3) => number | null;
  /** Who stands on the water throws through it. */
  is_water_open: boolean;
}
export interface Landing {
  at: Vector3; // in the scene
  on: 'deck' | 'bed' | 'water';
  after_s: number;
}

const THROWN_M_S = 10;
const FALLS_M_S2 = 9.81;
const LONGEST_S = 6;
const POINTS = 30;
const LOOKS_AT_BED = 12; // slopes are gentle: each look is nearer by their share
const BED_WITHIN_M = 0.1; // else the looks go to and fro, as on a slope as steep as the way

export function at_time(from: Vector3, ahead: Vector3, t_s: number): Vector3 {
  const at = from.clone().addScaledVector(ahead, THROWN_M_S * t_s);
  at.y -= 0.5 * FALLS_M_S2 * t_s * t_s;
  return at;
}

/** When it is at a height: on the way up and on the way down. */
function times_at(from: Vector3, ahead: Vector3, up_m: number): number[] {
  const up_m_s = THROWN_M_S * ahead.y;
  const root = up_m_s * up_m_s + 2 * FALLS_M_S2 * (from.y - up_m);
  if (!(root >= 0)) return [];
  return [(up_m_s - Math.sqrt(root)) / FALLS_M_S2, (up_m_s + Math.sqrt(root)) / FALLS_M_S2];
}

/** When it comes to the wall of an upright pile, from outside. */
function time_at_wall(from: Vector3, ahead: Vector3, pile: Structure): number | null {
  const [x, z] = [from.x - pile.east_m, from.z + pile.north_m];
  const [vx, vz] = [THROWN_M_S * ahead.x, THROWN_M_S * ahead.z];
  const [a, b] = [vx * vx + vz * vz, x * vx + z * vz];
  const root = b * b - a * (x * x + z * z - pile.radius_m * pile.radius_m);
  if (!(a > 0) || !(root >= 0)) return null;
  const t_s = (-b - Math.sqrt(root)) / a;
  if (!(t_s > 0)) return null;
  const { y } = at_time(from, ahead, t_s);
  return y > pile.bottom_m && y < pile.top_m ? t_s : null;
}

/** When it comes down on the bed, as high as that is where it does so. */
function time_at_bed(
  from: Vector3,
  ahead: Vector3,
  bed_under: Ground['bed_under'],
): number | undefined {
  let at = from;
  let t_s: number | undefined;
  let step_m = Infinity;
  for (let i = 0; i < LOOKS_AT_BED; i += 1) {
    const bed_m = bed_under(at);
    if (bed_m === null) return undefined;
    t_s = times_at(from, ahead, bed_m)[1];
    if (t_s === undefined) return undefined;
    const next = at_time(from, ahead, t_s);
    step_m = next.distanceTo(at);
    at = next;
  }
  return step_m <= BED_WITHIN_M ? t_s : undefined;
}

/** Nothing: it comes down nowhere in time, or against a wall. `ahead` is a unit vector. */
export function landing_of(from: Vector3, ahead: Vector3, ground: Ground): Landing | null {
  if (!Number.isFinite(from.length() + ahead.length())) return null;
  let best: Landing | null = null;
  let wall_s = LONGEST_S;
  const consider = (on: Landing['on'], t_s: number | undefined): void => {
    if (t_s === undefined || !(t_s > 1e-6) || t_s > (best?.after_s ?? LONGEST_S)) return;
    best = { at: at_time(from, ahead, t_s), on, after_s: t_s };
  };
  for (const pile of ground.structures) {
    wall_s = Math.min(wall_s, time_at_wall(from, ahead, pile) ?? Infinity);
    const down_s = times_at(from, ahead, pile.top_m)[1];
    if (down_s === undefined) continue;
    const at = at_time(from, ahead, down_s);
    if (Math.hypot(at.x - pile.east_m, at.z + pile.north_m) <= pile.radius_m)
      consider('deck', down_s);
  }
  consider('bed', time_at_bed(from, ahead, ground.bed_under));
  const [rising_s, falling_s] = times_at(from, ahead, 0);
  if (from.y < 0) consider('water', rising_s);
  else if (!ground.is_water_open) consider('water', falling_s);
  const found = best as Landing | null; // closures assign it
  return found === null || wall_s < found.after_s ? null : found;
}

/** The way of the throw as far as it is shown. */
export function arc_of(from: Vector3, ahead: Vector3, landing: Landing | null): Vector3[] {
  const end_s = landing?.after_s ?? 1.2;
  return Array.from({ length: POINTS + 1 }, (_, i) => at_time(from, ahead, (end_s * i) / POINTS));
}
