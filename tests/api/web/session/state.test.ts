// What the server says becomes the state, and nothing else does.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shaped_text, stick_speed_m_s } from 'page/drive/shaped';
import { read_answer, type Json } from 'page/session/message';
import { empty_session, has_helm, show_frame, tell, type Session } from 'page/session/state';
import { camera_text } from 'page/panel/camera_panel';
import { picture_text } from 'page/panel/picture_panel';
import { helm_words } from 'page/panel/helm_panel';
import { farm_text, led_text } from 'page/panel/weather_panel';
import type { Frame, Pose } from 'page/session/frame';
import { pose_with } from './pose_for_tests';

const WELCOME: Json = {
  is: 'welcome',
  session: 'live',
  seat: 3,
  name: 'Ann',
  role: 'operator',
  resume: 'r1',
  clock: 1000,
  step_s: 0.01,
  start: '2026-11-27T05:00:00Z',
  vehicles: [
    {
      vehicle: 0,
      name: 'rov',
      kind: 'ROV',
      home: { east_m: 1, north_m: 2, up_m: -3 },
      tether: null,
      colour: 'yellow',
    },
    'nonsense',
    { name: 'without a number' },
  ],
  structures: [{ name: 'A1', east_m: 0, north_m: 0, radius_m: 4, bottom_m: -30, top_m: 20 }],
  seats: [
    { seat: 3, name: 'Ann', role: 'operator', is_here: true },
    { seat: 4, name: 'Bob', role: 'operator', is_here: true, shoes: 43 },
  ],
  run: { state: 'running', by: null, time_s: 12 },
  helms: [{ vehicle: 0, state: 'free', holder: null, asker: null }],
  actions: [],
  of_a_later_version: { deep: [1, 2, 3] },
};
function seated(): Session {
  const session = empty_session();
  tell(session, WELCOME);
  return session;
}

test('AWelcomeIsTakenAndWhatIsNotKnownInItIsLeftOut', () => {
  const session = seated();
  assert.equal(session.seat, 3);
  assert.equal(session.role, 'operator');
  assert.equal(session.start_utc_ms, Date.UTC(2026, 10, 27, 5));
  assert.deepEqual([...session.vehicles.keys()], [0]);
  assert.equal(session.vehicles.get(0)?.kind, 'rov');
  assert.equal('colour' in session.vehicles.get(0)!, false);
  assert.equal(session.seats.size, 2);
});

test('AMessageOfAnUnknownKindChangesNothing', () => {
  const session = seated();
  const before = structuredClone(session);
  assert.equal(tell(session, { is: 'horoscope', mood: 12 }), false);
  assert.deepEqual(session, before);
});

test('AnUnknownRoleIsOneThatOnlyLooks', () => {
  const session = empty_session();
  tell(session, { ...WELCOME, role: 'emperor' });
  assert.equal(session.role, 'spectator');
});

test('OnlyTheServersWordIsAHelm', () => {
  const session = seated();
  assert.equal(has_helm(session, 0), false);
  tell(session, { is: 'helm', vehicle: 0, state: 'held', holder: 3, until: null });
  assert.equal(has_helm(session, 0), true);
  tell(session, { is: 'helm', vehicle: 0, state: 'requested', holder: 3, asker: 4 });
  assert.equal(has_helm(session, 0), true);
  tell(session, { is: 'helm', vehicle: 0, state: 'lost', holder: 3 });
  assert.equal(has_helm(session, 0), false);
  tell(session, { is: 'helm', vehicle: 0, state: 'held', holder: 4 });
  assert.equal(has_helm(session, 0), false);
  // Of no known state: not taken.
  tell(session, { is: 'helm', vehicle: 0, state: 'someday', holder: 3 });
  assert.equal(session.helms.get(0)?.holder, 4);
});

test('BothSidesCountTheSameSeconds', () => {
  const asked = {
    vehicle: 0,
    state: 'requested',
    holder: 3,
    asker: 4,
    until: 11_000,
    mode: '',
    cause: '',
    home_at: null,
    is_raw: false,
  } as const;
  const holder = seated();
  const asker = seated();
  asker.seat = 4;
  assert.equal(helm_words(holder, asked, 4500).countdown, 'To answer: 7 s left');
  assert.equal(helm_words(holder, asked, 4500).state, 'You drive. Bob asks for the helm.');
  assert.equal(helm_words(asker, asked, 4500).countdown, 'Waiting for Ann: 7 s left');
  assert.equal(helm_words(asker, asked, 20_000).countdown, 'Waiting for Ann: 0 s left');
});

