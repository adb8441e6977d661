// The sea of the run: the waves that its vehicles are in, by the formula of
// api/docs/session_wire.md.
import { as_list, as_number, as_object } from './message';

export interface Wave {
  amplitude_m: number;
  east_rad_m: number;
  north_rad_m: number;
  rad_s: number;
  phase_rad: number;
}
export interface Sea {
  depth_m: number;
  waves: Wave[];
}

/** Nothing where the sea is calm, or not told. */
export function read_sea(value: unknown): Sea | null {
  const it = as_object(value);
  if (it === null) return null;
  const waves: Wave[] = [];
  for (const one of as_list(it.waves)) {
    const numbers = as_list(one).map(as_number);
    const [amplitude_m, east_rad_m, north_rad_m, rad_s, phase_rad] = numbers;
    if (amplitude_m == null || east_rad_m == null || north_rad_m == null) continue;
    if (rad_s == null || phase_rad == null) continue;
    waves.push({ amplitude_m, east_rad_m, north_rad_m, rad_s, phase_rad });
  }
  const depth_m = as_number(it.depth_m);
  return depth_m === null || waves.length === 0 ? null : { depth_m, waves };
}

/** The phase of a wave at a place and a time of the run, from 0 to a whole turn. */
export function phase_of(wave: Wave, east_m: number, north_m: number, time_s: number): number {
  const phase =
    wave.east_rad_m * east_m +
    wave.north_rad_m * north_m -
    wave.rad_s * time_s +
    wave.phase_rad;
  const turn = 2 * Math.PI;
  return phase - turn * Math.floor(phase / turn);
}

/** Of the surface over mean sea level. */
export function elevation_m(
  sea: Sea | null,
  factor: number,
  east_m: number,
  north_m: number,
  time_s: number,
): number {
  let sum = 0;
  for (const wave of sea?.waves ?? [])
    sum += wave.amplitude_m * Math.cos(phase_of(wave, east_m, north_m, time_s));
  return factor * sum;
}
