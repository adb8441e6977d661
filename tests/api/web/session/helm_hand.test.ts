// What a hand in a headset asks of a vehicle, and when it must not.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { Stick } from 'page/drive/stick';
import { controllers_lean, HelmHand, moved_lean } from 'page/xr/helm_hand';
import type { HandReading } from 'page/xr/reading';
import { controller, near, OPEN, SQUEEZED, ZERO } from './xr_for_tests';

const always = (): boolean => true;

test('two controllers lean as the two sticks of a gamepad do, one alone ahead and turn', () => {
  const left = controller('left', { stick: { right: -1, up: 0.5 } });
  const right = controller('right', { stick: { right: 1, up: -1 } });
  const lean = controllers_lean([right, left]);
  assert.deepEqual({ ...lean, surge: 0 }, { surge: 0, yaw: -1, sway: 1, heave: 1 });
  near(lean.surge, (0.5 - 0.12) / (1 - 0.12)); // beyond the gamepad's dead zone
  assert.deepEqual(controllers_lean([right]), { surge: -1, yaw: 1, sway: 0, heave: 0 });
  assert.deepEqual(controllers_lean([{ ...left, is_tracked: false }]), ZERO);
});

test('a pinched hand leans by how far it was moved, seen from who moves it', () => {
  const at = new Vector3(0.2, 1.2, -0.4);
  const flat = new Quaternion();
  for (const ahead_rad of [0, 1, -2.5]) {
    const from = { at, turned: flat, ahead_rad };
    const up = new Vector3(0, 1, 0);
    const to = (right: number, up_m: number, ahead: number): Vector3 =>
      new Vector3(right, up_m, -ahead).applyAxisAngle(up, ahead_rad).add(at);
    assert.deepEqual(moved_lean(from, to(0.013, -0.013, 0.013), flat), ZERO); // a hand trembles
    const half = moved_lean(from, to(0, 0, 0.07), flat);
    near(half.surge, 0.5, 1e-6);
    near(half.sway, 0, 1e-6);
    near(moved_lean(from, to(-0.3, 0, 0), flat).sway, -1);
    near(moved_lean(from, to(0, 0.12, 0), flat).heave, -1, 1e-6); // a hand up is a vehicle up
    // The wrist to the right is to starboard.
    const right = new Quaternion().setFromAxisAngle(up, -0.42);
    near(moved_lean(from, at, right).yaw, 0.5, 1e-6);
    near(moved_lean(from, at, right.clone().invert()).yaw, -0.5, 1e-6);
  }
});

/** A stick that is driven by a squeeze, and the hand that does it. */
function driven(...others: HandReading[]): {
  stick: Stick;
  helm: HelmHand;
  frame: (...it: HandReading[]) => void;
} {
  const [stick, helm] = [new Stick(), new HelmHand()];
  let now_ms = 0;
  const frame = (...hands: HandReading[]): void => {
    now_ms += 20;
    helm.take(hands, 0, always, now_ms);
    helm.look(stick, now_ms);
  };
  for (let i = 0; i < 2; i += 1) frame(controller('left'), ...others); // new hands, then open
  stick.tick(OPEN);
  frame(SQUEEZED, ...others);
  assert.deepEqual(stick.tick(OPEN).lean, { ...ZERO, surge: 1 });
  return { stick, helm, frame };
}

test('released is zero, once, though the thumb stays on the stick', () => {
  const { stick, frame } = driven();
  frame({ ...SQUEEZED, is_squeezed: false });
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
  frame({ ...SQUEEZED, is_squeezed: false });
  assert.equal(stick.tick(OPEN).lean, null);
  frame(SQUEEZED);
  assert.equal(stick.tick(OPEN).lean?.surge, 1);
});

