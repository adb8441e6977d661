// The answers of the server, key for key; times as text with Z, numbers in SI.
import type { Place } from '../view';

export interface Problem {
  type: string;
  title: string;
  status: number;
  detail: string;
}

export type SiteStatus = 'ok' | 'degraded' | 'stale' | 'hindcast' | 'unreadable' | 'no_forecast';

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
  place: Place | null;
  time_zone: string | null;
  status: SiteStatus;
  in_words: string;
  forecast: ForecastInForce | null;
  report: string | null;
  /** The page of the report that was made last. */
  report_page: string | null;
}

/** From what charts count, as the site's file states it: a plane below mean sea level. */
export interface ChartDatum {
  name: string;
  below_mean_sea_level_m: number;
  source: string;
}

/** /sites/ID. The server leaves out what it does not know; here it is then empty. */
export interface SiteMap {
  id: string;
  name: string;
  place: Place | null;
  time_zone: string | null;
  shift: string | null;
  water_depth_m: number | null;
  chart_datum: ChartDatum | null;
  hub_height_m: number | null;
  columns: (Place & { location: string; bed_m: number | null })[];
  levels_m: number[];
  turbines: (Place & {
    id: string;
    hub_height_m: number | null;
    rotor_m: number | null;
    foundation: string | null;
    landing_deg: number | null;
  })[];
  cables: { id: string; points: [number, number][] }[];
  areas: Area[];
  ports: (Place & { name: string })[]; // of the vessels of its plan
  tasks: { id: string; name: string }[];
  in_words: string;
  forecast: ForecastInForce | null;
}
export interface Area {
  id: string;
  kind: 'exclusion' | 'traffic_lane';
  reason: string;
  ring: [number, number][];
  in_force_now: boolean;
  below_height_m: number | null;
  to_direction_deg: number | null;
}

export function whole_site(answer: Partial<SiteMap> & { id: string }): SiteMap {
  const nothing = {
    name: answer.id,
    place: answer.columns?.[0] ?? null,
    time_zone: null,
    shift: null,
    water_depth_m: null,
    chart_datum: null,
    hub_height_m: null,
    columns: [],
    levels_m: [],
    turbines: [],
    cables: [],
    areas: [],
    ports: [],
    tasks: [],
    in_words: '',
    forecast: null,
  };
  return { ...nothing, ...answer };
}
