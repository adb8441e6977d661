// Wind, waves and tide as lines over the hours; names as the server's parameters have them.
import type { Look } from '../look/look';
import { is_known } from '../look/units';
import { time_index, value_at, type Column, type Value } from '../server/coverage';
import { tide_name } from './facts';
import type { Line, Series } from './series_chart';

const DASHES = ['solid', 'dashed', 'dotted'] as const;

export function values_of(column: Column, name: string, level = 0): Value[] {
  return column.times_ms.map((_, time) => value_at(column, name, time, level));
}

/** The band of a quantity, where the server gives one. */
export function band_of(
  column: Column,
  name: string,
  level = 0,
): { low: Value[]; high: Value[] } | null {
  if (column.values[`${name}_p10`] === undefined) return null;
  return {
    low: values_of(column, `${name}_p10`, level),
    high: values_of(column, `${name}_p90`, level),
  };
}

export function wind_series(look: Look, column: Column): Series {
  const speeds = (values: Value[]): Value[] =>
    values.map((value) => (value === null ? null : look.speed_number(value)));
  const lines = column.levels_m.map((height_m, level): Line => {
    const band = band_of(column, 'wind_speed', level);
    return {
      name: level === 0 ? `at ${height_m} m` : `at ${height_m} m, the hub`,
      values: speeds(values_of(column, 'wind_speed', level)),
      band: band === null ? null : { low: speeds(band.low), high: speeds(band.high) },
      dash: DASHES[level % 3] ?? 'solid',
      colour: level === 0 ? 'wind' : 'quiet',
    };
  });
  return {
    times_ms: column.times_ms,
    unit: look.speed_unit,
    from_zero: true,
    lines,
    above: {
      title: `On top: from where it blows at ${column.levels_m[0] ?? 10} m`,
      text: from_words(look, column, 'wind_from_direction'),
    },
  };
}

export function wave_series(look: Look, column: Column): Series {
  const height = 'sea_surface_wave_significant_height';
  const period = 'sea_surface_wave_period_at_variance_spectral_density_maximum';
  return {
    times_ms: column.times_ms,
    unit: 'height, m',
    right_unit: 'period, s',
    from_zero: true,
    lines: [
      {
        name: 'significant height',
        values: values_of(column, height),
        band: band_of(column, height),
        dash: 'solid',
        colour: 'wave',
      },
      {
        name: 'peak period, on the right',
        values: values_of(column, period),
        band: band_of(column, period),
        dash: 'dashed',
        colour: 'quiet',
        is_right: true,
      },
    ],
    above: {
      title: 'On top: from where they come',
      text: from_words(look, column, 'sea_surface_wave_from_direction'),
    },
  };
}

export function tide_series(column: Column): Series {
  const name = tide_name(column);
  const line: Line = {
    name: 'level over mean sea level',
    values: name === null ? [] : values_of(column, name),
    band: name === null ? null : band_of(column, name),
    dash: 'solid',
    colour: 'water',
  };
  return { times_ms: column.times_ms, unit: 'm', from_zero: false, lines: [line] };
}

function from_words(look: Look, column: Column, name: string): (at_ms: number) => string {
  return (at_ms) => {
    const time = time_index(column, at_ms);
    const from = time < 0 ? null : value_at(column, name, time, 0);
    return is_known(from) ? look.direction(from) : '';
  };
}
