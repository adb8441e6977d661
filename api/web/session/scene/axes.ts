// East, north, up of the run to the scene's axes: x east, y up, z south.
import { Euler, Vector3 } from 'three';
import type { Pose } from '../session/frame';

export interface Place {
  east_m: number;
  north_m: number;
  up_m: number;
}

export function at_place(place: Place): Vector3 {
  return new Vector3(place.east_m, place.up_m, -place.north_m);
}

/** The same back, to the centimetre. */
export function at_scene(at: Vector3): Place {
  const rounded = (value_m: number): number => Math.round(100 * value_m) / 100;
  return { east_m: rounded(at.x), north_m: rounded(-at.z), up_m: rounded(at.y) };
}

/** Turns a shape whose bow looks along -z, its mast along y. */
export function turned(pose: Pick<Pose, 'roll_rad' | 'pitch_rad' | 'heading_rad'>): Euler {
  return new Euler(pose.pitch_rad, -pose.heading_rad, -pose.roll_rad, 'YXZ');
}
