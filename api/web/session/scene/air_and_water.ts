// How far one sees. What comes from a place r away fades as exp(-c r), as it does for the cameras
// of the twin: c = 4.8 / V under water, V the visibility of a black disc (Zaneveld and Pegau 2003),
// c = 3.0 / V in air, V the meteorological optical range, at which 5 in 100 are left.
import { FogExp2, ShaderChunk } from 'three';
import type { Weather } from '../session/around';

const UNKNOWN_IN_AIR_M = 20_000;
const UNKNOWN_IN_WATER_M = 8;

// three's own law is exp(-(c r)^2).
ShaderChunk.fog_fragment = ShaderChunk.fog_fragment.replace(
  'exp( - fogDensity * fogDensity * vFogDepth * vFogDepth )',
  'exp( - fogDensity * vFogDepth )',
);

/** c. Where nobody says how far one sees, what the twin's renders take then. */
export function fading_per_m(weather: Weather | null, is_under_water: boolean): number {
  return is_under_water
    ? 4.8 / (weather?.water_visibility_m ?? UNKNOWN_IN_WATER_M)
    : 3.0 / (weather?.visibility_m ?? UNKNOWN_IN_AIR_M);
}

export function set_fog(fog: FogExp2, per_m: number, colour: string): void {
  fog.density = per_m;
  fog.color.set(colour);
}
