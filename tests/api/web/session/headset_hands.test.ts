// Joints and bones of a bare hand, a pinch, a pointing finger.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { BONES, is_pinch, is_pointing_hand, JOINTS } from 'page/xr/joints';

test('a hand has 25 joints, and bones from the wrist to each finger tip', () => {
  assert.equal(JOINTS.length, 25);
  assert.equal(new Set(JOINTS).size, 25);
  assert.equal(BONES.length, 24);
  for (let nth = 1; nth < 25; nth += 1) {
    let at = nth;
    for (let i = 0; i < 5 && at !== 0; i += 1) at = BONES.find(([, into]) => into === at)![0];
    assert.equal(at, 0, `${JOINTS[nth]} hangs on the wrist`);
  }
});

test('a pinch ends farther apart than it begins', () => {
  assert.deepEqual(
    [0.02, 0.014, 0.02, 0.029, 0.031, 0.02].map(
      (() => {
        let is = false;
        return (apart_m: number) => (is = is_pinch(is, apart_m));
      })(),
    ),
    [false, true, true, true, false, false],
  );
});

test('a stretched index among bent fingers points, a flat hand and a fist do not', () => {
  /** The knuckles 9 cm from the wrist, the tips as far as told. */
  const hand = (index_m: number, others_m: number): Vector3[] =>
    JOINTS.map((joint) => {
      const tip_m = joint.startsWith('index') ? index_m : others_m;
      return new Vector3(0, 0, joint === 'wrist' ? 0 : joint.endsWith('tip') ? -tip_m : -0.09);
    });
  assert.equal(is_pointing_hand(hand(0.17, 0.07)), true);
  assert.equal(is_pointing_hand(hand(0.17, 0.17)), false);
  assert.equal(is_pointing_hand(hand(0.07, 0.07)), false);
  assert.equal(is_pointing_hand([]), false);
});
