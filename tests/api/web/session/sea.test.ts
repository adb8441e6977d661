// The surface of the sea by closed forms; that the server's is the same: tests/api/door/people.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { elevation_m, phase_of, read_sea } from 'page/session/sea';

const told = { depth_m: 40, waves: [[1.5, 0.02, -0.01, 0.6, 0.25]] };

test('one wave is its cosine', () => {
  const sea = read_sea(told);
  const expected = 1.5 * Math.cos(0.02 * 100 - 0.01 * -50 - 0.6 * 7 + 0.25);
  assert.ok(Math.abs(elevation_m(sea, 1, 100, -50, 7) - expected) < 1e-12);
  assert.ok(Math.abs(elevation_m(sea, 0.5, 100, -50, 7) - expected / 2) < 1e-12);
});

test('it travels along its wavenumber at omega over k', () => {
  const sea = read_sea(told);
  const k = Math.hypot(0.02, 0.01);
  const far = ((0.6 / k) * 11) / k;
  const before = elevation_m(sea, 1, 3, 4, 20);
  const after = elevation_m(sea, 1, 3 + 0.02 * far, 4 - 0.01 * far, 31);
  assert.ok(Math.abs(before - after) < 1e-9);
});

test('waves add up, and the variance is half the sum of their squares', () => {
  const sea = read_sea({ depth_m: 40, waves: [[1, 0.02, 0, 0.44, 0], [0.5, 0, 0.03, 0.54, 1]] });
  let squares = 0;
  const many = 20_000;
  for (let i = 0; i < many; i += 1) squares += elevation_m(sea, 1, 0, 0, 7.3 * i) ** 2 / many;
  assert.ok(Math.abs(squares - (1 + 0.25) / 2) < 0.01, String(squares));
});

test('a phase is within one turn, days after the start too', () => {
  const wave = read_sea(told)?.waves[0];
  assert.ok(wave !== undefined);
  const late = phase_of(wave, -5000, 3000, 3e5);
  assert.ok(late >= 0 && late < 2 * Math.PI);
});

test('what is no sea is none', () => {
  for (const value of [null, 7, {}, { depth_m: 40, waves: [] }, { depth_m: 40, waves: [[1, 2]] }])
    assert.equal(read_sea(value), null);
  assert.equal(elevation_m(null, 1, 3, 4, 5), 0);
});
