// How far one sees, and in which light. What comes from a place r away fades as exp(-c r), as it
// does for the cameras of the twin: c = 4.8 / V under water, V the visibility of a black disc
// (Zaneveld and Pegau 2003), c = 3.0 / V in air, V the meteorological optical range, at which 5 in
// 100 are left. Water takes the colours unlike, and daylight fades downwards: as the twin has it
// (twin/render/light/water_type.h), K = c/4 in green, K(colour) = K s, c(colour) = c + 0.83 (K s -
// K), s of Jerlov's coastal type 3 (Marine Optics, 1976, table XXVII), and K a metre of depth.
import { Color, FogExp2, ShaderChunk } from 'three';
import type { Weather } from '../session/around';

const UNKNOWN_IN_AIR_M = 20_000;
const UNKNOWN_IN_WATER_M = 8;

const TYPE = { red: 0.33 / 0.19, green: 1, blue: 0.39 / 0.19 };
const K_PER_C = 0.25;
const USED_TO = 0.15; // of the logarithm of the light, what still shows
const SCATTERED = 0.83; // mean cosine of daylight in water
const look_share = (s: number): number => 1 + SCATTERED * K_PER_C * (s - 1);
export const LOOK = [TYPE.red, TYPE.green, TYPE.blue].map(look_share);

// three's own law is exp(-(c r)^2), of all colours alike. Fog that is told as negative is water's.
const share = LOOK.map((it) => it.toFixed(4)).join(', ');
ShaderChunk.fog_fragment = `
#ifdef USE_FOG
  vec3 fading = abs(fogDensity) * (fogDensity < 0.0 ? vec3(${share}) : vec3(1.0));
  gl_FragColor.rgb = mix(fogColor, gl_FragColor.rgb, exp(-fading * vFogDepth));
#endif`;

/** c in green. Where nobody says how far one sees, what the twin's renders take then. */
export function fading_per_m(weather: Weather | null, is_under_water: boolean): number {
  return is_under_water
    ? 4.8 / seen_in_water_m(weather)
    : 3.0 / (weather?.visibility_m ?? UNKNOWN_IN_AIR_M);
}

/** What is left of daylight at a depth: red, green, blue. */
export function light_left(per_m: number, depth_m: number): [number, number, number] {
  const left = (s: number): number => Math.exp(-K_PER_C * per_m * s * Math.max(0, depth_m));
  return [left(TYPE.red), left(TYPE.green), left(TYPE.blue)];
}

/** The same as an eye or a camera that has got used to it sees it: its colour, hardly darker. */
export function light_seen(per_m: number, depth_m: number): [number, number, number] {
  const green_lost = K_PER_C * per_m * Math.max(0, depth_m); // of its logarithm
  const seen = (s: number): number => Math.exp(-green_lost * (USED_TO + s - 1));
  return [seen(TYPE.red), seen(TYPE.green), seen(TYPE.blue)];
}

export function lit(colour: Color, [red, green, blue]: readonly [number, number, number]): Color {
  return new Color(colour.r * red, colour.g * green, colour.b * blue);
}

/** As far as one sees under water. */
export function seen_in_water_m(weather: Weather | null): number {
  return weather?.water_visibility_m ?? UNKNOWN_IN_WATER_M;
}

export function set_fog(fog: FogExp2, per_m: number, is_water: boolean, colour: Color): void {
  fog.density = is_water ? -per_m : per_m;
  fog.color.copy(colour);
}
