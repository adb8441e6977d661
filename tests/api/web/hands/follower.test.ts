// What is asked of the camera, from hands whose places are exact.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { is_rest, MOST, WISH_IS_VALID_MS, type CameraWish } from 'page/../look/camera_wish';
import { Follower } from 'page/gesture/follower';
import { spread_of, type Hand } from 'page/gesture/hand';
import {
  bones_of,
  FIST,
  FOCAL,
  hand_of,
  OPEN,
  PALM_M,
  PINCH,
  seeded,
  shaken,
  TWO,
  type Posed,
} from './skeleton_for_tests';

const EVERY_MS = 50;
/** The palm leans a little as its tips do, so that its size is not quite straight: 0.06 at most. */
const SIZED_DEG_S = 0.1;

/** A hand before the camera, 20 pictures a second. */
class Before {
  readonly follower = new Follower();
  now_ms = 1000;
  show(posed: Posed, pictures: number): CameraWish {
    return this.show_hand(hand_of(posed), pictures);
  }
  show_hand(hand: Hand | null, pictures: number): CameraWish {
    for (let i = 0; i < pictures; i += 1) {
      this.now_ms += EVERY_MS;
      this.follower.take(hand, this.now_ms);
    }
    return this.follower.wish_at(this.now_ms);
  }
  /** A pinch where the view is straight, then moved so many palms to the picture's right and up. */
  pinch_and_move(right: number, up: number, posed: Posed = PINCH): CameraWish {
    this.show(posed, 10);
    const moved = (share: number): Posed => ({
      ...posed,
      right_m: (posed.right_m ?? 0) + share * right * PALM_M,
      up_m: (posed.up_m ?? 0) + share * up * PALM_M,
    });
    for (const share of [0.25, 0.5, 0.75]) this.show(moved(share), 1);
    return this.show(moved(1), 40);
  }
}

/**
 * 20 degrees a second at 1.2 palms of the picture, from nothing at 0.2: straight between them. The
 * pinched tips are nearer to the camera than the palm, and so move farther in the picture.
 */
function expected_deg_s(palms: number, away_m = 0.5): number {
  const nearer_m = bones_of(PINCH)[8]![2];
  const seen = (Math.abs(palms) * away_m) / (away_m - nearer_m);
  return 20 * Math.sign(palms) * Math.min(Math.max(seen - 0.2, 0), 1);
}

test('APinchMovedTurnsTheCameraThatWayAsFastAsItIsFarther', () => {
  for (const [right, up] of [
    [0.6, 0],
    [-0.6, 0],
    [0, 0.5],
    [0, -0.5],
    [0.7, -0.9],
    [-2, 2],
  ] as const) {
    const wish = new Before().pinch_and_move(right, up);
    // The picture's right is the person's left.
    const off = [wish.pan_deg_s - expected_deg_s(-right), wish.tilt_deg_s - expected_deg_s(up)];
    for (const it of off) assert.ok(Math.abs(it) < SIZED_DEG_S, `${right} ${up}: ${it}`);
    assert.equal(wish.zoom_per_s, 0);
  }
});

test('ItIsTheSameNearAndFarAndForATurnedHand', () => {
  for (const away_m of [0.3, 0.6, 1.2])
    for (const roll_deg of [-30, 0, 30]) {
      const wish = new Before().pinch_and_move(-0.8, 0.4, { ...PINCH, away_m, roll_deg });
      const [pan, tilt] = [expected_deg_s(0.8, away_m), expected_deg_s(0.4, away_m)];
      assert.ok(Math.abs(wish.pan_deg_s - pan) < SIZED_DEG_S, `${wish.pan_deg_s}, not ${pan}`);
      assert.ok(Math.abs(wish.tilt_deg_s - tilt) < SIZED_DEG_S, `${wish.tilt_deg_s}, not ${tilt}`);
    }
});

test('APictureThatIsAMirrorTurnsTheOtherWay', () => {
  const plain = new Before();
  const mirror = new Before();
  mirror.follower.is_mirrored = true;
  const a = plain.pinch_and_move(0.7, 0.6);
  const b = mirror.pinch_and_move(0.7, 0.6);
  assert.ok(a.pan_deg_s < 0);
  assert.equal(b.pan_deg_s, -a.pan_deg_s);
  assert.equal(b.tilt_deg_s, a.tilt_deg_s);
});

test('NoiseOfTwoPercentOfTheHandMovesNothingInTheDeadZone', () => {
  for (const posed of [
    PINCH,
    { ...PINCH, right_m: 0.05 * PALM_M },
    { ...TWO, apart_deg: 8 },
    OPEN,
  ]) {
    const before = new Before();
    const random = seeded(37);
    const size = (FOCAL * PALM_M) / 0.5;
    for (let i = 0; i < 2000; i += 1) {
      const wish = before.show_hand(shaken(hand_of(posed), 0.02, size, random), 1);
      assert.ok(is_rest(wish), `picture ${i}: ${JSON.stringify(wish)}`);
    }
  }
});

test('NoiseOfTwoPercentLeavesTheRateWithinAHand', () => {
  const before = new Before();
  const random = seeded(38);
  const size = (FOCAL * PALM_M) / 0.5;
  before.show(PINCH, 10);
  const moved = hand_of({ ...PINCH, right_m: -0.7 * PALM_M });
  before.show_hand(moved, 20);
  for (let i = 0; i < 500; i += 1) {
    const { pan_deg_s } = before.show_hand(shaken(moved, 0.02, size, random), 1);
    // Smoothed, the noise leaves a deviation of 0.13 degrees a second: four of them in 500.
    assert.ok(Math.abs(pan_deg_s - expected_deg_s(0.7)) < 0.52, `${pan_deg_s}`);
  }
});

