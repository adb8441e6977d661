// The current over the depth at one hour, as the server gives it: a row for each level.
import { value_at, type Column, type Value } from '../server/coverage';

export interface Level {
  depth_m: number;
  speed_m_s: Value;
  to_deg: Value;
  east_m_s: Value;
  north_m_s: Value;
  /** p10 and p90; null where the server gives no band. */
  east_band: [number, number] | null;
  north_band: [number, number] | null;
}

const EAST = 'eastward_sea_water_velocity';
const NORTH = 'northward_sea_water_velocity';

export function profile_at(column: Column, time: number): Level[] {
  return column.levels_m.map((depth_m, level) => {
    const read = (name: string): Value => (time < 0 ? null : value_at(column, name, time, level));
    const band = (name: string): [number, number] | null => {
      const low = read(`${name}_p10`);
      const high = read(`${name}_p90`);
      return low === null || high === null ? null : [low, high];
    };
    return {
      depth_m,
      speed_m_s: read('sea_water_speed'),
      to_deg: read('sea_water_velocity_to_direction'),
      east_m_s: read(EAST),
      north_m_s: read(NORTH),
      east_band: band(EAST),
      north_band: band(NORTH),
    };
  });
}

/** Rows without a gap: a missing level ends a line, it is never bridged. */
export function runs<T>(rows: T[], is_there: (row: T) => boolean): T[][] {
  const found: T[][] = [];
  let run: T[] = [];
  for (const row of rows) {
    if (is_there(row)) {
      run.push(row);
    } else if (run.length > 0) {
      found.push(run);
      run = [];
    }
  }
  if (run.length > 0) found.push(run);
  return found;
}

/** The largest component, bands and all, over all hours: axes stay while the hour moves. */
export function largest_m_s(column: Column): number {
  let most = 0;
  for (const [name, values] of Object.entries(column.values)) {
    if (!name.startsWith(EAST) && !name.startsWith(NORTH)) continue;
    for (const value of values) if (value !== null) most = Math.max(most, Math.abs(value));
  }
  return most;
}
