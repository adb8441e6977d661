// A hand as the detector has it: 21 landmarks in the picture, and how sure that is.

/** x to the right, y down, both in heights of the picture. */
export interface Point {
  x: number;
  y: number;
}

export interface Hand {
  landmarks: readonly Point[];
  sureness: number; // 0 to 1, whether it is a left or a right one: a blurred hand is neither
}

/** Places of the landmarks in the list, by the detector's own order. */
export const WRIST = 0;
export const THUMB_TIP = 4;
export const MIDDLE_KNUCKLE = 9;
export const FINGERS = [
  { knuckle: 5, middle: 6, tip: 8 }, // index
  { knuckle: 9, middle: 10, tip: 12 },
  { knuckle: 13, middle: 14, tip: 16 },
  { knuckle: 17, middle: 18, tip: 20 }, // little finger
] as const;

export function at(hand: Hand, landmark: number): Point {
  return hand.landmarks[landmark] ?? { x: Number.NaN, y: Number.NaN };
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** Of palms: from wrist to middle knuckle, in that from index knuckle to little one. */
const PALM_LENGTH_IN_WIDTHS = 1.5;

/** The palm's length in the picture; by its width where the hand leans to or from the camera. */
export function size_of(hand: Hand): number {
  const length = distance(at(hand, WRIST), at(hand, MIDDLE_KNUCKLE));
  const width = distance(at(hand, FINGERS[0].knuckle), at(hand, FINGERS[3].knuckle));
  return Math.max(length, PALM_LENGTH_IN_WIDTHS * width);
}

/** Where thumb and index meet. */
export function pinch_point(hand: Hand): Point {
  const thumb = at(hand, THUMB_TIP);
  const index = at(hand, FINGERS[0].tip);
  return { x: (thumb.x + index.x) / 2, y: (thumb.y + index.y) / 2 };
}

/** How far the tips of index and middle finger are apart, in sizes of the hand. */
export function spread_of(hand: Hand): number {
  return distance(at(hand, FINGERS[0].tip), at(hand, FINGERS[1].tip)) / size_of(hand);
}
