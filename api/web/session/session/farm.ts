// The turbines of the run's site: where they stand, and what each makes of the wind now.
import { as_list, as_number, as_object } from './message';

/** What one makes in free wind at hub height. */
export interface PowerAt {
  wind_m_s: number;
  power_w: number;
}

export interface Turbines {
  hub_height_m: number;
  rotor_diameter_m: number;
  rated_w: number; // of each
  places: { east_m: number; north_m: number }[];
  curve: PowerAt[]; // of each, by rising wind; empty: not told
}

/** What is left of the free wind at hub height, so many rotor diameters behind a turbine. */
export const BEHIND_DIAMETERS = [2, 5, 10] as const;

export interface TurbineNow {
  power_w: number;
  wind_m_s: number; // over its rotor
  rotor_speed_rad_s: number;
  wind_left: number[]; // shares, as many as BEHIND_DIAMETERS
}
export interface FarmNow {
  power_w: number;
  rated_w: number;
  turbines: number;
  each: TurbineNow[]; // in the order of the places; empty: not told
}

export function read_turbines(value: unknown): Turbines | null {
  const it = as_object(value);
  const hub_height_m = as_number(it?.hub_height_m);
  const rotor_diameter_m = as_number(it?.rotor_diameter_m);
  if (it === null || hub_height_m === null || rotor_diameter_m === null) return null;
  const places: Turbines['places'] = [];
  for (const one of as_list(it.places)) {
    const [east_m, north_m] = as_list(one).map(as_number);
    if (east_m != null && north_m != null) places.push({ east_m, north_m });
  }
  const rated_w = as_number(it.rated_w) ?? Number.NaN;
  return { hub_height_m, rotor_diameter_m, rated_w, places, curve: read_curve(it.curve) };
}

function read_curve(value: unknown): PowerAt[] {
  const made: PowerAt[] = [];
  for (const one of as_list(value)) {
    const [wind_m_s, power_w] = as_list(one).map(as_number);
    if (wind_m_s != null && power_w != null) made.push({ wind_m_s, power_w });
  }
  return made.sort((a, b) => a.wind_m_s - b.wind_m_s);
}

export function read_farm(value: unknown): FarmNow | null {
  const it = as_object(value);
  if (it === null) return null;
  const each: TurbineNow[] = [];
  for (const one of as_list(it.each)) {
    const turbine = as_object(one);
    each.push({
      power_w: as_number(turbine?.power_w) ?? Number.NaN,
      wind_m_s: as_number(turbine?.wind_m_s) ?? Number.NaN,
      rotor_speed_rad_s: as_number(turbine?.rotor_speed_rad_s) ?? 0,
      wind_left: BEHIND_DIAMETERS.map((_, i) => as_number(as_list(turbine?.wind_left)[i]) ?? 1),
    });
  }
  return {
    power_w: as_number(it.power_w) ?? Number.NaN,
    rated_w: as_number(it.rated_w) ?? Number.NaN,
    turbines: as_number(it.turbines) ?? each.length,
    each,
  };
}
