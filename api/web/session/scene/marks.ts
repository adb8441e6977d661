// Lines that tell what a vehicle has about it: where its camera looks, its home, the zone about
// noisy work that is watched for animals.
import { Vector3 } from 'three';
import type { Pose } from '../session/frame';
import type { CameraPointing, Vehicle } from '../session/message';
import { CAMERA_FIELD_RAD } from '../view/vehicle_shape';
import { at_place, turned, type Place } from './axes';

export const USUAL_ASPECT = 16 / 9;
const REACH_M = 4;

/**
 * Where the corners of its picture are seen from, a few metres off: upper left, upper right, lower
 * right, lower left.
 */
export function camera_corners(
  pose: Pose,
  pointing: CameraPointing,
  aspect: number,
): [Vector3, Vector3, Vector3, Vector3] {
  const half = Math.tan(CAMERA_FIELD_RAD / 2) / pointing.zoom;
  const pan = (pointing.pan_deg * Math.PI) / 180;
  const tilt = (pointing.tilt_deg * Math.PI) / 180;
  const corner = (right: number, up: number): Vector3 =>
    new Vector3(right * half, (up * half) / aspect, -1)
      .multiplyScalar(REACH_M)
      .applyAxisAngle(new Vector3(1, 0, 0), tilt)
      .applyAxisAngle(new Vector3(0, 1, 0), -pan)
      .applyEuler(turned(pose))
      .add(at_place(pose));
  return [corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)];
}

/** The edges of what its camera sees, as far as a few metres; a line in one stroke. */
export function camera_edges(
  pose: Pose,
  pointing: CameraPointing,
  aspect = USUAL_ASPECT,
): Vector3[] {
  const from = at_place(pose);
  const [a, b, c, d] = camera_corners(pose, pointing, aspect);
  return [from, a, b, from, c, d, from, a, d, c, b];
}

/** A level circle, closed. */
export function ring(about: Place, radius_m: number): Vector3[] {
  const many = 64;
  return Array.from({ length: many + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / many;
    return at_place({
      east_m: about.east_m + radius_m * Math.sin(angle),
      north_m: about.north_m + radius_m * Math.cos(angle),
      up_m: about.up_m,
    });
  });
}

/** A cross at its home, from the surface down to it. */
export function home_mark(vehicle: Vehicle): Vector3[] | null {
  if (vehicle.home === null) return null;
  const at = at_place(vehicle.home);
  const off = (x: number, y: number, z: number): Vector3 => at.clone().add(new Vector3(x, y, z));
  return [off(-1, 0, 0), off(1, 0, 0), at, off(0, 0, -1), off(0, 0, 1), at, at.clone().setY(0)];
}
