// How fast a rate may grow.

/** From `now` towards `wanted`: away from rest so fast at most, towards rest at once. */
export function eased(now: number, wanted: number, most_change: number): number {
  const from = Math.sign(now) === Math.sign(wanted) ? now : 0;
  if (Math.abs(wanted) <= Math.abs(from)) return wanted;
  return from + Math.sign(wanted) * Math.min(Math.abs(wanted - from), most_change);
}
