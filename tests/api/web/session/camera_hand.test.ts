// What the page of a session makes of a hand's wishes: few orders, and none when it may not.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MOST, NO_TURN, type Turn } from 'page/../look/camera_wish';
import { CameraHand, ORDER_EVERY_MS } from 'page/drive/camera_hand';
import type { CameraPointing } from 'page/session/message';

const TICK_MS = 50;
const AHEAD: CameraPointing = { pan_deg: 0, tilt_deg: 0, zoom: 1 };
const PAN: Turn = { ...NO_TURN, pan_deg_s: 12 };
const AGE_MS = 50; // of a picture, when the page hears of it

/** A station whose server takes every order at once. */
class Station {
  readonly hand = new CameraHand();
  now_ms = 5000;
  may = true;
  camera: CameraPointing | null = AHEAD;
  orders: (CameraPointing & { at_ms: number })[] = [];
  run(for_ms: number, turn: Turn | null, age_ms = AGE_MS): void {
    for (let t = 0; t < for_ms; t += TICK_MS) {
      this.now_ms += TICK_MS;
      const picture_ms = this.now_ms - age_ms;
      if (turn !== null && t % 100 === 0) this.hand.take({ ...turn, picture_ms }, this.now_ms);
      const order = this.hand.tick(this.now_ms, this.may, this.camera);
      if (order === null) continue;
      this.orders.push({ ...order, at_ms: this.now_ms });
      this.camera = { ...order };
    }
  }
}

test('TheCameraTurnsAsFastAsIsWishedFromWhereItLooked', () => {
  const station = new Station();
  station.camera = { pan_deg: 30, tilt_deg: -10, zoom: 2 };
  station.run(5000, { pan_deg_s: 12, tilt_deg_s: -4, zoom_per_s: Math.log(2) / 4 });
  const last = station.orders[station.orders.length - 1]!;
  const since_s = (last.at_ms - 5000) / 1000;
  // The first tick has none before it to count from: 0.05 s are missing, which is 0.6 and 0.2
  // degrees, and 0.04 of a zoom of 4.7.
  assert.ok(Math.abs(last.pan_deg - (30 + 12 * since_s)) < 0.61, `${last.pan_deg}`);
  assert.ok(Math.abs(last.tilt_deg - (-10 - 4 * since_s)) < 0.21, `${last.tilt_deg}`);
  assert.ok(Math.abs(last.zoom - 2 * 2 ** (since_s / 4)) < 0.05, `${last.zoom}`);
});

test('OrdersAreFew', () => {
  const station = new Station();
  station.run(10_000, PAN);
  const apart = station.orders.slice(1).map((it, i) => it.at_ms - station.orders[i]!.at_ms);
  assert.ok(Math.min(...apart) >= ORDER_EVERY_MS);
  // 40 times 250 ms; the first may be late by one, and ticks come each 50 ms.
  assert.ok(station.orders.length <= 40 && station.orders.length >= 39);
});

test('AWishThatIsOldTurnsNothing', () => {
  const station = new Station();
  station.run(2000, PAN);
  const last_wish_ms = station.now_ms - TICK_MS;
  const count = station.orders.length;
  station.run(5000, null); // its window was closed, or is slow
  for (const order of station.orders.slice(count))
    assert.ok(order.at_ms - (last_wish_ms - AGE_MS) <= 300, `${order.at_ms}`);
  const late = new Station();
  late.run(5000, PAN, 400); // held up on their way, as where this page slept
  assert.deepEqual(late.orders, []);
  const early = new Station();
  early.run(100, PAN, -60_000); // by a clock that is ahead: it counts no longer than another
  early.orders = [];
  early.now_ms += 300;
  early.run(2000, null);
  assert.deepEqual(early.orders, []);
});

test('AHandAtRestStopsItAtOnce', () => {
  const station = new Station();
  station.run(2000, PAN);
  const count = station.orders.length;
  station.run(3000, NO_TURN);
  assert.equal(station.orders.length, count);
});

test('WhereNothingMayBeSentNothingIsKeptAndTheHandHasToRestOnce', () => {
  const station = new Station();
  station.may = false; // no helm, hidden, cut off, an old picture
  station.run(2000, PAN);
  station.may = true;
  station.run(2000, PAN);
  assert.deepEqual(station.orders, []);
  assert.ok(station.hand.has_to_rest());
  station.run(200, NO_TURN);
  station.run(1000, PAN);
  // 12 degrees a second for 250 ms at most, and none of what was refused.
  assert.ok(station.orders[0]!.pan_deg <= 3, `${station.orders[0]!.pan_deg}`);
});

test('AfterARefusalOrAnotherVehicleTheHandHasToRestOnce', () => {
  const station = new Station();
  station.run(1000, PAN);
  station.hand.drop();
  station.orders = [];
  station.camera = { ...AHEAD, pan_deg: -90 }; // of the other
  station.run(2000, PAN);
  assert.deepEqual(station.orders, []);
  station.run(200, NO_TURN);
  station.run(1000, PAN);
  assert.ok(Math.abs(station.orders[0]!.pan_deg + 90) <= 3, `${station.orders[0]!.pan_deg}`);
});

test('ASecondMoveBeginsWhereTheFirstEndedEvenIfTheServerHasNotToldYet', () => {
  const station = new Station();
  station.run(1000, PAN);
  const ended = station.orders[station.orders.length - 1]!.pan_deg;
  station.run(200, NO_TURN);
  station.camera = AHEAD; // the last status, from before
  station.orders = [];
  station.run(500, PAN);
  assert.ok(station.orders[0]!.pan_deg >= ended, `${station.orders[0]!.pan_deg} after ${ended}`);
});

test('WhatWasSetAtTheControlsMeanwhileIsNotTurnedBack', () => {
  const station = new Station();
  station.run(2000, PAN);
  const told = { ...station.camera! }; // 20 degrees or so
  assert.ok(told.pan_deg > 15);
  station.orders = [];
  station.hand.overrule(AHEAD, station.now_ms); // Straight ahead, in the middle of the turn
  station.camera = told; // the server has not told yet
  station.run(1000, PAN);
  assert.deepEqual(station.orders, [], 'the hand rests first');
  station.run(100, NO_TURN);
  station.run(300, PAN);
  const first = station.orders[0]!;
  assert.ok(first.pan_deg > 0 && first.pan_deg <= 3, `${first.pan_deg}, from straight ahead on`);
});

test('ItStaysWithinWhatACameraTurns', () => {
  const station = new Station();
  station.run(40_000, MOST);
  const last = station.orders[station.orders.length - 1]!;
  assert.deepEqual({ ...last, at_ms: 0 }, { pan_deg: 180, tilt_deg: 90, zoom: 10, at_ms: 0 });
  const count = station.orders.length;
  station.run(5000, MOST);
  assert.equal(station.orders.length, count); // nothing changes: no rows
});

test('APageThatSleptDidNotTurnMeanwhile', () => {
  const station = new Station();
  station.run(500, PAN);
  const before = station.orders[station.orders.length - 1]!.pan_deg;
  station.now_ms += 60_000;
  station.run(100, PAN);
  const after = station.orders[station.orders.length - 1]!.pan_deg;
  // Not sent yet, 250 ms at most; the step over the sleep, 100 ms; and one tick more.
  assert.ok(after - before <= 12 * (0.25 + 0.1 + 0.05), `${before} to ${after}`);
});

test('WithoutACameraNothingIsSent', () => {
  const station = new Station();
  station.camera = null;
  station.run(2000, PAN);
  assert.deepEqual(station.orders, []);
});
