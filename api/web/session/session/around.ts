// What is around the vehicles: the weather at the origin of the run, and who passes by.
import { read_currents, type Current } from './currents';
import { read_farm, type FarmNow } from './farm';
import { as_list, as_number, as_object, as_text, type Json } from './message';

export interface Sun {
  elevation_deg: number; // above the horizon
  azimuth_deg: number; // clockwise from north
}

export interface Weather {
  wind_m_s: number | null;
  wind_from_deg: number | null;
  hub_wind_m_s: number | null;
  hub_wind_from_deg: number | null;
  waves_m: number | null;
  waves_period_s: number | null;
  waves_from_deg: number | null;
  waves_factor: number; // on the heights of the sea's waves
  current_m_s: number | null;
  current_to_deg: number | null;
  visibility_m: number | null; // nothing: nobody says
  water_visibility_m: number | null;
  led: string[]; // by name: wind, waves, current, visibility, water_visibility
  led_by: string;
  settles_in_s: number;
  sun: Sun | null;
  currents: Current[]; // from the surface to the bed; empty: nobody knows
  farm: FarmNow | null;
}

export interface Vessel {
  mmsi: string;
  name: string;
  east_m: number;
  north_m: number;
  course_deg: number | null;
  speed_m_s: number;
  length_m: number | null;
}

export function read_weather(value: unknown): Weather | null {
  const it = as_object(value);
  if (it === null) return null;
  return {
    wind_m_s: as_number(it.wind_m_s),
    wind_from_deg: as_number(it.wind_from_deg),
    hub_wind_m_s: as_number(it.hub_wind_m_s),
    hub_wind_from_deg: as_number(it.hub_wind_from_deg),
    waves_m: as_number(it.waves_m),
    waves_period_s: as_number(it.waves_period_s),
    waves_from_deg: as_number(it.waves_from_deg),
    waves_factor: as_number(it.waves_factor) ?? 1,
    current_m_s: as_number(it.current_m_s),
    current_to_deg: as_number(it.current_to_deg),
    visibility_m: as_number(it.visibility_m),
    water_visibility_m: as_number(it.water_visibility_m),
    led: as_list(it.led).map(as_text),
    led_by: as_text(it.led_by),
    settles_in_s: as_number(it.settles_in_s) ?? 0,
    sun: read_sun(it.sun),
    currents: read_currents(it.currents),
    farm: read_farm(it.farm),
  };
}

function read_sun(value: unknown): Sun | null {
  const it = as_object(value);
  const [elevation_deg, azimuth_deg] = [as_number(it?.elevation_deg), as_number(it?.azimuth_deg)];
  return elevation_deg === null || azimuth_deg === null ? null : { elevation_deg, azimuth_deg };
}

export function read_vessels(value: unknown): Vessel[] {
  const made: Vessel[] = [];
  for (const one of as_list(value)) {
    const it: Json | null = as_object(one);
    const east_m = as_number(it?.east_m);
    const north_m = as_number(it?.north_m);
    if (it === null || east_m === null || north_m === null) continue;
    const mmsi = as_text(it.mmsi);
    made.push({
      mmsi,
      name: as_text(it.name) || `MMSI ${mmsi}`,
      east_m,
      north_m,
      course_deg: as_number(it.course_deg),
      speed_m_s: as_number(it.speed_m_s) ?? 0,
      length_m: as_number(it.length_m),
    });
  }
  return made;
}
