// The place at the slider's hour, in words and numbers.
import type { Look } from '../look/look';
import { element } from '../../look/element';
import { is_known, NOT_KNOWN } from '../look/units';
import { level_index, time_index, value_at, type Column, type Value } from '../server/coverage';
import type { ChartDatum } from '../server/answers';
import type { Level } from './profile';
import type { Water } from './water';

type Fact = [string, string];

export function facts_of(
  look: Look,
  water: Water,
  levels: Level[],
  depth_m: number,
  at_ms: number,
  datum: ChartDatum | null,
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
    facts.push(['Tide', is_known(level) ? tide_words(level, datum) : NOT_KNOWN]);
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

/** Over both levels; another level to count from is another unit, and no other number. */
export function tide_words(level_m: number, datum: ChartDatum | null): string {
  const over_mean = `${signed(level_m)} m over mean sea level`;
  if (datum === null) return `${over_mean}; the site states no chart datum`;
  const over_datum = signed(level_m + datum.below_mean_sea_level_m);
  return `${over_mean}, ${over_datum} m over chart datum (${datum.name})`;
}

/** What stands below the tide's lines. */
export function datum_words(datum: ChartDatum | null): string {
  if (datum === null) return 'Over mean sea level; the site states no chart datum.';
  const below_m = datum.below_mean_sea_level_m.toFixed(2);
  const is_below = `is ${below_m} m below it: ${datum.source}`;
  return `Over mean sea level. Chart datum (${datum.name}) ${is_below}.`;
}

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
