// How the view wants numbers and times to be read: the units of look/units.ts, chosen by the view.
import type { View } from '../view';
import * as units from './units';

export class Look {
  /** IANA name of the site's zone; null where the site names none: its time is then UTC. */
  site_zone: string | null = null;

  constructor(private readonly view: View) {}

  get zone(): string {
    return this.view.values.clock === 'site' ? (this.site_zone ?? 'UTC') : 'UTC';
  }
  /** The unit's name, and a speed's number in it. */
  get speed_unit(): string {
    return units.speed_unit_text(this.view.values.speed);
  }
  speed_number(speed_m_s: number): number {
    return units.speed_in(speed_m_s, this.view.values.speed);
  }
  speed(speed_m_s: number | null | undefined, places = 1): string {
    return units.speed_text(speed_m_s, this.view.values.speed, places);
  }
  /** A direction without its word: the caller says "to" or "from". */
  direction(degrees: number | null | undefined): string {
    return units.direction_text(degrees, this.view.values.directions);
  }
  metres(length_m: number | null | undefined, places = 0): string {
    return units.metres_text(length_m, places);
  }
  /** "Fri 14 Mar 06:00" */
  time(utc_ms: number | null | undefined): string {
    return units.time_text(utc_ms, this.zone);
  }
  /** "06:00" */
  hour(utc_ms: number | null | undefined): string {
    return units.hour_text(utc_ms, this.zone);
  }
  /** "Fri 14 Mar" */
  day(utc_ms: number | null | undefined): string {
    return units.day_text(utc_ms, this.zone);
  }
  /** "UTC", or the site's zone by its name. */
  get zone_name(): string {
    if (this.zone !== 'UTC') return this.zone.replaceAll('_', ' ');
    return this.view.values.clock === 'site' ? 'UTC (the site names no zone)' : 'UTC';
  }
}
