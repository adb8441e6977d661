// The vessels about a site as the server tells them.
import type { Place } from '../view';
import { time_of_ms } from '../view';
import type { Server } from './server';

export interface Approach {
  turbine: string | null; // null: the site itself
  passing: 'closing' | 'past' | 'still';
  cpa_m: number;
  tcpa_s: number; // negative: so long ago
  in_words: string;
}
export interface Vessel extends Place {
  mmsi: number;
  name: string | null;
  class: string;
  kind: string | null;
  length_m: number | null;
  state: 'fresh' | 'old';
  reported: Place & { time: string };
  age_s: number;
  dead_reckoned: boolean;
  speed_m_s: number | null;
  to_direction_deg: number | null;
  heading_deg: number | null;
  distance_m: number;
  bearing_deg: number; // as the site sees it
  ahead: Place | null;
  to_site: Approach | null;
  to_turbine: Approach | null;
  told: Approach | null; // of the two the one that matters more, for which it is marked
  alarm: 'closing' | 'inside' | null;
}
/** /sites/ID/traffic */
export interface Traffic {
  site: string;
  at: string;
  in_words: string;
  sources: { file: string; trouble: string | null }[];
  last_heard: string | null;
  limits: { cpa_m: number; tcpa_s: number };
  rule: { reach_m: number; shown_s: number; way_s: number };
  vessels: Vessel[];
  too_old: number;
  left_out: number;
}

const NOTHING: Omit<Traffic, 'site' | 'at'> = {
  in_words: '',
  sources: [],
  last_heard: null,
  limits: { cpa_m: 0, tcpa_s: 0 },
  rule: { reach_m: 0, shown_s: 0, way_s: 0 },
  vessels: [],
  too_old: 0,
  left_out: 0,
};

export async function fetch_traffic(server: Server, site: string, at_ms: number): Promise<Traffic> {
  const at = time_of_ms(at_ms);
  const path = `/sites/${encodeURIComponent(site)}/traffic?at=${at}`;
  return { ...NOTHING, site, at, ...(await server.get<Partial<Traffic>>(path)) };
}
