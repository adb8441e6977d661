// Numbers as people read them. Inside the page all is SI; only here is it turned into text.

export type SpeedUnit = 'm/s' | 'knots';
export type TimeZoneChoice = { kind: 'utc' } | { kind: 'site'; offset_hours: number };

const METRES_PER_SECOND_IN_A_KNOT = 1852 / 3600;
export const NOT_KNOWN = '–';

export function speed_text(speed_m_s: number | null, unit: SpeedUnit, places = 1): string {
  if (speed_m_s === null || !Number.isFinite(speed_m_s)) return NOT_KNOWN;
  if (unit === 'knots') return `${(speed_m_s / METRES_PER_SECOND_IN_A_KNOT).toFixed(places)} kn`;
  return `${speed_m_s.toFixed(places)} m/s`;
}

export function metres_text(length_m: number | null, places = 0): string {
  if (length_m === null || !Number.isFinite(length_m)) return NOT_KNOWN;
  return `${length_m.toFixed(places)} m`;
}

/** Below the sea it is a depth, above it a height. */
export function level_text(up_m: number | null): string {
  if (up_m === null || !Number.isFinite(up_m)) return NOT_KNOWN;
  return up_m > 0.5 ? `${up_m.toFixed(1)} m up` : `${Math.max(0, -up_m).toFixed(1)} m deep`;
}

/** Three digits, as courses are spoken: 7 degrees is 007°. */
export function heading_text(heading_rad: number | null): string {
  if (heading_rad === null || !Number.isFinite(heading_rad)) return NOT_KNOWN;
  const degrees = Math.round((heading_rad * 180) / Math.PI);
  return `${String(((degrees % 360) + 360) % 360).padStart(3, '0')}°`;
}

export function degrees_text(angle_rad: number): string {
  // Plus zero, so that nothing reads as minus nothing.
  return Number.isFinite(angle_rad) ? `${Math.round((angle_rad * 180) / Math.PI) + 0}°` : NOT_KNOWN;
}

export function percent_text(share: number | null): string {
  if (share === null || !Number.isFinite(share)) return NOT_KNOWN;
  return `${Math.round(share * 100)} %`;
}

/** Rounded down: what is not all done never reads as all done. */
export function done_text(share: number | null): string {
  if (share === null || !Number.isFinite(share)) return NOT_KNOWN;
  return `${Math.floor(share * 100 + 1e-9)} %`; // 0.29 is a little less than 29 parts
}

/** Hours, minutes and, if asked for, seconds of a moment, with the name of the zone. */
export function time_text(utc_ms: number, zone: TimeZoneChoice, with_seconds = false): string {
  if (!Number.isFinite(utc_ms)) return NOT_KNOWN;
  const offset_hours = zone.kind === 'site' ? zone.offset_hours : 0;
  const shifted = new Date(utc_ms + offset_hours * 3_600_000);
  if (Number.isNaN(shifted.getTime())) return NOT_KNOWN;
  const digits = shifted.toISOString().slice(11, with_seconds ? 19 : 16);
  return `${digits} ${zone.kind === 'site' ? 'site' : 'UTC'}`;
}

/** Whole seconds left, never less than none. */
export function seconds_left(until_ms: number, now_ms: number): number {
  return Math.max(0, Math.ceil((until_ms - now_ms) / 1000));
}

export function age_text(age_ms: number): string {
  if (!Number.isFinite(age_ms)) return NOT_KNOWN;
  if (age_ms < 1000) return `${Math.max(0, Math.round(age_ms / 10) * 10)} ms`;
  return age_ms < 120_000
    ? `${(age_ms / 1000).toFixed(1)} s`
    : `${Math.round(age_ms / 60_000)} min`;
}

/** Hours and minutes, or seconds where it is short. */
export function span_text(span_s: number): string {
  if (!Number.isFinite(span_s)) return NOT_KNOWN;
  if (Math.abs(span_s) < 120) return `${Math.round(span_s)} s`;
  const minutes = Math.trunc(span_s / 60);
  if (Math.abs(minutes) < 60) return `${minutes} min`;
  return `${Math.trunc(minutes / 60)} h ${Math.abs(minutes % 60)} min`;
}

export type AgeGrade = 'fresh' | 'amber' | 'red';
export function age_grade(age_ms: number): AgeGrade {
  if (!(age_ms < 500)) return 'red';
  return age_ms < 200 ? 'fresh' : 'amber';
}