test('ALostHelmSaysWhenTheVehicleGoesHome', () => {
  const lost = {
    vehicle: 0,
    state: 'lost',
    holder: 4,
    asker: null,
    until: 31_000,
    mode: '',
    cause: '',
    home_at: 62_000,
    is_raw: false,
  } as const;
  const words = helm_words(seated(), lost, 2000);
  assert.equal(words.state, "Bob's link is down. The vehicle holds. It goes home in 60 s.");
  assert.equal(words.countdown, 'The seat is kept 29 s.');
});

test('ReservesAreTakenIntoTheStatusesAndChangeNothingElse', () => {
  const session = seated();
  tell(session, { is: 'status', vehicle: 0, doing: 'task', reserve: 'ample', margin_s: 900 });
  const before = session.statuses.get(0);
  assert.equal(
    tell(session, { is: 'reserves', reserves: [[0, 'come home', 899], [77, 'x', 1], [null], 3] }),
    true,
  );
  assert.deepEqual(session.statuses.get(0), { ...before, reserve: 'come home', margin_s: 899 });
  assert.equal(session.statuses.has(77), false);
  tell(session, { is: 'reserves', reserves: [[0, '', null]] });
  assert.equal(session.statuses.get(0)?.margin_s, null);
});

const pose = (vehicle: number, east_m: number): Pose => pose_with({ vehicle, east_m });
function frame(number: number, is_whole: boolean, poses: Pose[]): Frame {
  return { number, step: number, time_s: number, clock_ms: number, is_whole, left_out: 0, poses };
}

test('AChangeKeepsTheOthersAndAWholeFrameReplacesAll', () => {
  const session = seated();
  show_frame(session, frame(1, true, [pose(0, 1), pose(1, 1)]));
  show_frame(session, frame(2, false, [pose(1, 5)]));
  assert.deepEqual([session.poses.get(0)?.east_m, session.poses.get(1)?.east_m], [1, 5]);
  show_frame(session, frame(3, true, [pose(0, 9)]));
  assert.deepEqual([...session.poses.keys()], [0]);
});

test('AnOlderFrameIsNotShown', () => {
  const session = seated();
  show_frame(session, frame(5, true, [pose(0, 5)]));
  show_frame(session, frame(4, true, [pose(0, 4)]));
  assert.equal(session.poses.get(0)?.east_m, 5);
  tell(session, WELCOME); // a new link counts from 1 again
  show_frame(session, frame(1, true, [pose(0, 7)]));
  assert.equal(session.poses.get(0)?.east_m, 7);
});

test('AStatusThatListsItsAlarmsEndsThoseItNoLongerHas', () => {
  const session = seated();
  tell(session, {
    is: 'status',
    vehicle: 0,
    halt: 'none',
    alarms: [
      { mmsi: 219, name: 'Aurora', is_lost: false, cpa_m: 40, cpa_s: 60 },
      { mmsi: 220, is_lost: true },
    ],
  });
  assert.deepEqual(
    [...session.alarms.values()].map((it) => [it.with, it.level, it.cpa_m]),
    [
      ['Aurora', 'close', 40],
      ['MMSI 220', 'lost from sight', null],
    ],
  );
  tell(session, { is: 'status', vehicle: 0 }); // tells of no alarms: none ends
  assert.equal(session.alarms.size, 2);
  tell(session, { is: 'status', vehicle: 1, alarms: [] }); // of another vehicle
  assert.equal(session.alarms.size, 2);
  tell(session, { is: 'status', vehicle: 0, alarms: [] });
  assert.equal(session.alarms.size, 0);
  assert.equal(session.statuses.get(0)?.halt, '');
});

test('ALateJoinerHasTheStatusesOfTheWelcome', () => {
  const session = empty_session();
  tell(session, {
    ...WELCOME,
    status: [
      { is: 'status', vehicle: 0, doing: 'task', waypoints: [{ east_m: 1, north_m: 2, up_m: -3 }] },
    ],
  });
  assert.deepEqual(session.statuses.get(0)?.waypoints, [
    { east_m: 1, north_m: 2, up_m: -3, speed_m_s: null },
  ]);
});

test('WithoutAMostSpeedFullStickIsTheCruise', () => {
  const vehicle = { ...seated().vehicles.get(0)!, most_speed_m_s: null, cruise_m_s: 0.5 };
  assert.equal(stick_speed_m_s(vehicle), 0.5);
  assert.equal(stick_speed_m_s({ ...vehicle, most_speed_m_s: 1.5 }), 1.5);
  assert.equal(stick_speed_m_s(undefined), 0);
});

test('ActionsAreInOrderAndOnlyOnce', () => {
  const session = seated();
  for (const number of [2, 1, 2, 3])
    tell(session, { is: 'action', number, what: 'ask', taken: number !== 2, why: 'x' });
  assert.deepEqual(
    session.actions.map((it) => it.number),
    [1, 2, 3],
  );
  assert.equal(session.actions[1]?.taken, false);
});

