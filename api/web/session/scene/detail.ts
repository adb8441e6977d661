// How large something is in the picture. What is small there is drawn as one plain mark.
import type { Vector3 } from 'three';

export const SMALL_PX = 8;

export interface Lens {
  eye: Vector3;
  field_deg: number; // of view, from below to above
  high_px: number; // of the picture
}

/** How high a thing of that size would be if one looked at it. */
export function seen_px({ eye, field_deg, high_px }: Lens, at: Vector3, size_m: number): number {
  const away_m = Math.max(1e-3, at.distanceTo(eye));
  const field = 2 * Math.tan((field_deg * Math.PI) / 360);
  return (size_m / away_m / field) * high_px;
}

export function is_small(lens: Lens, at: Vector3, size_m: number): boolean {
  return seen_px(lens, at, size_m) < SMALL_PX;
}
