// What somebody looks at, for those who want it kept: fixations count, glances do not.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Attention, GLANCE_MS, type Gaze } from 'page/session/attention';
import { empty_session } from 'page/session/state';
import { read_structures, read_vehicle } from 'page/session/message';
import { named_on_plan } from 'page/view/gazed';
import { pose_with } from './pose_for_tests';

const at = (on: string): Gaze => ({ on, by: 'pointer' });

test('a thing is told once it has held the gaze, and once', () => {
  const attention = new Attention();
  const told: [number, string][] = [];
  // From 0 on the rov, a glance of 200 ms at the pile, back, and from 1500 ms on nothing.
  for (let ms = 0; ms <= 2500; ms += 50) {
    const on = ms >= 1500 ? '' : ms >= 800 && ms < 1000 ? 'pile' : 'rov';
    const news = attention.take(at(on), ms);
    if (news !== null) told.push([ms, news.on]);
  }
  assert.deepEqual(told, [
    [350, 'rov'],
    [1850, ''], // in steps of 50 ms
  ]);
});

test('its end is told where there was a beginning', () => {
  const attention = new Attention();
  assert.equal(attention.ends(), false);
  attention.take(at('rov'), 0);
  assert.equal(attention.ends(), false, 'a glance was not told');
  attention.take(at('rov'), 0);
  attention.take(at('rov'), GLANCE_MS);
  assert.equal(attention.ends(), true);
  assert.equal(attention.ends(), false);
  attention.take(at('rov'), 2 * GLANCE_MS);
  assert.notEqual(attention.take(at('rov'), 3 * GLANCE_MS), null, 'it begins anew');
});

test('the same seen by something else is told, too', () => {
  const attention = new Attention();
  const told: Gaze[] = [];
  for (let ms = 0; ms <= 2000; ms += 50) {
    const news = attention.take({ on: 'rov', by: ms < 1000 ? 'pointer' : 'head' }, ms);
    if (news !== null) told.push(news);
  }
  assert.deepEqual(told, [
    { on: 'rov', by: 'pointer' },
    { on: 'rov', by: 'head' },
  ]);
});

test('what could not be sent is told later, and over a new link all is told again', () => {
  const attention = new Attention();
  const told: [number, string][] = [];
  // One looks at the rov all the time. No link from 1 s to 3 s; then another one.
  for (let ms = 0; ms <= 6000; ms += 50) {
    const is_cut = ms >= 1000 && ms < 3000;
    const link = is_cut ? 2 : ms < 1000 ? 1 : 3;
    attention.tell(at('rov'), ms, link, ({ on }) => {
      if (!is_cut) told.push([ms, on]);
      return !is_cut;
    });
  }
  // Looked at in steps of 50 ms, from the beginning, and from the moment of the new link.
  assert.deepEqual(told, [
    [350, 'rov'],
    [3350, 'rov'],
  ]);
});

test('what a link did not take is told again over the same link', () => {
  const attention = new Attention();
  const told: number[] = [];
  for (let ms = 0; ms <= 3000; ms += 50)
    attention.tell(at('rov'), ms, 1, () => {
      if (ms >= 500) told.push(ms);
      return ms >= 500;
    });
  assert.deepEqual(told, [750]); // refused at 350, when the gaze begins anew
});

test('on the plan the nearest thing within reach has the gaze', () => {
  const session = empty_session();
  const vehicle = read_vehicle({ vehicle: 0, name: 'rov', kind: 'rov', length_m: 1, width_m: 1 });
  assert.ok(vehicle !== null);
  session.vehicles.set(0, vehicle);
  session.poses.set(0, pose_with({ vehicle: 0, east_m: 10, north_m: 0 }));
  const pile = { name: 'pile', east_m: 30, north_m: 0, radius_m: 3, bottom_m: -30, top_m: 10 };
  session.structures = read_structures([pile]);
  const to_pixel = (it: { east_m: number; north_m: number }): { x: number; y: number } => ({
    x: it.east_m,
    y: -it.north_m,
  });
  assert.equal(named_on_plan(session, { x: 12, y: 3 }, to_pixel), 'rov');
  assert.equal(named_on_plan(session, { x: 21, y: 0 }, to_pixel), 'pile');
  assert.equal(named_on_plan(session, { x: 30, y: 40 }, to_pixel), '');
});
