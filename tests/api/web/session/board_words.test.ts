// What the board in the headset says and offers, by who one is.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NOTHING_SAID } from 'page/look/said';
import type { WaypointEdit } from 'page/panel/waypoint_edit';
import { empty_session } from 'page/session/state';
import type { Wire } from 'page/session/wire';
import { Station } from 'page/station';
import { board_lines, helm_buttons } from 'page/xr/board_words';
import { own_buttons, type OwnDeeds } from 'page/xr/own_buttons';

const POSE = {
  vehicle: 1,
  east_m: 0,
  north_m: 0,
  up_m: -12,
  east_m_s: 0.3,
  north_m_s: 0.4,
  up_m_s: 0,
};

/** One of three seats, before a vehicle whose helm seat 1 has. */
function station_of(seat: number, role: string): Station {
  const wire = { clock_ms: () => 5000 } as Wire;
  const station = new Station(wire, { speed_unit: 'm/s' } as never);
  const session = { ...empty_session(), seat, role } as Station['session'];
  session.run.state = 'running';
  session.vehicles.set(1, { vehicle: 1, name: 'rov 1', kind: 'rov' } as never);
  session.vehicles.set(2, { vehicle: 2, name: 'rov 2', kind: 'rov' } as never);
  session.poses.set(1, POSE as never);
  session.helms.set(1, { vehicle: 1, state: 'held', holder: 1, asker: null } as never);
  for (const [nth, name] of ['Ann', 'Hal', 'Sue'].entries())
    session.seats.set(nth + 1, { seat: nth + 1, name, is_here: true } as never);
  session.frame = { clock_ms: 4900 } as never;
  station.session = session;
  station.chosen = 1;
  station.frame_came_ms = performance.now();
  return station;
}
const SAID = { stick: NOTHING_SAID, way: NOTHING_SAID, notice: NOTHING_SAID };
const texts = (station: Station): string[] => helm_buttons(station).map((it) => it.text);

test('alarms and an old picture come next after the name, who is here last', () => {
  const station = station_of(1, 'operator');
  const calm = board_lines(station, SAID);
  assert.deepEqual(calm[0], { text: 'rov 1', tone: 'head' });
  assert.equal(calm.at(-1)!.text, 'Here: Hal, Sue');
  assert.ok(calm.some((it) => /12(\.0)? m deep/.test(it.text) && it.text.includes('0.50 m/s')));
  assert.ok(calm.every((it) => it.tone !== 'alarm'));
  station.session.alarms.set('x', {
    with: 'Coaster',
    level: 'danger',
    cpa_s: 90,
    cpa_m: 40,
  } as never);
  station.session.frame!.clock_ms = 3999; // 1001 ms old
  const stick = { text: 'Driving: ahead 0.3 m/s', is_alarm: false };
  const notice = { text: 'Stick: refused.', is_alarm: true };
  const lines = board_lines(station, { ...SAID, stick, notice });
  assert.deepEqual(
    lines.slice(0, 3).map((it) => it.tone),
    ['head', 'alarm', 'alarm'],
  );
  assert.match(lines[1]!.text, /^Picture .* old$/);
  assert.match(lines[2]!.text, /^Coaster: danger, 40 m in 90 s$/);
  assert.deepEqual(lines.at(-2), { text: 'Stick: refused.', tone: 'alarm' });
  assert.equal(lines.at(-1)!.text, 'Here: Hal, Sue');
  const onlooker = board_lines(station_of(2, 'spectator'), { ...SAID, stick });
  assert.ok(!onlooker.some((it) => it.text.startsWith('Driving')));
});

test('HOLD is for who has the helm and for supervisors', () => {
  const may = (seat: number, role: string): boolean => station_of(seat, role).may_hold();
  assert.deepEqual(
    [may(1, 'operator'), may(2, 'operator'), may(3, 'supervisor'), may(3, 'spectator')],
    [true, false, true, false],
  );
  const station = station_of(1, 'operator');
  station.chosen = null;
  assert.equal(station.may_hold(), false);
});

test('the helm is asked for, granted, denied and given back by whom it concerns', () => {
  const mine = station_of(1, 'operator');
  assert.deepEqual(texts(mine), ['Give back', 'Let anyone take it']);
  Object.assign(mine.session.helms.get(1)!, { state: 'requested', asker: 2 });
  assert.deepEqual(texts(mine), ['Give back', 'Grant', 'Deny']);
  const other = station_of(2, 'operator');
  assert.deepEqual(texts(other), ['Ask for the helm']);
  Object.assign(other.session.helms.get(1)!, { state: 'requested', asker: 2 });
  assert.deepEqual(texts(other), [], 'asked already');
  assert.deepEqual(texts(station_of(3, 'spectator')), []);
});

test('a way is sent where it may be, as at the desk', () => {
  const way = (may_send: boolean, is_edited: boolean): WaypointEdit =>
    ({ may_send: () => may_send, draft: () => (is_edited ? {} : null) }) as never;
  const own = { mode: 'vr', is_table: false, rides: false, is_seated: true } as OwnDeeds;
  const offered = (it: WaypointEdit, seat = 1): string[] =>
    own_buttons(station_of(seat, 'operator'), it, own).map((button) => button.text);
  const rest = ['Next vehicle', 'Ride along', 'Table', 'Sitting: yes', 'Leave'];
  assert.deepEqual(offered(way(false, false)), ['Edit the way', ...rest]);
  assert.deepEqual(offered(way(false, false), 2), rest);
  assert.deepEqual(offered(way(false, true)), ['Drop the changes', ...rest]);
  assert.deepEqual(offered(way(true, true)), ['Send the way', 'Drop the changes', ...rest]);
});
