// Current, wind and waves at all columns of the site, all hours at once: asked for when a forecast
// comes into force, then only read.
import type { SiteMap } from '../server/answers';
import { level_index, time_index, value_at, type Column, type Value } from '../server/coverage';
import { Refused, type Server } from '../server/server';

const KINDS = {
  currents: 'sea_water_speed,sea_water_velocity_to_direction',
  wind: 'wind_speed,wind_from_direction',
  waves:
    'sea_surface_wave_significant_height,sea_surface_wave_from_direction,' +
    'sea_surface_wave_period_at_variance_spectral_density_maximum',
} as const;
type Kind = keyof typeof KINDS;

/** What blows, runs and rolls at a column at one hour. */
export interface Weather {
  current_m_s: Value;
  current_to_deg: Value;
  current_depth_m: Value; // of the level that is shown
  wind_m_s: Value;
  wind_from_deg: Value;
  wave_height_m: Value;
  wave_period_s: Value;
  wave_from_deg: Value;
}

export interface Field {
  of: Record<Kind, Column[]>;
  /** What the server said where it refused. */
  refused: string[];
}

const ROOM_DEG = 0.002; // around the outermost columns, so that they are inside of the box

export async function fetch_field(server: Server, site: SiteMap): Promise<Field> {
  const x = site.columns.map(({ longitude_deg }) => longitude_deg);
  const y = site.columns.map(({ latitude_deg }) => latitude_deg);
  const box = [
    Math.min(...x) - ROOM_DEG,
    Math.min(...y) - ROOM_DEG,
    Math.max(...x) + ROOM_DEG,
    Math.max(...y) + ROOM_DEG,
  ].map((degrees) => degrees.toFixed(5));
  const { forecast } = site;
  const field: Field = { of: { currents: [], wind: [], waves: [] }, refused: [] };
  if (forecast === null || x.length === 0) return field;
  await Promise.all(
    (Object.keys(KINDS) as Kind[]).map(async (kind) => {
      const query = new URLSearchParams({
        bbox: box.join(),
        datetime: `${forecast.valid_from}/${forecast.valid_to}`,
        'parameter-name': KINDS[kind],
        ...(kind === 'waves' ? {} : { z: kind === 'wind' ? '10' : site.levels_m.join() }),
        f: 'CoverageJSON',
      });
      try {
        field.of[kind] = await server.columns(`${kind}/cube?${query}`);
      } catch (problem) {
        if (!(problem instanceof Refused)) throw problem;
        field.refused.push(`${kind}: ${problem.detail}`);
      }
    }),
  );
  return field;
}

export function weather_at(
  field: Field,
  place: { longitude_deg: number; latitude_deg: number },
  at_ms: number,
  depth_m: number,
): Weather {
  const read = (kind: Kind, level_m: number): ((name: string) => Value) => {
    const column = nearest(field.of[kind], place);
    const time = column === null ? -1 : time_index(column, at_ms);
    const level = column === null ? null : level_index(column, level_m);
    if (column === null || time < 0 || level === null) return () => null;
    return (name) =>
      name === '' ? (column.levels_m[level] ?? null) : value_at(column, name, time, level);
  };
  const current = read('currents', depth_m);
  const wind = read('wind', 10);
  const waves = read('waves', 0);
  return {
    current_m_s: current('sea_water_speed'),
    current_to_deg: current('sea_water_velocity_to_direction'),
    current_depth_m: current(''),
    wind_m_s: wind('wind_speed'),
    wind_from_deg: wind('wind_from_direction'),
    wave_height_m: waves('sea_surface_wave_significant_height'),
    wave_period_s: waves('sea_surface_wave_period_at_variance_spectral_density_maximum'),
    wave_from_deg: waves('sea_surface_wave_from_direction'),
  };
}

const NEAR_DEG = 0.001; // the server writes a column's place with fewer digits than the site

function nearest(
  columns: Column[],
  { longitude_deg, latitude_deg }: { longitude_deg: number; latitude_deg: number },
): Column | null {
  const is_here = (column: Column): boolean =>
    Math.abs(column.longitude_deg - longitude_deg) < NEAR_DEG &&
    Math.abs(column.latitude_deg - latitude_deg) < NEAR_DEG;
  return columns.find(is_here) ?? null;
}
