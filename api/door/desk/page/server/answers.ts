// The answers of the server, key for key; times as text with Z, numbers in SI.
import type { Place } from '../view';

export interface Problem {
  type: string;
  title: string;
  status: number;
  detail: string;
}

export type SiteStatus = 'ok' | 'degraded' | 'stale' | 'hindcast' | 'unreadable';

export interface ForecastInForce {
  instance: string;
  day: string;
  issued: string;
  valid_from: string;
  valid_to: string;
  age_s: number;
  degraded: boolean;
  headline: string;
}

/** /sites */
export interface Sites {
  now: string;
  stale_after_s: number;
  trouble: string;
  sites: SiteInSites[];
}
export interface SiteInSites {
  id: string;
  name: string;
  place: Place;
  time_zone: string | null;
  status: SiteStatus;
  in_words: string;
  forecast: ForecastInForce | null;
  report: string;
}

/** /sites/ID */
export interface SiteMap {
  id: string;
  name: string;
  place: Place;
  time_zone: string | null;
  shift: string | null;
  water_depth_m: number | null;
  columns: (Place & { name: string; bed_m: number | null })[];
  turbines: (Place & {
    id: string;
    hub_height_m: number | null;
    rotor_m: number | null;
    foundation: string | null;
    landing_deg: number | null;
  })[];
  cables: { name: string; points: [number, number][] }[];
  areas: { name: string; kind: string; ring: [number, number][]; note: string }[];
  tasks: { id: string; name: string }[];
  levels_m: number[];
  hub_heights_m: number[];
  forecast: ForecastInForce | null;
}
