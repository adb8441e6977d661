// Which shape a hand shows, as it is turned and placed before the camera.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { size_of, spread_of } from 'page/gesture/hand';
import { shape_of, type Shape } from 'page/gesture/shape';
import { FIST, FOCAL, hand_of, OPEN, PALM_M, PINCH, TWO, type Posed } from './skeleton_for_tests';

const SHAPES: [Shape, Posed][] = [
  ['open', OPEN],
  ['fist', FIST],
  ['pinch', PINCH],
  ['two', TWO],
];

test('EachShapeIsToldWhereverTheHandIsAndHoweverItIsTurned', () => {
  for (const [shape, posed] of SHAPES)
    for (const roll_deg of [-60, -20, 0, 35, 90])
      for (const yaw_deg of [-30, 0, 30])
        for (const pitch_deg of [-20, 0, 20])
          for (const [right_m, up_m, away_m] of [
            [0, 0, 0.4],
            [0.2, -0.1, 0.8],
          ] as const) {
            const hand = hand_of({ ...posed, roll_deg, yaw_deg, pitch_deg, right_m, up_m, away_m });
            const how = `${shape} ${roll_deg} ${yaw_deg} ${pitch_deg} ${right_m}`;
            assert.equal(shape_of(hand, 'other'), shape, how);
          }
});

test('AMirroredHandShowsTheSame', () => {
  for (const [shape, posed] of SHAPES) {
    const hand = hand_of(posed);
    const landmarks = hand.landmarks.map(({ x, y }) => ({ x: -x, y }));
    assert.equal(shape_of({ ...hand, landmarks }, 'other'), shape);
  }
});

test('TheSizeIsThatOfThePalmByTheLawOfThePinhole', () => {
  for (const away_m of [0.3, 0.6, 1.2]) {
    const size = size_of(hand_of({ ...OPEN, away_m }));
    assert.ok(Math.abs(size - (FOCAL * PALM_M) / away_m) < 0.03 * size, `${away_m} m: ${size}`);
  }
});

test('APinchIsKeptOpenerThanItIsBegun', () => {
  const between = hand_of({ ...PINCH, pinch_gap_m: 0.37 * PALM_M });
  assert.notEqual(shape_of(between, 'other'), 'pinch');
  assert.equal(shape_of(between, 'pinch'), 'pinch');
  const open = hand_of({ ...PINCH, pinch_gap_m: 0.52 * PALM_M });
  assert.notEqual(shape_of(open, 'pinch'), 'pinch');
});

test('AFistWithTheThumbAtTheIndexIsNoPinch', () => {
  for (const curl of [55, 65, 80, 90])
    for (const before of ['other', 'pinch'] as const) {
      const posed: Posed = { curl_deg: [curl, curl, curl, curl], pinch_gap_m: 0 };
      assert.notEqual(shape_of(hand_of(posed), before), 'pinch', `${curl}`);
    }
});

test('TwoFingersApartAreFartherApart', () => {
  const spreads = [-10, 0, 10, 20, 35].map((apart_deg) =>
    spread_of(hand_of({ ...TWO, apart_deg })),
  );
  spreads.slice(1).forEach((it, i) => assert.ok(spreads[i]! < it, `${spreads}`));
});
