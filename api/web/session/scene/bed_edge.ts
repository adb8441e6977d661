// The edge of a bed's grid, and the slope over one step from it to the level beyond.
import type { Bed } from '../session/bed';

/** Places along the edge of a grid, against the clock from its south-western corner. */
export function around(across: number): number[] {
  const last = across - 1;
  const made: number[] = [];
  for (let i = 0; i < last; i += 1) made.push(i);
  for (let i = 0; i < last; i += 1) made.push(i * across + last);
  for (let i = last; i > 0; i -= 1) made.push(last * across + i);
  for (let i = last; i > 0; i -= 1) made.push(i * across);
  return made;
}

/**
 * The height of what is drawn off a grid. Between two places a and b of the edge, and A and B one
 * step farther out, the slope is the triangles a A B and a B b. Nothing: it is a hole.
 */
export function up_beyond(
  { east_m: west_m, north_m: south_m, step_m, across, up_m }: Bed,
  beyond_m: number,
  east_m: number,
  north_m: number,
): number | null {
  const last = across - 1;
  const half = last / 2;
  // In steps from the middle.
  const [x, y] = [(east_m - west_m) / step_m - half, (north_m - south_m) / step_m - half];
  const out = Math.max(Math.abs(x), Math.abs(y));
  if (!(out < half + 1)) return beyond_m;
  // South, east, north, west; and how far along it, against the clock.
  const [side, along] = -y === out ? [0, x] : x === out ? [1, y] : y === out ? [2, -x] : [3, -y];
  const nth = Math.min(last - 1, Math.floor((along * half) / out + half));
  const edge = around(across);
  const of = (i: number): number | null => up_m[edge[i % edge.length]!] ?? null;
  const [a_m, b_m] = [of(side * last + nth), of(side * last + nth + 1)];
  if (a_m === null) return null;
  const from_edge = out - half; // 0 on it, 1 on the level
  const [a, b] = [nth - half, nth + 1 - half];
  const on_a_to_big_b = a + from_edge * ((b * (half + 1)) / half - a);
  const down_m = (from_m: number): number => from_m + from_edge * (beyond_m - from_m);
  if (along <= on_a_to_big_b) return down_m(a_m);
  if (b_m === null) return null;
  const on_b_to_big_b = (b * out) / half;
  const share = (along - on_a_to_big_b) / (on_b_to_big_b - on_a_to_big_b);
  return down_m(a_m) + share * (down_m(b_m) - down_m(a_m));
}
