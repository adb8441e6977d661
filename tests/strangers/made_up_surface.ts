// A pile as a server tells a surface that is inspected: patches round it and down it, of two
// triangles each. Patch by patch against the clock as seen from above, from the south on, the
// highest row first.
export function made_up_pile(
  east_m: number,
  north_m: number,
  around: number,
  down: number,
  { radius_m = 3.5, top_m = 0, bottom_m = -25 } = {},
): object {
  const corners: number[] = [];
  for (let row = 0; row <= down; row += 1)
    for (let column = 0; column < around; column += 1) {
      const turn = (2 * Math.PI * column) / around;
      corners.push(
        east_m + radius_m * Math.sin(turn),
        north_m - radius_m * Math.cos(turn),
        top_m + ((bottom_m - top_m) * row) / down,
      );
    }
  const triangles: number[] = [];
  const patch_of: number[] = [];
  for (let row = 0; row < down; row += 1)
    for (let column = 0; column < around; column += 1) {
      const next = (column + 1) % around;
      const [a, b] = [row * around + column, row * around + next];
      triangles.push(a, a + around, b, b, a + around, b + around);
      patch_of.push(row * around + column, row * around + column);
    }
  return { name: 'pile', kind: 'monopile', corners, triangles, patch_of };
}
