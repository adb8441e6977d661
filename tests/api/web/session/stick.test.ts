// The dead-man: what goes out, and above all what does not.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block_of, Stick, velocity_of, type Gate, type Lean } from 'page/drive/stick';

const OPEN: Gate = {
  is_open: true,
  buffered_bytes: 0,
  is_hidden: false,
  has_focus: true,
  clock_is_known: true,
  frame_age_ms: 50,
  has_helm: true,
};
const AHEAD: Lean = { surge: 1, sway: 0, heave: 0, yaw: 0 };
const ZERO: Lean = { surge: 0, sway: 0, heave: 0, yaw: 0 };

function driving(): Stick {
  const stick = new Stick();
  stick.set('keys', true, AHEAD);
  assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
  return stick;
}

test('NothingIsSentWithoutTheDeadMan', () => {
  const stick = new Stick();
  stick.set('keys', false, AHEAD);
  for (let i = 0; i < 5; i += 1) assert.equal(stick.tick(OPEN).lean, null);
});

test('LettingGoSendsZeroOnceAndNeverTheLast', () => {
  const stick = driving();
  stick.set('keys', false, AHEAD); // W is still down, Space is not
  const end = stick.tick(OPEN);
  assert.deepEqual(end.lean, ZERO);
  assert.equal(end.is_end, true);
  assert.equal(stick.tick(OPEN).lean, null);
});

const BLOCKS: [string, Partial<Gate>][] = [
  ['NoLink', { is_open: false }],
  ['FullBuffer', { buffered_bytes: 8 * 1024 + 1 }],
  ['HiddenPage', { is_hidden: true }],
  ['LostFocus', { has_focus: false }],
  ['OldPicture', { frame_age_ms: 1001 }],
  ['NoPicture', { frame_age_ms: Number.NaN }],
  ['NoClock', { clock_is_known: false }],
  ['NoHelm', { has_helm: false }],
];
for (const [name, change] of BLOCKS) {
  test(`${name}SendsNothingAndAsksForANewPress`, () => {
    const stick = driving();
    const shut = { ...OPEN, ...change };
    assert.notEqual(block_of(shut), null);
    for (let i = 0; i < 40; i += 1) assert.equal(stick.tick(shut).lean, null);
    // All is well again, Space was never let go: still nothing, not even an old zero.
    const after = stick.tick(OPEN);
    assert.equal(after.lean, null);
    assert.equal(after.must_release, true);
    stick.set('keys', false, ZERO);
    assert.equal(stick.tick(OPEN).lean, null);
    stick.set('keys', true, AHEAD);
    assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
  });
}

test('AHelmThatIsGrantedWhileSpaceIsHeldDrivesNothing', () => {
  const stick = new Stick();
  stick.set('keys', true, AHEAD);
  stick.tick({ ...OPEN, has_helm: false });
  assert.equal(stick.tick(OPEN).lean, null);
});

test('APadThatComesWithItsButtonHeldDrivesNothing', () => {
  const stick = new Stick();
  stick.set('pad', true, AHEAD);
  assert.equal(stick.tick(OPEN).lean, null);
  stick.set('pad', false, ZERO);
  stick.set('pad', true, AHEAD);
  assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
});

test('APadThatFlapsWhileDrivingSendsZeroAndThenNothing', () => {
  const stick = new Stick();
  stick.set('pad', false, ZERO);
  stick.set('pad', true, AHEAD);
  assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
  stick.lose('pad');
  assert.deepEqual(stick.tick(OPEN).lean, ZERO);
  stick.set('pad', true, AHEAD); // back, its button still held
  for (let i = 0; i < 5; i += 1) assert.equal(stick.tick(OPEN).lean, null);
});

test('OneHandAtATime', () => {
  const stick = driving();
  stick.set('touch', true, { ...ZERO, surge: -1 });
  assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
  stick.set('keys', false, ZERO);
  assert.deepEqual(stick.tick(OPEN).lean, ZERO); // the driver's end
  assert.equal(stick.tick(OPEN).lean, null); // the other was pressed out of turn
});

test('KeptAxesStayAtZero', () => {
  const stick = new Stick();
  stick.keep_depth = true;
  stick.keep_heading = true;
  stick.set('keys', true, { surge: 0.5, sway: 0, heave: 1, yaw: 1 });
  assert.deepEqual(stick.tick(OPEN).lean, { surge: 0.5, sway: 0, heave: 0, yaw: 0 });
});

test('NoLeanIsBeyondOneAndNoneIsNoNumber', () => {
  const stick = new Stick();
  stick.set('keys', true, { surge: 7, sway: Number.NaN, heave: -3, yaw: 0 });
  assert.deepEqual(stick.tick(OPEN).lean, { surge: 1, sway: 0, heave: -1, yaw: 0 });
});

test('VelocityIsMetresPerSecondDownAndStarboard', () => {
  const velocity = velocity_of({ surge: 1, sway: -1, heave: 1, yaw: 1 }, 1.5, 0.5);
  assert.deepEqual(velocity, [0.75, -0.75, 0.75, 0.25]);
  assert.ok(velocity_of(ZERO, 1.5, 0.5).every((it) => Object.is(it, 0)));
});

test('AnOrderTakesTheVehicleFromTheStickAndNoZeroFollowsIt', () => {
  for (const source of ['keys', 'pad', 'touch', 'headset'] as const) {
    const stick = new Stick();
    stick.set(source, false, ZERO);
    stick.set(source, true, AHEAD);
    assert.deepEqual(stick.tick(OPEN).lean, AHEAD);
    stick.drop(); // HOLD goes out
    for (let i = 0; i < 5; i += 1) {
      const held = stick.tick(OPEN);
      assert.equal(held.lean, null, source);
      assert.equal(held.must_release, true);
    }
    stick.set(source, false, ZERO);
    assert.equal(stick.tick(OPEN).lean, null, `${source}: the zero of a release`);
    stick.set(source, true, AHEAD);
    assert.deepEqual(stick.tick(OPEN).lean, AHEAD); // pressed anew
  }
});

test('AReleaseThatWaitsForItsTickDoesNotFollowAnOrder', () => {
  const stick = driving();
  stick.set('keys', false, ZERO);
  stick.drop();
  assert.equal(stick.tick(OPEN).lean, null);
});
