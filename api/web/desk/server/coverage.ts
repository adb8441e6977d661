// CoverageJSON as the server's EDR gives it, read into columns: values by time and level.
import type { Place } from '../view';

/** A missing value is null: it is never drawn as calm water. */
export type Value = number | null;

export interface Column extends Place {
  times_ms: number[];
  levels_m: number[]; // depth down or height up; one 0 where the quantity has no level
  /** By CF name: values[time * levels + level]. */
  values: Record<string, Value[]>;
}

interface NdArray {
  shape?: number[];
  axisNames?: string[];
  values: (number | null)[];
}
interface Coverage {
  type: string;
  domain: { axes: Record<string, { values?: (number | string)[] }> };
  ranges: Record<string, NdArray>;
}

export function read_coverages(answer: unknown): Column[] {
  const given = answer as Partial<Coverage> & { coverages?: Coverage[] };
  const coverages = given.type === 'CoverageCollection' ? (given.coverages ?? []) : [given];
  return coverages.flatMap((coverage) => columns_of(coverage as Coverage));
}

function columns_of(coverage: Coverage): Column[] {
  const axes = coverage.domain?.axes ?? {};
  const numbers = (name: string): number[] => (axes[name]?.values ?? []).map(Number);
  const times_ms = (axes.t?.values ?? []).map((text) => Date.parse(String(text)));
  const x = numbers('x');
  const y = numbers('y');
  const z = axes.z?.values === undefined ? [0] : numbers('z');
  const columns: Column[] = [];
  y.forEach((latitude_deg, j) =>
    x.forEach((longitude_deg, i) => {
      const values: Record<string, Value[]> = {};
      for (const [name, range] of Object.entries(coverage.ranges ?? {})) {
        const at = strides(range);
        values[name] = times_ms.flatMap((_, t) =>
          z.map((_, k) => range.values[at.t * t + at.z * k + at.y * j + at.x * i] ?? null),
        );
      }
      // A grid may have corners where no column stands.
      const has_values = Object.values(values).some((all) => all.some((value) => value !== null));
      if (has_values || x.length * y.length === 1) {
        columns.push({ longitude_deg, latitude_deg, times_ms, levels_m: z, values });
      }
    }),
  );
  return columns;
}

/** How far apart two neighbours along each axis stand; 0 along an axis that the array has not. */
function strides(range: NdArray): Record<'t' | 'z' | 'y' | 'x', number> {
  const found = { t: 0, z: 0, y: 0, x: 0 };
  let stride = 1;
  const names = range.axisNames ?? [];
  for (let a = names.length - 1; a >= 0; a -= 1) {
    const name = names[a] as keyof typeof found;
    if (name in found) found[name] = stride;
    stride *= range.shape?.[a] ?? 1;
  }
  return found;
}

/**
 * Of the column's times the one nearest to a moment; -1 where the moment is outside of them. Of two
 * as near the later, as the server chooses: means stand in the middle of hours, and one begins.
 */
export function time_index(column: Column, at_ms: number): number {
  const { times_ms } = column;
  const first = times_ms[0] ?? Infinity;
  const last = times_ms[times_ms.length - 1] ?? -Infinity;
  const step = times_ms.length > 1 ? (times_ms[1] ?? first) - first : 3_600_000;
  // Written so that a moment that is not known is outside, too.
  if (!(at_ms >= first - step / 2 && at_ms <= last + step / 2)) return -1;
  return times_ms.reduce(
    (best, time, i) =>
      Math.abs(time - at_ms) <= Math.abs((times_ms[best] ?? 0) - at_ms) ? i : best,
    0,
  );
}

/** The level nearest to a wanted one; null where the column has none as deep. */
export function level_index(column: Column, level_m: number): number | null {
  const { levels_m } = column;
  const deepest = Math.max(...levels_m);
  if (levels_m.length === 0 || level_m > deepest + 0.5) return null;
  return levels_m.reduce(
    (best, level, i) =>
      Math.abs(level - level_m) < Math.abs((levels_m[best] ?? 0) - level_m) ? i : best,
    0,
  );
}

export function value_at(column: Column, name: string, time: number, level: number): Value {
  return column.values[name]?.[time * column.levels_m.length + level] ?? null;
}
