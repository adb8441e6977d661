// The light of a clear sky over the sun's place. Nobody tells of clouds: a clear sky is supposed.
import { Color, MathUtils, Vector3 } from 'three';
import type { Sun } from '../session/around';

export interface Daylight {
  to_sun: Vector3; // in the scene's axes
  /** Of a summer's noon; by night what starlight leaves to see by on a page. */
  light: number;
  beam: number; // share of it that comes from the sun's side
  sun: Color;
  zenith: Color;
  horizon: Color;
}

const NIGHT_LIGHT = 0.2;
const NIGHT_BELOW_DEG = -12; // end of nautical twilight
const WARM = new Color('#ff9d5c');

export function daylight_of(sun: Sun, sky: string): Daylight {
  const { elevation_deg, azimuth_deg } = sun;
  const elevation_rad = MathUtils.degToRad(elevation_deg);
  const azimuth_rad = MathUtils.degToRad(azimuth_deg);
  const to_sun = new Vector3(
    Math.sin(azimuth_rad) * Math.cos(elevation_rad),
    Math.sin(elevation_rad),
    -Math.cos(azimuth_rad) * Math.cos(elevation_rad),
  );
  // The eye sees by ratios: light goes with the logarithm of what twilight leaves of the day.
  const day = MathUtils.smoothstep(elevation_deg, NIGHT_BELOW_DEG, 12);
  const light = MathUtils.lerp(NIGHT_LIGHT, 1, day);
  // Of a level face's light, as the twin's renders have it: sin h / (sin h + 0.1).
  const sine = Math.max(0, Math.sin(elevation_rad));
  const low = 1 - MathUtils.smoothstep(Math.abs(elevation_deg), 1, 9);
  const zenith = new Color(sky).multiplyScalar(light);
  return {
    to_sun,
    light,
    beam: sine / (sine + 0.1),
    sun: new Color('#ffffff').lerp(WARM, low),
    zenith,
    horizon: zenith.clone().lerp(WARM.clone().multiplyScalar(light), 0.55 * low),
  };
}
