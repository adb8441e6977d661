// How fast, by how far a hand is from rest.

/** 0 within the dead zone, from its edge straight to 1 where it is full, and no more. */
export function beyond(offset: number, dead: number, full: number): number {
  const share = (Math.abs(offset) - dead) / (full - dead);
  return share <= 0 ? 0 : Math.sign(offset) * Math.min(share, 1);
}

/** From `now` towards `wanted`: away from rest so fast at most, towards rest at once. */
export function eased(now: number, wanted: number, most_change: number): number {
  const from = Math.sign(now) === Math.sign(wanted) ? now : 0;
  if (Math.abs(wanted) <= Math.abs(from)) return wanted;
  return from + Math.sign(wanted) * Math.min(Math.abs(wanted - from), most_change);
}
