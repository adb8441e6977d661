// The answers are of UTC days; a clock on the page may be of another zone, where such a day begins
// in the evening before or ends in the night after.
import { day_text, hour_text, time_parts } from '../look/units';
import { ms_of } from './answer';

/** How times are read, and what time it is. */
export interface Clock {
  zone: string;
  zone_name: string;
  now_ms: number;
}

type Time = string | null | undefined;

/** "Fri 14 Mar" of "2025-03-14". */
export function day_name(day: string): string {
  return day_text(Date.parse(`${day.slice(0, 10)}T12:00:00Z`), 'UTC');
}

/** "06:00"; where it lies outside of the day that the title names "Thu 21:30". */
export function hour_on(time: Time, zone: string, day: string): string {
  const at_ms = ms_of(time);
  const hour = hour_text(at_ms, zone);
  if (at_ms === null || day_text(at_ms, zone) === day_name(day)) return hour;
  return `${time_parts(at_ms, zone).weekday} ${hour}`;
}

/** "Thu 20:00 to Fri 20:00 America/New York"; empty in UTC, where a day is a day. */
export function span_text(from: Time, to: Time, { zone, zone_name }: Clock): string {
  if (zone === 'UTC') return '';
  const text = (time: Time): string => {
    const at_ms = ms_of(time);
    return at_ms === null ? '' : `${time_parts(at_ms, zone).weekday} ${hour_text(at_ms, zone)}`;
  };
  return `${text(from)} to ${text(to)} ${zone_name}`;
}