test('TwoFingersApartZoomInAndTogetherOut', () => {
  const zoom = (apart_deg: number): number =>
    new Before().show({ ...TWO, apart_deg }, 40).zoom_per_s;
  assert.equal(zoom(8), 0);
  // At rest 0.28 to 0.52 hands apart, full from 0.67 on and at 0.13, straight between.
  const apart = spread_of(hand_of({ ...TWO, apart_deg: -7 }));
  assert.ok(apart > 0.13 && apart < 0.28);
  const expected = (-MOST.zoom_per_s * (0.28 - apart)) / (0.28 - 0.13);
  assert.ok(Math.abs(zoom(-7) - expected) < 1e-6, `${zoom(-7)}, not ${expected}`);
  assert.ok(zoom(18) > 0 && zoom(18) < MOST.zoom_per_s);
  assert.equal(zoom(30), MOST.zoom_per_s);
  assert.equal(zoom(45), MOST.zoom_per_s);
  const turned = new Before().show({ ...TWO, apart_deg: 30 }, 40);
  assert.equal(turned.pan_deg_s, 0);
  assert.equal(turned.tilt_deg_s, 0);
});

test('AHandThatIsLostStopsItWithin300Milliseconds', () => {
  const seen = new Before(); // the pictures go on, the hand is gone
  assert.ok(!is_rest(seen.pinch_and_move(-1, 0)));
  assert.ok(is_rest(seen.show_hand(null, 1)));
  const stalled = new Before(); // no more pictures
  assert.ok(!is_rest(stalled.pinch_and_move(-1, 0)));
  assert.ok(!is_rest(stalled.follower.wish_at(stalled.now_ms + WISH_IS_VALID_MS - 1)));
  assert.ok(is_rest(stalled.follower.wish_at(stalled.now_ms + 301)));
  assert.ok(WISH_IS_VALID_MS <= 300);
});

test('AHandThatComesBackHasToPinchAnew', () => {
  const before = new Before();
  before.pinch_and_move(-1, 0);
  before.show_hand(null, 1);
  const wish = before.show({ ...PINCH, right_m: -PALM_M }, 40); // where it was: rest is there now
  assert.ok(is_rest(wish), JSON.stringify(wish));
});

test('WhatStopsStopsAtOnce', () => {
  const stops: [string, Hand][] = [
    ['open', hand_of({ ...OPEN, right_m: -PALM_M })],
    ['fist', hand_of({ ...FIST, right_m: -PALM_M })],
    ['unsure', hand_of({ ...PINCH, right_m: -PALM_M }, 0.5)],
    ['jump', hand_of({ ...PINCH, right_m: 2 * PALM_M })],
    ['jump', hand_of({ ...PINCH, right_m: -PALM_M, away_m: 0.9 })],
    ['unsure', { landmarks: [], sureness: 1 }],
    ['unsure', { landmarks: Array(21).fill({ x: Number.NaN, y: 0 }), sureness: 1 }],
  ];
  for (const [seen, hand] of stops) {
    const before = new Before();
    assert.ok(!is_rest(before.pinch_and_move(-1, 0)), seen);
    assert.ok(is_rest(before.show_hand(hand, 1)), seen);
    assert.equal(before.follower.seen, seen);
  }
});

test('AShapeInOnePictureAloneIsNotMeant', () => {
  const before = new Before();
  for (let i = 0; i < 20; i += 1) {
    assert.ok(is_rest(before.show({ ...TWO, apart_deg: 35 }, 1)));
    assert.ok(is_rest(before.show(OPEN, 1)));
  }
});

test('ItBeginsSoftlyAndNeverGoesFasterThanItsMost', () => {
  const before = new Before();
  before.show(PINCH, 10);
  let last = 0;
  for (let i = 0; i < 40; i += 1) {
    const { pan_deg_s } = before.show({ ...PINCH, right_m: -1.4 * PALM_M }, 1);
    const most_more = (MOST.pan_deg_s * EVERY_MS) / 400 + 1e-9;
    assert.ok(pan_deg_s - last <= most_more && pan_deg_s <= MOST.pan_deg_s, `${i}: ${pan_deg_s}`);
    last = pan_deg_s;
  }
  assert.equal(last, MOST.pan_deg_s);
});

test('ASlowDetectorAsksForNothing', () => {
  // Pictures are seen 3 s after they were taken, one each 3 s.
  const follower = new Follower();
  for (let i = 1; i <= 10; i += 1) {
    follower.take(hand_of({ ...PINCH, right_m: i < 5 ? 0 : -PALM_M }), 3000 * i);
    assert.ok(is_rest(follower.wish_at(3000 * (i + 1))), `picture ${i}`);
  }
  assert.ok(!is_rest(follower.wish_at(30_000)), 'seen at once it would turn');
});

test('APictureTwiceOrFromBeforeChangesNothing', () => {
  const before = new Before();
  const wish = before.pinch_and_move(-1, 0);
  before.follower.take(null, before.now_ms);
  before.follower.take(null, before.now_ms - 500);
  assert.deepEqual(before.follower.wish_at(before.now_ms), wish);
});
