// What a person has chosen of the looks. Remembered in this browser; nothing secret is among it.
import type { SpeedUnit, TimeZoneChoice } from './units';

export type Palette = 'day' | 'dusk' | 'night';

export interface Settings {
  palette: Palette;
  speed_unit: SpeedUnit;
  zone: 'utc' | 'site';
  site_offset_hours: number;
  stick_share: number; // of the vehicle's most speed, at full stick
  headset_narrows: boolean; // the view, while one is moved
  headset_is_seated: boolean; // and lifted to a standing person's height
}

const KEY = 'slackwater.session.settings';

export function default_settings(prefers_dark: boolean): Settings {
  return {
    palette: prefers_dark ? 'dusk' : 'day',
    speed_unit: 'm/s',
    zone: 'utc',
    site_offset_hours: 0,
    stick_share: 0.5,
    headset_narrows: true,
    headset_is_seated: false,
  };
}

/** Takes of a text what is sound, and the default for the rest. */
export function read_settings(text: string | null, otherwise: Settings): Settings {
  const settings = { ...otherwise };
  let given: unknown = null;
  try {
    given = JSON.parse(text ?? 'null');
  } catch {
    return settings;
  }
  if (typeof given !== 'object' || given === null) return settings;
  const it = given as Record<string, unknown>;
  if (it.palette === 'day' || it.palette === 'dusk' || it.palette === 'night')
    settings.palette = it.palette;
  if (it.speed_unit === 'm/s' || it.speed_unit === 'knots') settings.speed_unit = it.speed_unit;
  if (it.zone === 'utc' || it.zone === 'site') settings.zone = it.zone;
  if (typeof it.site_offset_hours === 'number' && Math.abs(it.site_offset_hours) <= 14) {
    settings.site_offset_hours = it.site_offset_hours;
  }
  if (typeof it.stick_share === 'number' && it.stick_share > 0 && it.stick_share <= 1) {
    settings.stick_share = it.stick_share;
  }
  if (typeof it.headset_narrows === 'boolean') settings.headset_narrows = it.headset_narrows;
  if (typeof it.headset_is_seated === 'boolean') settings.headset_is_seated = it.headset_is_seated;
  return settings;
}

export function zone_of(settings: Settings): TimeZoneChoice {
  return settings.zone === 'site'
    ? { kind: 'site', offset_hours: settings.site_offset_hours }
    : { kind: 'utc' };
}

export function load_settings(): Settings {
  const otherwise = default_settings(matchMedia('(prefers-color-scheme: dark)').matches);
  try {
    return read_settings(localStorage.getItem(KEY), otherwise);
  } catch {
    return otherwise; // a browser may forbid storage; the page works without
  }
}

export function keep_settings(settings: Settings): void {
  try {
    localStorage.setItem(KEY, JSON.stringify(settings));
  } catch {
    // not remembered, then
  }
}
