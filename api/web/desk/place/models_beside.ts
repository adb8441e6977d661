// What a product says beside the wind or the waves: gusts; wind sea and swells apart.
import type { Look } from '../look/look';
import { is_known, NOT_KNOWN } from '../look/units';
import { value_at, type Column } from '../server/coverage';
import type { Kind } from '../server/products';

const GUST = 'wind_speed_of_gust';
/** By what stands before their height, period and direction. */
const SYSTEMS: readonly (readonly [string, string])[] = [
  ['sea_surface_wind_wave', 'wind sea'],
  ['sea_surface_primary_swell_wave', 'swell'],
  ['sea_surface_secondary_swell_wave', 'second swell'],
];
const HEIGHT = 'significant_height';
const PERIOD = 'mean_period';
const FROM = 'from_direction';

/** CF names to ask for, as far as the product has them. */
export const BESIDE: Record<Kind, readonly string[]> = {
  currents: [],
  wind: [GUST],
  waves: SYSTEMS.flatMap(([of]) => [HEIGHT, PERIOD, FROM].map((what) => `${of}_${what}`)),
};

/** One short line each, as "swell 1.2 m from 280°, mean period 9.5 s". */
export function beside_lines(look: Look, column: Column, time: number): string[] {
  const read = (name: string): number | null => value_at(column, name, time, 0);
  const gust = read(GUST);
  const lines = is_known(gust) ? [`gusts ${look.speed(gust, 1)}`] : [];
  for (const [of, word] of SYSTEMS) {
    const height = read(`${of}_${HEIGHT}`);
    if (!is_known(height)) continue;
    const from = look.direction(read(`${of}_${FROM}`));
    const period = read(`${of}_${PERIOD}`);
    lines.push(
      `${word} ${look.metres(height, 1)}${from === NOT_KNOWN ? '' : ` from ${from}`}` +
        (is_known(period) ? `, mean period ${period.toFixed(1)} s` : ''),
    );
  }
  return lines;
}
