import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SessionClock } from 'page/session/clock';

test('EqualWaysThereAndBackGiveTheClockExactly', () => {
  const clock = new SessionClock();
  assert.equal(clock.is_known, false);
  assert.ok(Number.isNaN(clock.at(0)));
  clock.heard(100, 5020, 140); // server's clock is 4900 ahead, 20 ms each way
  assert.equal(clock.at(140), 5040);
  assert.equal(clock.at(1140), 6040);
});

test('TheRoundWithTheLeastRoundTripIsBelieved', () => {
  const clock = new SessionClock();
  const ahead_ms = 4900;
  // 200 ms there and 10 back: half the round trip is wrong by 95 ms. The short round is not.
  for (const [there, back] of [
    [200, 10],
    [3, 3],
    [10, 300],
  ] as const) {
    const asked = 1000;
    clock.heard(asked, asked + there + ahead_ms, asked + there + back);
  }
  assert.equal(clock.at(2000), 2000 + ahead_ms);
  assert.equal(clock.round_trip_ms, 6);
});

test('TheErrorIsNeverMoreThanHalfTheRoundTrip', () => {
  let seed = 20261127;
  const chance = (): number => (seed = (seed * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
  for (let run = 0; run < 500; run += 1) {
    const clock = new SessionClock();
    const ahead_ms = (chance() - 0.5) * 1e6;
    let least_ms = Infinity;
    for (let round = 0; round < 8; round += 1) {
      const [asked, there, back] = [round * 100, chance() * 200, chance() * 200];
      clock.heard(asked, asked + there + ahead_ms, asked + there + back);
      least_ms = Math.min(least_ms, there + back);
    }
    assert.ok(Math.abs(clock.at(5000) - 5000 - ahead_ms) <= least_ms / 2 + 1e-6, `run ${run}`);
  }
});

test('AnOldRoundIsForgottenAndSoIsAnImpossibleOne', () => {
  const clock = new SessionClock();
  clock.heard(0, 1000, 2);
  clock.heard(200_000, 201_500, 200_100); // two minutes on: the clocks have drifted
  assert.equal(clock.at(200_100), 201_550);
  clock.heard(300, 1, 200); // came before it was asked
  assert.equal(clock.at(200_100), 201_550);
});
