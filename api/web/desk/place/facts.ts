// The place at the slider's hour, in words and numbers.
import type { Look } from '../look/look';
import { element } from '../../look/element';
import { is_known, NOT_KNOWN } from '../look/units';
import { level_index, time_index, value_at, type Column, type Value } from '../server/coverage';
import type { Level } from './profile';
import type { Water } from './water';

type Fact = [string, string];

export function facts_of(
  look: Look,
  water: Water,
  levels: Level[],
  depth_m: number,
  at_ms: number,
): Fact[] {
  const facts: Fact[] = [];
  const { currents, wind, waves, tide } = water;
  if (currents.column !== null) {
    const k = level_index(currents.column, depth_m);
    const level = k === null ? undefined : levels[k];
    facts.push([
      `Current at ${level?.depth_m ?? depth_m} m`,
      level === undefined
        ? 'The bed is above this depth.'
        : directed(look.speed(level.speed_m_s, 2), 'to', look.direction(level.to_deg)),
    ]);
  }
  if (wind.column !== null) {
    wind.column.levels_m.forEach((height_m, k) => {
      const read = reader(wind.column, at_ms, k);
      const from = look.direction(read('wind_from_direction'));
      facts.push([`Wind at ${height_m} m`, directed(look.speed(read('wind_speed')), 'from', from)]);
    });
  }
  if (waves.column !== null) {
    const read = reader(waves.column, at_ms, 0);
    const height = look.metres(read('sea_surface_wave_significant_height'), 1);
    const period = read('sea_surface_wave_period_at_variance_spectral_density_maximum');
    const from = look.direction(read('sea_surface_wave_from_direction'));
    const seconds = is_known(period) ? `, period ${period.toFixed(1)} s` : '';
    facts.push(['Waves', `${directed(height, 'from', from)}${seconds}`]);
  }
  if (tide.column !== null) {
    const name = tide_name(tide.column);
    const level = name === null ? null : reader(tide.column, at_ms, 0)(name);
    facts.push(['Tide', is_known(level) ? `${signed(level)} m about mean sea level` : NOT_KNOWN]);
  }
  return facts;
}

function directed(size: string, word: 'to' | 'from', direction: string): string {
  return size === NOT_KNOWN ? 'no value at this hour' : `${size} ${word} ${direction}`;
}

function reader(column: Column | null, at_ms: number, level: number): (name: string) => Value {
  if (column === null) return () => null;
  const time = time_index(column, at_ms);
  return (name) => (time < 0 ? null : value_at(column, name, time, level));
}

const signed = (value: number): string => `${value < 0 ? '−' : '+'}${Math.abs(value).toFixed(2)}`;

/** The tide's own value among the parameters: not a band's. */
export function tide_name(column: Column): string | null {
  return Object.keys(column.values).find((name) => !/_p\d\d$|_member_/.test(name)) ?? null;
}

export function level_table(look: Look, levels: Level[]): HTMLElement {
  const parts = (band: [number, number] | null): string =>
    band === null
      ? NOT_KNOWN
      : band.map((speed) => look.speed_number(speed).toFixed(2).replace('-', '−')).join(' to ');
  const unit = look.speed_unit;
  const heads = ['Depth', 'Speed', 'To', `East, p10–p90, ${unit}`, `North, p10–p90, ${unit}`];
  const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
  const rows = levels.map((level) =>
    element(
      'tr',
      {},
      element('th', { scope: 'row' }, `${level.depth_m} m`),
      element('td', {}, look.speed(level.speed_m_s, 2)),
      element('td', {}, look.direction(level.to_deg)),
      element('td', {}, parts(level.east_band)),
      element('td', {}, parts(level.north_band)),
    ),
  );
  return element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows));
}
