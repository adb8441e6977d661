// Keys, gamepad, and the number and validity that each command carries.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { beyond_dead_zone, PadReader, pad_lean, type PadLike } from 'page/drive/gamepad';
import { Keys } from 'page/drive/keys';
import { CommandNumbers, STICK_IS_VALID_MS } from 'page/drive/numbers';
import { Stick, type Gate } from 'page/drive/stick';

const OPEN: Gate = {
  is_open: true,
  buffered_bytes: 0,
  is_hidden: false,
  has_focus: true,
  clock_is_known: true,
  frame_age_ms: 0,
  has_helm: true,
};

test('NumbersRiseAlsoWithinAMillisecondAndWhenTheClockGoesBack', () => {
  const numbers = new CommandNumbers();
  const given = [1000.2, 1000.4, 990, 1000.9].map(
    (clock_ms) => numbers.stamp(clock_ms, 400)!.number,
  );
  assert.deepEqual(given, [1000, 1001, 1002, 1003]);
});

test('NumbersOfAReloadedPageAreAboveTheOld', () => {
  const before = new CommandNumbers();
  const last = before.stamp(5000, 400)!.number;
  const after = new CommandNumbers(); // remembers nothing
  assert.ok(after.stamp(5200, 400)!.number > last);
});

test('NumbersAreAboveTheSeatsLastAsTheWelcomeTellsIt', () => {
  const numbers = new CommandNumbers();
  numbers.heard(9000);
  numbers.heard(Number.NaN);
  assert.equal(numbers.stamp(5200, 400)!.number, 9001);
});

test('AStickIsValidFor400MillisecondsOfTheSessionsClock', () => {
  const stamp = new CommandNumbers().stamp(12_345.7, STICK_IS_VALID_MS)!;
  assert.equal(stamp.at, 12_345);
  assert.equal(stamp.until, 12_745);
});

test('WithoutAClockNoCommandIsStamped', () => {
  assert.equal(new CommandNumbers().stamp(Number.NaN, 400), null);
});

test('KeysLeanAsTheyAreNamed', () => {
  const keys = new Keys();
  for (const code of ['KeyW', 'KeyA', 'KeyE', 'KeyR']) assert.equal(keys.press(code, false), true);
  assert.deepEqual(keys.lean(), { surge: 1, yaw: -1, sway: 1, heave: -1 });
  keys.press('KeyS', false);
  assert.equal(keys.lean().surge, 0);
  assert.equal(keys.press('KeyT', false), false);
});

test('ARepeatedKeyAfterALossOfFocusIsNotHeld', () => {
  const keys = new Keys();
  keys.press('Space', false);
  assert.equal(keys.is_held, true);
  keys.release_all();
  keys.press('Space', true); // still down: the system repeats it
  assert.equal(keys.is_held, false);
});

function pad(index: number, shoulder: boolean, axes: number[] = [0, -1, 0, 0]): PadLike {
  return {
    index,
    connected: true,
    axes,
    buttons: Array.from({ length: 16 }, (_, i) => ({ pressed: shoulder && i === 5 })),
  };
}

test('PadAxesLeanAsTheStandardMappingHasThem', () => {
  assert.deepEqual(pad_lean(pad(0, true, [1, -1, -1, 1])), {
    surge: 1,
    yaw: 1,
    sway: -1,
    heave: 1,
  });
  assert.equal(beyond_dead_zone(0.1), 0);
  assert.equal(beyond_dead_zone(-1), -1);
  assert.equal(beyond_dead_zone(Number.NaN), 0);
});

test('AFlappingPadNeverDrivesByItself', () => {
  const stick = new Stick();
  const reader = new PadReader();
  let sent = 0;
  for (let i = 0; i < 100; i += 1) {
    reader.look(i % 2 === 0 ? [pad(0, true)] : [null], stick); // there and gone, its button held
    if (stick.tick(OPEN).lean !== null) sent += 1;
  }
  assert.equal(sent, 0);
});

test('APadDrivesAfterItsButtonWasUp', () => {
  const stick = new Stick();
  const reader = new PadReader();
  reader.look([pad(0, false)], stick);
  stick.tick(OPEN);
  reader.look([pad(0, true)], stick);
  assert.equal(stick.tick(OPEN).lean?.surge, 1);
});

test('AnotherPadInItsPlaceIsNotTheSameHand', () => {
  const stick = new Stick();
  const reader = new PadReader();
  reader.look([pad(0, false)], stick);
  reader.look([pad(0, true)], stick);
  stick.tick(OPEN);
  reader.look([null, pad(1, true)], stick);
  assert.equal(stick.tick(OPEN).lean?.surge, 0); // the end of the first
  reader.look([null, pad(1, true)], stick);
  assert.equal(stick.tick(OPEN).lean, null);
});
