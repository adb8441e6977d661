// The bed of the run's site on a square grid, where somebody knows it.
import { as_list, as_number, as_object } from './message';

const MOST_ACROSS = 200; // a server tells 41

export interface Bed {
  east_m: number; // of its south-western corner
  north_m: number;
  step_m: number;
  across: number;
  /** Rows from the south, each from the west; null: nobody knows. */
  up_m: (number | null)[];
}

/** Nothing where it is not told, or is no grid. */
export function read_bed(value: unknown): Bed | null {
  const it = as_object(value);
  if (it === null) return null;
  const [east_m, north_m] = [as_number(it.east_m), as_number(it.north_m)];
  const [step_m, across] = [as_number(it.step_m), as_number(it.across)];
  if (east_m === null || north_m === null || step_m === null || across === null) return null;
  const is_grid = step_m > 0 && Number.isInteger(across) && across >= 2 && across <= MOST_ACROSS;
  const up_m = as_list(it.up_m).map(as_number);
  if (!is_grid || up_m.length !== across * across) return null;
  return up_m.every((one) => one === null) ? null : { east_m, north_m, step_m, across, up_m };
}

/**
 * The height of the bed as it is drawn: each square of the grid is two triangles, parted from its
 * north-western corner to its south-eastern one. Nothing off the grid, and where nobody knows.
 */
export function bed_at(bed: Bed, east_m: number, north_m: number): number | null {
  const right = (east_m - bed.east_m) / bed.step_m;
  const up = (north_m - bed.north_m) / bed.step_m;
  const last = bed.across - 1;
  if (!(right >= 0 && right <= last && up >= 0 && up <= last)) return null;
  const [column, row] = [Math.min(last - 1, Math.floor(right)), Math.min(last - 1, Math.floor(up))];
  const [x, y] = [right - column, up - row];
  const of = (dx: number, dy: number): number | null =>
    bed.up_m[(row + dy) * bed.across + column + dx] ?? null;
  const [nw, se] = [of(0, 1), of(1, 0)];
  const is_south_west = x + y <= 1;
  const third = is_south_west ? of(0, 0) : of(1, 1);
  if (nw === null || se === null || third === null) return null;
  return is_south_west
    ? third + x * (se - third) + y * (nw - third)
    : third + (1 - x) * (nw - third) + (1 - y) * (se - third);
}

/** What is drawn beyond the grid: the middle one of the heights along its edge. */
export function level_beyond_m({ across, up_m }: Bed): number {
  const is_edge = (nth: number): boolean => {
    const [row, column] = [Math.floor(nth / across), nth % across];
    return row === 0 || column === 0 || row === across - 1 || column === across - 1;
  };
  const known = (list: (number | null)[]): number[] => list.filter((it) => it !== null);
  const edge = known(up_m.filter((_, nth) => is_edge(nth)));
  const heights = (edge.length > 0 ? edge : known(up_m)).sort((a, b) => a - b);
  return heights[Math.floor(heights.length / 2)] ?? 0;
}

/** Places of the grid where nobody knows the bed. */
export function holes_in(bed: Bed): number {
  return bed.up_m.filter((it) => it === null).length;
}
