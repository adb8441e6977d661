// How far something is leaned, as a share: the one law for sticks, hands and fingers.

/** 0 within the dead zone, from its edge straight to 1 where it is full, and no more. */
export function beyond(offset: number, dead: number, full: number): number {
  const share = (Math.abs(offset) - dead) / (full - dead);
  return share > 0 ? Math.sign(offset) * Math.min(share, 1) : 0; // also where it is no number
}
