// Turns by steps, flight, and a view that narrows.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { Flight, narrowed, out_of_bed_m, SnapTurn } from 'page/xr/comfort';
import { near } from './xr_for_tests';

test('a push turns by 30 degrees once, whatever it does before it is back', () => {
  const snap = new SnapTurn();
  const pushes = [0.2, 0.9, 1, 0.5, 0.9, 0.1, -0.8, -0.8, 0];
  const turned = pushes.map((it) => Math.round((snap.step(it) * 180) / Math.PI));
  assert.deepEqual(turned, [0, 30, 0, 0, 0, 0, -30, 0, 0]);
});

test('flight goes where one looks, begins at 3 m/s, and stops at once', () => {
  const flight = new Flight();
  const look = new Vector3(0, -1, 0);
  const first = flight.step(look, { right: 0, up: 1 }, 0, 0.01);
  near(first.x, 0);
  near(first.y, -0.03 * Math.exp(0.01 / 1.5), 1e-6);
  for (let i = 0; i < 1000; i += 1) flight.step(look, { right: 0, up: 1 }, 0, 0.02);
  near(flight.step(look, { right: 0, up: 1 }, 0, 0.02).length(), 0.6); // 30 m/s
  assert.equal(flight.step(look, { right: 0, up: 0 }, 0, 0.02).length(), 0);
  // A frame that was a second late.
  // Counts as 0.1 s, in which the speed grows from 3 m/s by a fifteenth.
  near(flight.step(look, { right: 0, up: 1 }, 0, 1).length(), 0.3 * Math.exp(0.1 / 1.5), 1e-9);
});

test('nobody flies into the bed', () => {
  near(out_of_bed_m(-31, -30), 1.3);
  assert.deepEqual([out_of_bed_m(-29.5, -30), out_of_bed_m(-31, null)], [0, 0]);
});

test('the view narrows while one moves, and opens again', () => {
  let narrow = 0;
  for (let i = 0; i < 10; i += 1) narrow = narrowed(narrow, true, 0.02);
  assert.equal(narrow, 1);
  narrow = narrowed(narrow, false, 0.075);
  near(narrow, 0.5);
  assert.equal(narrowed(narrow, false, 1), 0);
});
