// The current of the forecast from the surface to the bed, at the origin of the run.
import { as_list, as_number } from './message';

export interface Current {
  up_m: number; // 0 at the surface, below it negative
  east_m_s: number;
  north_m_s: number;
}

/** From the surface down. */
export function read_currents(value: unknown): Current[] {
  const made: Current[] = [];
  for (const one of as_list(value)) {
    const [up_m, east_m_s, north_m_s] = as_list(one).map(as_number);
    if (up_m == null || east_m_s == null || north_m_s == null) continue;
    made.push({ up_m, east_m_s, north_m_s });
  }
  return made.sort((a, b) => b.up_m - a.up_m);
}

/** Linear between the depths that are told; nothing outside of them. */
export function current_at(currents: readonly Current[], up_m: number): Current | null {
  for (let i = 1; i < currents.length; i += 1) {
    const [above, below] = [currents[i - 1]!, currents[i]!];
    if (up_m > above.up_m || up_m < below.up_m) continue;
    const down = (above.up_m - up_m) / (above.up_m - below.up_m);
    const between = (from: number, to: number): number => from + down * (to - from);
    return {
      up_m,
      east_m_s: between(above.east_m_s, below.east_m_s),
      north_m_s: between(above.north_m_s, below.north_m_s),
    };
  }
  return null;
}
