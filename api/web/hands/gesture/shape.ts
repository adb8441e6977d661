// What a hand shows, by where its fingertips are.
import { at, distance, FINGERS, size_of, THUMB_TIP, WRIST, type Hand } from './hand';

export type Shape = 'open' | 'pinch' | 'two' | 'fist' | 'other';

/** Distance of thumb and index tips, in sizes of the hand: closed below, open again above. */
const PINCH_CLOSES = 0.3;
const PINCH_OPENS = 0.45;
/** Distance of a tip from the wrist, in that of its finger's middle joint. */
const STRAIGHT_FROM = 1.1;
const CURLED_TO = 1.0;

/** @param before what it showed a picture ago: a pinch is kept longer than it is begun. */
export function shape_of(hand: Hand, before: Shape): Shape {
  const reach = FINGERS.map(
    ({ middle, tip }) =>
      distance(at(hand, WRIST), at(hand, tip)) / distance(at(hand, WRIST), at(hand, middle)),
  );
  const is_straight = reach.map((it) => it >= STRAIGHT_FROM);
  const is_curled = reach.map((it) => it <= CURLED_TO);
  if (is_curled.every(Boolean)) return 'fist';
  const gap = distance(at(hand, THUMB_TIP), at(hand, FINGERS[0].tip)) / size_of(hand);
  // In a half closed fist the thumb lies at the index too: a pinch leaves other fingers up.
  const others_are_up = is_straight[1] === true || is_straight[2] === true;
  if (others_are_up && gap < (before === 'pinch' ? PINCH_OPENS : PINCH_CLOSES)) return 'pinch';
  if (is_straight[0] && is_straight[1] && is_curled[2] && is_curled[3]) return 'two';
  return is_straight.every(Boolean) ? 'open' : 'other';
}
