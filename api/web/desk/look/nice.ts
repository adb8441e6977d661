// Round numbers for axes and steps.

/** The next of 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2 ... above. */
export function nice_most(most: number): number {
  if (!(most > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const step = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((n) => n * power >= most * 0.999) ?? 10;
  return Number((step * power).toPrecision(3));
}

/** A step of 1, 2 or 5 of which at most `count` go into `range`. */
export function nice_step(range: number, count: number): number {
  if (!(range > 0)) return 1;
  const least = range / count;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].find((n) => n * power >= least * 0.999) ?? 10;
  return Number((step * power).toPrecision(3));
}