const LOSSES: [string, (it: ReturnType<typeof driven>) => void][] = [
  ['a controller that is gone', ({ frame }) => frame()],
  ['a hand that is not tracked', ({ frame }) => frame({ ...SQUEEZED, is_tracked: false })],
  ['a headset that is taken off', ({ helm, stick }) => (helm.lose(), helm.look(stick, 60))],
  ['frames that no longer come', ({ helm, stick }) => helm.look(stick, 60 + 501)],
];
for (const [what, lose] of LOSSES)
  test(`${what} is zero, and must be seen open before it drives again`, () => {
    const it = driven();
    lose(it);
    assert.deepEqual(it.stick.tick(OPEN).lean, ZERO);
    for (let i = 0; i < 5; i += 1) {
      it.frame(SQUEEZED); // back, and squeezed all the while
      assert.equal(it.stick.tick(OPEN).lean, null);
    }
    it.frame({ ...SQUEEZED, is_squeezed: false });
    assert.equal(it.stick.tick(OPEN).lean, null);
    it.frame(SQUEEZED);
    assert.equal(it.stick.tick(OPEN).lean?.surge, 1);
  });

test('a loss between two looks is not missed', () => {
  const { stick, helm } = driven();
  helm.take([], 0, always, 50);
  helm.take([SQUEEZED], 0, always, 60);
  helm.look(stick, 60);
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
});

test('another hand that is squeezed does not go on where one was lost', () => {
  const { stick, frame } = driven(controller('right'));
  const other = controller('right', { is_squeezed: true, stick: { right: 0, up: 1 } });
  frame(SQUEEZED, other);
  assert.deepEqual(stick.tick(OPEN).lean, { ...ZERO, surge: 1, heave: -1 });
  frame(other);
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
  frame(other);
  assert.equal(stick.tick(OPEN).lean, null);
});

test('a second controller that comes or goes in the middle of a squeeze changes no axis', () => {
  // Leaned up, the right one is ahead where it is alone, and up beside a left one.
  const leaned = controller('right', { is_squeezed: true, stick: { right: 0.8, up: 1 } });
  const beside = controller('left');
  for (const [before, after] of [
    [[], [beside]],
    [[beside], []],
    [[beside], [{ ...beside, is_tracked: false }]],
  ]) {
    const [stick, helm] = [new Stick(), new HelmHand()];
    let now_ms = 0;
    const frame = (...hands: HandReading[]): void => {
      now_ms += 20;
      helm.take(hands, 0, always, now_ms);
      helm.look(stick, now_ms);
    };
    for (let i = 0; i < 2; i += 1) frame(controller('right'), ...before!);
    frame(leaned, ...before!);
    const { surge, heave } = stick.tick(OPEN).lean!;
    assert.deepEqual([surge, heave], before!.length === 0 ? [1, 0] : [0, -1]);
    frame(leaned, ...after!);
    assert.deepEqual(stick.tick(OPEN).lean, ZERO);
    for (let i = 0; i < 5; i += 1) {
      frame(leaned, ...after!);
      assert.equal(stick.tick(OPEN).lean, null);
    }
    frame({ ...leaned, is_squeezed: false }, ...after!);
    frame(leaned, ...after!);
    assert.ok(stick.tick(OPEN).lean !== null, 'squeezed anew');
  }
});

test('a hand that comes back squeezed drives nothing, though another was on the stick', () => {
  const { stick, frame } = driven(controller('right'));
  frame({ ...SQUEEZED, is_squeezed: false }, controller('right'));
  stick.tick(OPEN);
  frame(controller('right')); // the left one is gone
  for (let i = 0; i < 3; i += 1) {
    frame(SQUEEZED, controller('right'));
    assert.equal(stick.tick(OPEN).lean, null);
  }
});

test('a hand that held before it might, as one that comes from the table, drives nothing', () => {
  const [stick, helm] = [new Stick(), new HelmHand()];
  helm.take([controller('left')], 0, always, 0);
  helm.take([SQUEEZED], 0, () => false, 20);
  helm.take([SQUEEZED], 0, always, 40);
  assert.equal(helm.held_by, null);
  helm.look(stick, 40);
  assert.equal(stick.tick(OPEN).lean, null);
});

test('what is not open for keys is not open for a headset', () => {
  for (const shut of [
    { is_open: false },
    { is_hidden: true },
    { has_helm: false },
    { frame_age_ms: 1001 },
    { clock_is_known: false },
  ]) {
    const { stick, frame } = driven();
    assert.equal(stick.tick({ ...OPEN, ...shut }).lean, null);
    frame(SQUEEZED);
    assert.equal(stick.tick(OPEN).lean, null);
    assert.equal(stick.tick(OPEN).must_release, true);
  }
});
