// Joints and bones of a bare hand, a pinch, a pointing finger; what is read of a frame.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { BONES, is_pinch, is_pointing_hand, JOINTS } from 'page/xr/joints';
import { HandReader, type HandReading } from 'page/xr/reading';

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

/** A frame whose spaces are their own poses; null: it is not known where that is. */
function frame_of(...sources: unknown[]): XRFrame {
  const pose = (at: number[] | null): unknown => {
    if (at === null) return null;
    const [x, y, z] = at;
    const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
    return { transform: { matrix, position: { x, y, z } } };
  };
  return {
    session: { inputSources: sources },
    getPose: pose,
    getJointPose: pose,
  } as unknown as XRFrame;
}
const SPACE = {} as XRReferenceSpace;
const source = (given: object): object => ({
  handedness: 'left',
  targetRayMode: 'tracked-pointer',
  targetRaySpace: [0, 1, 2],
  gripSpace: [3, 4, 5],
  ...given,
});
const buttons_of = (pressed: Record<number, number>): unknown[] =>
  Array.from({ length: 6 }, (_, nth) => {
    const value = pressed[nth] ?? 0;
    return { value, pressed: value > 0 };
  });

test('a controller is read by the standard mapping: trigger, grip, stick, lower and upper', () => {
  const read = (pressed: Record<number, number>, axes = [0.9, 0.8, -0.5, 0.25]): HandReading =>
    new HandReader().read(
      frame_of(source({ gamepad: { axes, buttons: buttons_of(pressed) } })),
      SPACE,
    )[0]!;
  const does = (it: HandReading): boolean[] => [
    it.is_pressed,
    it.is_squeezed,
    it.is_pointing,
    it.is_hold,
  ];
  assert.deepEqual(does(read({})), [false, false, false, false]);
  assert.deepEqual(does(read({ 0: 0.51 })), [true, false, false, false]);
  assert.deepEqual(does(read({ 0: 0.49, 1: 0.51 })), [false, true, false, false]);
  assert.deepEqual(does(read({ 4: 1, 5: 1 })), [false, false, true, true]);
  const it = read({});
  assert.deepEqual(it.stick, { right: -0.5, up: -0.25 }); // the thumb-stick, not the touchpad
  assert.deepEqual(read({}, [0.5, -1]).stick, { right: 0.5, up: 1 });
  assert.deepEqual(
    [it.grip!.at.toArray(), it.ray!.at.toArray()],
    [
      [3, 4, 5],
      [0, 1, 2],
    ],
  );
  assert.ok(it.is_tracked && it.kind === 'controller');
});

test('a controller of no known place is not tracked, and what is no hand is none', () => {
  const reader = new HandReader();
  const [lost] = reader.read(frame_of(source({ gripSpace: null })), SPACE);
  assert.equal(lost!.is_tracked, false);
  const others = [{ handedness: 'none' }, { targetRayMode: 'screen' }, { targetRayMode: 'gaze' }];
  assert.deepEqual(reader.read(frame_of(...others.map(source)), SPACE), []);
  assert.equal(reader.read(frame_of(source({}), source({})), SPACE).length, 1, 'one of a side');
});

test('a bare hand is read by its joints, and is not tracked where one of them is not', () => {
  const reader = new HandReader();
  const read = (apart_m: number, unseen = ''): HandReading => {
    const hand = new Map(
      JOINTS.map((joint) => {
        const x_m = joint === 'thumb-tip' ? apart_m : 0;
        return [joint, joint === unseen ? null : [x_m, 1, -0.09]] as const;
      }),
    );
    return reader.read(frame_of(source({ hand })), SPACE)[0]!;
  };
  assert.deepEqual([read(0.05).is_tracked, read(0.05).is_pressed], [true, false]);
  const pinched = read(0.01);
  assert.equal(pinched.is_pressed, true);
  assert.deepEqual(pinched.press_at!.toArray(), [0.005, 1, -0.09]); // between the tips
  assert.equal(read(0.025).is_pressed, true, 'held');
  const lost = read(0.01, 'pinky-finger-tip');
  assert.deepEqual([lost.is_tracked, lost.is_pressed, lost.joints], [false, false, null]);
  assert.equal(read(0.025).is_pressed, false, 'after a loss it is not held on');
});
