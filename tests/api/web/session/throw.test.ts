// Where a throw comes down.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { arc_of, at_time, landing_of, type Ground } from 'page/xr/teleport';
import { near, near_place } from './xr_for_tests';

const OPEN_SEA: Ground = { structures: [], bed_under: () => -30, is_water_open: false };
const PILE = { name: 'pile', east_m: 0, north_m: 8, radius_m: 3, bottom_m: -30, top_m: 5 };
const ahead_up = (up_rad: number): Vector3 => new Vector3(0, Math.sin(up_rad), -Math.cos(up_rad));

test('a level throw lands as far as a ball thrown from there flies', () => {
  // From a height h a ball that is thrown level at v flies v sqrt(2 h / g).
  for (const h of [0.5, 1.2, 9]) {
    const landing = landing_of(new Vector3(4, h, -7), ahead_up(0), OPEN_SEA);
    assert.equal(landing?.on, 'water');
    near_place(landing!.at, 4, 0, -7 - 10 * Math.sqrt((2 * h) / 9.81));
  }
});

test('thrown upwards it lands on the way down, as far as v v sin(2 a) / g on the level', () => {
  const up_rad = 0.6;
  const landing = landing_of(new Vector3(0, 1e-9, 0), ahead_up(up_rad), OPEN_SEA);
  near(0 - landing!.at.z, (100 * Math.sin(2 * up_rad)) / 9.81, 1e-6);
});

test('who stands on the water throws to the bed, who is under it to the water', () => {
  const down = landing_of(new Vector3(0, 1, 0), ahead_up(-0.5), {
    ...OPEN_SEA,
    is_water_open: true,
  });
  assert.equal(down?.on, 'bed');
  near(down?.at.y, -30, 1e-9);
  const up = landing_of(new Vector3(0, -2, 0), ahead_up(Math.PI / 2), OPEN_SEA);
  assert.equal(up?.on, 'water');
  near(up?.at.y, 0, 1e-9);
  // 10 m/s straight up rises 5.1 m and no more.
  assert.equal(landing_of(new Vector3(0, -5.2, 0), ahead_up(1.57), OPEN_SEA)?.on, 'bed');
});

test('a deck is landed on from above, and a wall is no place', () => {
  const ground = { ...OPEN_SEA, structures: [PILE] };
  const from = new Vector3(0, 6, 0);
  // From 1 m over the deck, so far that it comes down in its middle: 8 m = v cos(a) t.
  let best = 1;
  let up_rad = 0;
  for (let a = -0.5; a < 1.2; a += 0.001) {
    const landing = landing_of(from, ahead_up(a), ground);
    const off = landing?.on === 'deck' ? Math.abs(landing.at.z + 8) : 1;
    if (off < best) [best, up_rad] = [off, a];
  }
  const landing = landing_of(from, ahead_up(up_rad), ground)!;
  assert.equal(landing.on, 'deck');
  near(landing.at.y, 5);
  // A milliradian of the search over 8 m and the 10 m of its fall.
  near(10 * Math.cos(up_rad) * landing.after_s, 8, 0.02);
  // Lower it meets the wall, 5 m away, long before the water behind it.
  assert.equal(landing_of(new Vector3(0, 2, 0), ahead_up(0.2), ground), null);
  // Beside the pile there is the water.
  assert.equal(landing_of(new Vector3(3.1, 2, 0), ahead_up(0.2), ground)?.on, 'water');
});

test('the arc that is shown begins at the hand and ends where one would land', () => {
  const [from, ahead] = [new Vector3(1, 2, 3), ahead_up(0.3)];
  const landing = landing_of(from, ahead, OPEN_SEA)!;
  const arc = arc_of(from, ahead, landing);
  assert.deepEqual(arc[0], from);
  near(arc.at(-1)!.distanceTo(landing.at), 0);
  // Where all stands still, nothing lands.
  near(at_time(from, ahead, 0).distanceTo(from), 0);
  assert.equal(landing_of(from, new Vector3(Number.NaN, 0, 0), OPEN_SEA), null);
});

test('on a slope a throw comes down as high as the bed is there', () => {
  const bed_under = (at: Vector3): number => -30 - 0.2 * at.z; // rises by one in five to the north
  const from = new Vector3(0, -28, 0);
  const landing = landing_of(from, ahead_up(0), { ...OPEN_SEA, bed_under });
  assert.ok(landing !== null && landing.on === 'bed');
  // It falls by one in two there: each look is nearer by two fifths, and 12 leave 0.1 mm or so.
  near(landing.at.y, bed_under(landing.at), 1e-3);
});

test('where the bed is as steep as the throw it is not known where that comes down', () => {
  // A level throw from 2 m over it falls by one in 1.6 there; two looks are to and fro.
  const cliff = (at: Vector3): number => (at.z < -4 ? -31 : -29);
  const steep = (at: Vector3): number => -30 + 3 * (0 - at.z - 6);
  const from = new Vector3(0, -28, 0);
  assert.equal(landing_of(from, ahead_up(0), { ...OPEN_SEA, bed_under: steep }), null);
  const landing = landing_of(from, ahead_up(0), { ...OPEN_SEA, bed_under: cliff });
  assert.ok(landing === null || Math.abs(landing.at.y - cliff(landing.at)) < 0.1);
});
