import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as units from 'page/look/units';
import { Camera, round_below } from 'page/view/camera';

test('AKnotIs1852MetresAnHour', () => {
  assert.equal(units.speed_text(1852 / 3600, 'knots'), '1.0 kn');
  assert.equal(units.speed_text(0.55, 'm/s', 2), '0.55 m/s');
  assert.equal(units.speed_text(Number.NaN, 'm/s'), '–');
  assert.equal(units.speed_text(null, 'knots'), '–');
});

test('HeadingsHaveThreeDigitsAndNever360', () => {
  assert.equal(units.heading_text((7 * Math.PI) / 180), '007°');
  assert.equal(units.heading_text(2 * Math.PI - 0.001), '000°');
  assert.equal(units.heading_text(-Math.PI / 2), '270°');
});

test('WhatIsDoneIsRoundedDown', () => {
  assert.equal(units.done_text(0.8999), '89 %');
  assert.equal(units.done_text(0.9999), '99 %');
  for (let parts = 0; parts <= 100; parts += 1)
    assert.equal(units.done_text(parts / 100), `${parts} %`);
  assert.equal(units.done_text(null), '–');
});

test('BelowTheSeaIsADepthAboveItAHeight', () => {
  assert.equal(units.level_text(-12), '12.0 m deep');
  assert.equal(units.level_text(25), '25.0 m up');
  assert.equal(units.level_text(0.2), '0.0 m deep'); // afloat on a wave
});

test('SiteTimeIsUtcAndItsOffset', () => {
  const at = Date.UTC(2026, 10, 27, 23, 48, 5);
  assert.equal(units.time_text(at, { kind: 'utc' }, true), '23:48:05 UTC');
  assert.equal(units.time_text(at, { kind: 'site', offset_hours: 1 }), '00:48 site');
  assert.equal(units.time_text(at, { kind: 'site', offset_hours: -3.5 }), '20:18 site');
  assert.equal(units.time_text(Number.NaN, { kind: 'utc' }), '–');
});

test('ThePictureIsAmberFrom200MillisecondsAndRedFrom500', () => {
  assert.deepEqual([0, 199, 200, 499, 500, Number.NaN].map(units.age_grade), [
    'fresh',
    'fresh',
    'amber',
    'amber',
    'red',
    'red',
  ]);
});

test('SecondsLeftAreNeverBelowNone', () => {
  assert.deepEqual(
    [
      units.seconds_left(10_000, 1),
      units.seconds_left(10_000, 9_999),
      units.seconds_left(10_000, 12_000),
    ],
    [10, 1, 0],
  );
});

test('ZoomKeepsThePlaceUnderTheFinger', () => {
  const camera = new Camera();
  Object.assign(camera, { width: 640, height: 480, east_m: 12, north_m: -7, pixels_per_metre: 3 });
  const pixel = { x: 111, y: 400 };
  const before = camera.to_plane(pixel);
  camera.zoom(2.5, pixel);
  const after = camera.to_plane(pixel);
  assert.ok(Math.hypot(after.east_m - before.east_m, after.north_m - before.north_m) < 1e-9);
  const there = camera.to_pixel(after);
  assert.ok(Math.hypot(there.x - pixel.x, there.y - pixel.y) < 1e-9);
});

test('NorthIsUpAndEastIsRight', () => {
  const camera = new Camera();
  Object.assign(camera, { width: 100, height: 100, pixels_per_metre: 1 });
  assert.deepEqual(camera.to_pixel({ east_m: 10, north_m: 20 }), { x: 60, y: 30 });
});

test('ScalesAreOneTwoOrFive', () => {
  assert.deepEqual([1, 1.9, 2, 7, 49, 0.3].map(round_below), [1, 1, 2, 5, 20, 0.2]);
});