test('AnAnswerSaysWhatWasShaped', () => {
  const speed = (m_s: number): string => `${m_s} m/s`;
  const shaped = (value: unknown): string =>
    shaped_text(read_answer({ id: 1, taken: true, step: 9, shaped: value })!.shaped, speed);
  assert.equal(
    shaped({ speed: 0.5, stand_off: 0.8 }),
    "slowed to the vehicle's 0.5 m/s, kept 0.8 m off",
  );
  assert.equal(shaped({ speed: false, fence: true }), 'kept inside the fence');
  assert.equal(shaped(['speed']), "slowed to the vehicle's most speed");
  assert.equal(shaped(null), '');
  const vehicle = { most_speed_m_s: 0.5, stand_off_m: 3, fence_m: null };
  const with_vehicle = shaped_text(
    read_answer({ id: 1, taken: true, shaped: ['speed', 'stand_off', 'fence'] })!.shaped,
    speed,
    vehicle,
  );
  assert.equal(
    with_vehicle,
    "slowed to the vehicle's 0.5 m/s, kept 3.0 m off, kept inside the fence",
  );
});

test('TheWeatherAndWhoPassesByAreThoseOfTheLastMessage', () => {
  const session = seated();
  assert.equal(session.weather, null);
  tell(session, {
    is: 'weather',
    wind_m_s: 12,
    wind_from_deg: 270,
    hub_wind_m_s: 14.5,
    led: ['wind', 'water_visibility'],
    led_by: 'Sue',
    settles_in_s: 42,
    farm: { power_w: 3.21e6, rated_w: 1e7, turbines: 2 },
  });
  const { weather } = session;
  assert.ok(weather !== null && weather.farm !== null);
  assert.equal(weather.waves_m, null);
  assert.equal(led_text(weather), 'Set by Sue: wind, water visibility. It is so in 42 s.');
  assert.equal(
    farm_text(weather.farm, weather, 'm/s'),
    '3.2 MW of 10 MW (32 %), 2 turbines at 14.5 m/s',
  );
  assert.equal(
    led_text({ led: [], led_by: '', settles_in_s: 5 }),
    'The weather goes back to the run\u2019s own. It is so in 5 s.',
  );
  tell(session, {
    is: 'traffic',
    vessels: [{ mmsi: 211, name: '', east_m: 5, north_m: 6 }, { mmsi: 212 }, 'nonsense'],
  });
  assert.deepEqual(
    session.vessels.map((it) => [it.name, it.course_deg, it.speed_m_s]),
    [['MMSI 211', null, 0]],
  );
  tell(session, { is: 'traffic', vessels: [] });
  assert.equal(session.vessels.length, 0);
});

test('WhereACameraLooksIsSaidInWords', () => {
  const words = (pan_deg: number, tilt_deg: number): string =>
    camera_text({ pan_deg, tilt_deg, zoom: 1 });
  assert.equal(words(0, 0), 'Looks straight ahead, level, zoom 1.0.');
  assert.equal(words(-30, 45), 'Looks 30\u00b0 to port, 45\u00b0 up, zoom 1.0.');
  assert.equal(words(90, -90), 'Looks 90\u00b0 to starboard, 90\u00b0 down, zoom 1.0.');
});

const PICTURE: Json = {
  is: 'picture',
  vehicle: 0,
  sensor: 'rov_camera',
  number: 3,
  time_s: 1.5,
  at: 2500,
  wide: 640,
  high: 360,
};
test('OfEachCameraTheLastPictureIsKnown', () => {
  const session = empty_session();
  tell(session, { ...WELCOME, pictures: [PICTURE, { vehicle: 0 }, 'nonsense'] });
  assert.equal(session.pictures.size, 1);
  tell(session, { ...PICTURE, number: 4, time_s: 2, at: 3000 });
  tell(session, { ...PICTURE, sensor: 'other', number: 1 });
  tell(session, { is: 'picture', vehicle: 0, sensor: '', number: 9, at: 0 });
  const numbers = [...session.pictures.values()].map((it) => it.number);
  assert.deepEqual(numbers, [4, 1]);
  tell(session, WELCOME);
  assert.equal(session.pictures.size, 0, 'a welcome says what there is');
});
test('APictureSaysHowLateItWasAndWhenNoneComesAnyMore', () => {
  const session = empty_session();
  tell(session, PICTURE);
  const [picture] = session.pictures.values();
  assert.equal(picture_text(null, Number.NaN, 0), 'The first picture is on its way.');
  assert.equal(picture_text(picture!, 340, 500), 'At 1.5 s of the run, here 0.34 s later.');
  assert.equal(picture_text(picture!, Number.NaN, 500), 'At 1.5 s of the run.');
  assert.equal(picture_text(picture!, 340, 12_700), 'No new picture for 12 s.');
});
