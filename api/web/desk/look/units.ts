// Numbers as people read them. Inside the page all is SI and UTC; only here is it turned into text.

export type SpeedUnit = 'm/s' | 'knots';
export type Directions = 'degrees' | 'compass';

const METRES_PER_SECOND_IN_A_KNOT = 1852 / 3600;
const POINTS = 'N NNE NE ENE E ESE SE SSE S SSW SW WSW W WNW NW NNW'.split(' ');
export const NOT_KNOWN = '–';

type Maybe = number | null | undefined;
export const is_known = (value: Maybe): value is number =>
  typeof value === 'number' && Number.isFinite(value);

export function speed_in(speed_m_s: number, unit: SpeedUnit): number {
  return unit === 'knots' ? speed_m_s / METRES_PER_SECOND_IN_A_KNOT : speed_m_s;
}

export function speed_unit_text(unit: SpeedUnit): string {
  return unit === 'knots' ? 'kn' : 'm/s';
}

export function speed_text(speed_m_s: Maybe, unit: SpeedUnit, places = 1): string {
  if (!is_known(speed_m_s)) return NOT_KNOWN;
  return `${speed_in(speed_m_s, unit).toFixed(places)} ${speed_unit_text(unit)}`;
}

export function metres_text(length_m: Maybe, places = 0): string {
  return is_known(length_m) ? `${length_m.toFixed(places)} m` : NOT_KNOWN;
}

/** Three digits, as courses are spoken: 7 degrees is 007°; or one of the 16 points. */
export function direction_text(degrees: Maybe, as: Directions): string {
  if (!is_known(degrees)) return NOT_KNOWN;
  const turned = ((degrees % 360) + 360) % 360;
  if (as === 'compass') return POINTS[Math.round(turned / 22.5) % 16] ?? NOT_KNOWN;
  return `${String(Math.round(turned) % 360).padStart(3, '0')}°`;
}

export function percent_text(share: Maybe): string {
  return is_known(share) ? `${Math.round(share * 100)} %` : NOT_KNOWN;
}

const formats = new Map<string, Intl.DateTimeFormat>();
function format(zone: string): Intl.DateTimeFormat {
  let made = formats.get(zone);
  if (made === undefined) {
    made = new Intl.DateTimeFormat('en-GB', {
      timeZone: zone,
      weekday: 'short',
      day: 'numeric',
      month: 'short',
      hour: '2-digit',
      minute: '2-digit',
      hourCycle: 'h23',
    });
    formats.set(zone, made);
  }
  return made;
}

export function time_parts(utc_ms: number, zone: string): Record<string, string> {
  const parts: Record<string, string> = {};
  for (const { type, value } of format(zone).formatToParts(utc_ms)) parts[type] = value;
  return parts;
}

export function hour_text(utc_ms: Maybe, zone: string): string {
  if (!is_known(utc_ms)) return NOT_KNOWN;
  const { hour, minute } = time_parts(utc_ms, zone);
  return `${hour}:${minute}`;
}

export function day_text(utc_ms: Maybe, zone: string, with_month = true): string {
  if (!is_known(utc_ms)) return NOT_KNOWN;
  const { weekday, day, month } = time_parts(utc_ms, zone);
  return with_month ? `${weekday} ${day} ${month}` : `${weekday} ${day}`;
}

export function time_text(utc_ms: Maybe, zone: string): string {
  if (!is_known(utc_ms)) return NOT_KNOWN;
  return `${day_text(utc_ms, zone)} ${hour_text(utc_ms, zone)}`;
}

/** Hours and minutes, days where it is long. */
export function span_text(span_s: Maybe): string {
  if (!is_known(span_s)) return NOT_KNOWN;
  const minutes = Math.round(Math.abs(span_s) / 60);
  if (minutes < 60) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  if (hours < 48) return minutes % 60 === 0 ? `${hours} h` : `${hours} h ${minutes % 60} min`;
  return `${Math.round(hours / 24)} days`;
}

/** "48.8500 N 2.5500 W" */
export function place_text(longitude_deg: number, latitude_deg: number): string {
  const of = (value: number, plus: string, minus: string): string =>
    `${Math.abs(value).toFixed(4)} ${value < 0 ? minus : plus}`;
  return `${of(latitude_deg, 'N', 'S')} ${of(longitude_deg, 'E', 'W')}`;
}
