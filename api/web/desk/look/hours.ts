// The hours of a forecast: what the slider's hour is, and where an axis of time has its ticks.
import type { ForecastInForce } from '../server/answers';
import type { Desk } from './desk';
import { day_text, hour_text } from './units';

export const HOUR_MS = 3_600_000;

export interface Reach {
  from_ms: number;
  to_ms: number;
}

/** What the forecast in force reaches; null where there is none. */
export function reach_of(forecast: ForecastInForce | null): Reach | null {
  if (forecast === null) return null;
  const from_ms = Date.parse(forecast.valid_from);
  const to_ms = Date.parse(forecast.valid_to);
  return to_ms > from_ms ? { from_ms, to_ms } : null;
}

/** A whole hour within the reach. */
export function hour_within(reach: Reach, at_ms: number): number {
  const hour = reach.from_ms + Math.round((at_ms - reach.from_ms) / HOUR_MS) * HOUR_MS;
  return Math.min(reach.to_ms, Math.max(reach.from_ms, hour));
}

/** The slider's hour: the view's, else the hour that it is at the server. */
export function hour_of(desk: Desk): number | null {
  const reach = reach_of(desk.server.forecast(desk.view.values.site));
  if (reach === null) return null;
  return hour_within(reach, desk.view.values.at_ms ?? desk.server.now_ms());
}

export interface Tick {
  at_ms: number;
  text: string;
  is_day: boolean; // midnight in the zone
}

const DAY_PX = 62; // of "Thu 13", with room
const HOUR_PX = 28;

/** Ticks at the zone's 00, 06, 12 and 18 o'clock, as far as their words have room; days first. */
export function time_ticks(reach: Reach, zone: string, width_px: number, day_px = DAY_PX): Tick[] {
  const px_per_ms = width_px / (reach.to_ms - reach.from_ms);
  const kept: (Tick & { from_px: number; to_px: number })[] = [];
  const all = all_ticks(reach, zone, width_px > 560 ? 6 : 12);
  for (const is_day of [true, false]) {
    for (const tick of all.filter((one) => one.is_day === is_day)) {
      const wide = is_day ? day_px : HOUR_PX;
      const middle = (tick.at_ms - reach.from_ms) * px_per_ms;
      // At the ends the words stand inside.
      const from_px = Math.min(width_px - wide, Math.max(0, middle - wide / 2));
      const to_px = from_px + wide;
      if (kept.some((one) => from_px < one.to_px && to_px > one.from_px)) continue;
      kept.push({ ...tick, from_px, to_px });
    }
  }
  kept.sort((a, b) => a.at_ms - b.at_ms);
  return kept.map(({ at_ms, text, is_day }) => ({ at_ms, text, is_day }));
}

function all_ticks(reach: Reach, zone: string, every_h: number): Tick[] {
  const ticks: Tick[] = [];
  const first = Math.ceil(reach.from_ms / HOUR_MS) * HOUR_MS;
  for (let at_ms = first; at_ms <= reach.to_ms; at_ms += HOUR_MS) {
    const hour = hour_text(at_ms, zone);
    const is_day = hour === '00:00';
    if (Number(hour.slice(0, 2)) % every_h !== 0 || hour.slice(3) !== '00') continue;
    ticks.push({ at_ms, text: is_day ? day_text(at_ms, zone, false) : hour.slice(0, 2), is_day });
  }
  return ticks;
}
