// What is about the vehicles: light, the current between the depths that are told, who comes how
// near, turbines, people, and all of it in words.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Line, Matrix4, Scene, Vector3, type InstancedMesh } from 'three';
import { light_left, light_seen } from 'page/scene/air_and_water';
import { approach_of, approaches_in } from 'page/scene/approach';
import { daylight_of } from 'page/scene/daylight';
import { FarmView } from 'page/scene/farm_view';
import { FlowSlice, hodograph } from 'page/scene/flow_view';
import { scene_in_words } from 'page/scene/in_words';
import { Kept } from 'page/scene/kept';
import { names_in } from 'page/scene/labels';
import { direction_of, look_along, people_names, place_people } from 'page/scene/people_shown';
import { read_weather } from 'page/session/around';
import { current_at, read_currents } from 'page/session/currents';
import { read_turbines } from 'page/session/farm';
import { empty_session, tell } from 'page/session/state';
import { pose_with as pose } from './pose_for_tests';

const near = (found: number, expected: number, within: number): void =>
  assert.ok(Math.abs(found - expected) <= within, `${found} is not ${expected}`);

test('by day the sun shines from where it stands, by night none does', () => {
  const noon = daylight_of({ elevation_deg: 30, azimuth_deg: 90 }, '#80c0ff');
  near(noon.to_sun.distanceTo(new Vector3(Math.sqrt(3) / 2, 0.5, 0)), 0, 1e-9); // east
  near(noon.beam, 0.5 / 0.6, 1e-9);
  const night = daylight_of({ elevation_deg: -30, azimuth_deg: 0 }, '#80c0ff');
  assert.equal(night.beam, 0);
  assert.ok(night.light < 0.3 * noon.light);
});

const currents = read_currents([[-20, 0, 0.2], [0, 0.5, 0], [-10, 0.1, 0.1], ['nonsense']]);

test('the current is linear between its depths and unknown outside of them', () => {
  assert.deepEqual(current_at(currents, -5), { up_m: -5, east_m_s: 0.3, north_m_s: 0.05 });
  assert.deepEqual(current_at(currents, -20), { up_m: -20, east_m_s: 0, north_m_s: 0.2 });
  assert.equal(current_at(currents, -20.1), null);
  assert.equal(current_at(currents, 0.1), null);
  assert.equal(current_at([], 0), null);
});

test('arrows point where the water goes, at their depth', () => {
  const [surface] = hodograph(currents, { east_m: 7, north_m: 3, up_m: -4 });
  assert.deepEqual(surface!.from.toArray(), [7, 0, -3]);
  const way = surface!.to.clone().sub(surface!.from).normalize();
  near(way.distanceTo(new Vector3(1, 0, 0)), 0, 1e-12);
  const slice = new FlowSlice();
  const at = { about: new Vector3(100, -3, 50), reach_m: 20 };
  assert.equal(slice.show(currents, -20, at, '#000000')?.north_m_s, 0.2);
  const matrix = new Matrix4();
  slice.mesh.getMatrixAt(0, matrix);
  const tip = new Vector3(0, 0, -1).transformDirection(matrix);
  near(tip.distanceTo(new Vector3(0, 0, -1)), 0, 1e-6); // north
  near(new Vector3().setFromMatrixPosition(matrix).y, -20, 1e-6);
  slice.show(currents, -30, at, '#000000');
  assert.equal(slice.mesh.visible, false);
});

test('who comes near is as far away then as it was said', () => {
  // A vessel crosses ahead: it goes east at 4 m/s from 400 m west and 60 m north.
  const own = pose({ vehicle: 1 });
  const vessel = { mmsi: '2', name: 'TUG', course_deg: 90, speed_m_s: 4, length_m: null };
  const told = { vehicle: 1, with: 'TUG', level: 'close', cpa_m: 60, cpa_s: 100 };
  const found = approach_of(told, own, { ...vessel, east_m: -400, north_m: 60 });
  assert.ok(found !== null);
  const { east_m, north_m } = found.others;
  near(Math.hypot(east_m - found.own.east_m, north_m - found.own.north_m), 60, 1e-9);
  assert.equal(
    approach_of({ ...told, cpa_s: -5 }, own, { ...vessel, east_m: 0, north_m: 0 }),
    null,
  );
});

test('light fades downwards, red and blue before green, and an eye gets used to it', () => {
  const [red, green, blue] = light_left(0.4, 10);
  near(green, Math.exp(-1), 1e-12);
  near(red, Math.exp(-0.33 / 0.19), 1e-12);
  near(blue, Math.exp(-0.39 / 0.19), 1e-12);
  const seen = light_seen(0.4, 10);
  near(seen[0] / seen[1], red / green, 1e-12);
  assert.ok(seen[1] > green);
  assert.deepEqual(light_left(0.4, -1), [1, 1, 1]);
  // So deep and turbid that nothing at all is left: dark, and still a number.
  assert.ok(light_seen(96, 60).every((it) => it >= 0 && it < 1e-9));
});

const turbines = read_turbines({
  hub_height_m: 90,
  rotor_diameter_m: 126,
  rated_w: 5e6,
  places: [
    [0, 0],
    [900, 0],
  ],
});
const weather = read_weather({
  sun: { elevation_deg: 58.7, azimuth_deg: 164 },
  led: ['water_visibility'],
  hub_wind_m_s: 9,
  hub_wind_from_deg: 270,
  currents: [
    [0, 0.5, 0],
    [-20, 0, 0.2],
  ],
  farm: {
    power_w: 3e6,
    rated_w: 10e6,
    turbines: 2,
    each: [
      { power_w: 2e6, wind_m_s: 9, rotor_speed_rad_s: 1.1, wind_left: [0.5, 0.7, 0.9] },
      { power_w: 1e6, wind_m_s: 7, rotor_speed_rad_s: 0.9, wind_left: [0.5, 0.7, 0.9] },
    ],
  },
});

test('a rotor looks into the wind and turns as fast as it is told, clockwise from upwind', () => {
  assert.ok(turbines !== null && weather !== null);
  const view = new FarmView(turbines);
  const eye = new Vector3(0, 90, 0);
  view.show(weather, 100, true, eye);
  view.show(weather, 101, true, eye);
  const rotors = view.group.getObjectByName('rotors') as InstancedMesh;
  const matrix = new Matrix4();
  rotors.getMatrixAt(1, matrix);
  near(new Vector3().setFromMatrixPosition(matrix).distanceTo(new Vector3(900, 90, 0)), 0, 1e-3);
  const ahead = new Vector3(0, 0, -1).transformDirection(matrix);
  near(ahead.distanceTo(new Vector3(-1, 0, 0)), 0, 1e-6); // to the west
  // Who stands in the west and looks east has south to the right: there the first blade goes.
  const blade = new Vector3(0, 1, 0).transformDirection(matrix);
  near(blade.distanceTo(new Vector3(0, Math.cos(0.9), Math.sin(0.9))), 0, 1e-6);
  // The wakes lie downwind, at the height of the hub.
  const wake = view.group.children[6] as InstancedMesh;
  wake.getMatrixAt(0, matrix);
  const middle = new Vector3(0, 0, 126).applyMatrix4(matrix);
  near(middle.distanceTo(new Vector3(126, 90, 0)), 0, 1e-3);
  near(wake.instanceColor!.getX(0), 0.5, 1e-6);
  // In a calm nobody tells a direction: they stay as they are.
  view.show({ ...weather, hub_wind_m_s: 0, hub_wind_from_deg: null }, 102, true, eye);
  rotors.getMatrixAt(1, matrix);
  const still = new Vector3(0, 0, -1).transformDirection(matrix);
  near(still.distanceTo(new Vector3(-1, 0, 0)), 0, 1e-6);
});

test('the scene is told in words', () => {
  const session = empty_session();
  tell(session, {
    is: 'welcome',
    water: { forecast: 'borkum 2026-06-21' },
    turbines: {
      hub_height_m: 90,
      rotor_diameter_m: 126,
      rated_w: 5e6,
      places: [
        [0, 0],
        [900, 0],
      ],
    },
    vehicles: [{ vehicle: 0, name: 'rov', kind: 'rov' }],
    lines: [
      {
        vehicle: 0,
        nodes: [
          [0, 0, 0],
          [0, 0, -6],
          [3, 0, -10],
        ],
      },
    ],
  });
  session.weather = weather;
  assert.deepEqual(scene_in_words(session, approaches_in(session), 'm/s'), [
    'Wind, waves and current are of the forecast borkum 2026-06-21; ' +
      'set by hand: water visibility. Vehicles are as the twin has them.',
    'The sun stands 59° high at 164°; a clear sky is supposed.',
    'Wind at hub height, 90 m up: 9.0 m/s from 270°.',
    'Current 0 m deep: 0.50 m/s to 090°.',
    'Current 10 m deep: 0.27 m/s to 068°.',
    'Current 20 m deep: 0.20 m/s to 000°.',
    'Turbine 1, 0 m from the origin: 2.0 MW in 9.0 m/s.',
    'Turbine 2, 900 m from the origin: 1.0 MW in 7.0 m/s.',
    'The tether of rov, 11 m of it out.',
  ]);
  const names = (eye: Vector3): string[] => names_in(session, null, eye, []).map((it) => it.text);
  assert.deepEqual(names(new Vector3(800, 20, 0)), ['T2 1.0 MW', 'T1 2.0 MW']);
  assert.deepEqual(names(new Vector3(800, -20, 0)), []);
  // A tether that has parted, or is wound up, is told without nodes.
  tell(session, { is: 'line', vehicle: 0, nodes: [] });
  assert.equal(session.lines.size, 0);
});

test('a direction is told in degrees and found again', () => {
  for (const [heading_deg, tilt_deg, way] of [
    [0, 0, [0, 0, -1]],
    [90, 0, [1, 0, 0]],
    [180, 0, [0, 0, 1]],
    [270, 30, [-Math.sqrt(3) / 2, 0.5, 0]],
  ] as const) {
    const found = direction_of({ heading_deg, tilt_deg });
    near(found.distanceTo(new Vector3(...way)), 0, 1e-9);
    const told = look_along(found);
    near(told.heading_deg, heading_deg, 1e-9);
    near(told.tilt_deg, tilt_deg, 1e-9);
  }
});

test('others are seen where they look, oneself is not, and notes have names', () => {
  const session = empty_session();
  const from = { east_m: 1, north_m: 2, up_m: 3 };
  const at = { east_m: 4, north_m: 5, up_m: -6 };
  const looks = [1, 2].map((seat) => ({ seat, from, heading_deg: 90, tilt_deg: 0, point: at }));
  tell(session, {
    is: 'welcome',
    seat: 1,
    seats: [
      { seat: 1, name: 'Ann', role: 'operator' },
      { seat: 2, name: 'Sue', role: 'supervisor' },
    ],
    looks,
    notes: [{ note: 1, seat: 2, who: 'Sue', text: 'loose anode', at }, { note: 2 }, 'nonsense'],
  });
  const names = people_names(session).map((it) => it.text);
  assert.deepEqual(names, ['Sue', 'Sue ▸', 'Sue: loose anode']);
  const scene = new Scene();
  place_people(new Kept(scene), session, { accent: '#000000', amber: '#000000' });
  const gaze = scene.children.find((it) => it instanceof Line) as Line;
  const ends = gaze.geometry.getAttribute('position');
  assert.deepEqual([...ends.array], [1, 3, -2, 4, -6, -5]);
  tell(session, { is: 'looks', looks: [] });
  tell(session, { is: 'notes', notes: [] });
  assert.equal(people_names(session).length, 0);
});

test('an alarm tells who has seen to it', () => {
  const session = empty_session();
  const alarm = { mmsi: 211000001, name: 'TUG', cpa_m: 60, cpa_s: 90 };
  const told = (more: object): void => {
    tell(session, { is: 'status', vehicle: 1, alarms: [{ ...alarm, ...more }] });
  };
  told({ acknowledged_by: null });
  assert.equal([...session.alarms.values()][0]?.acknowledged_by, '');
  told({ acknowledged_by: 'Ann' });
  assert.equal([...session.alarms.values()][0]?.acknowledged_by, 'Ann');
});

test('of a recording whose forecast is gone it is said why', () => {
  const session = empty_session();
  tell(session, {
    is: 'welcome',
    water: { missing: 'the forecast is not in the store' },
    sea: null,
    playback: { from_s: 0, to_s: 60 },
  });
  assert.equal(session.forecast, undefined);
  assert.equal(session.sea, null);
  assert.deepEqual(scene_in_words(session, [], 'm/s'), [
    'Waves, wind, current, turbines and traffic of this run are not shown: ' +
      'the forecast is not in the store.',
  ]);
  tell(session, { is: 'welcome', water: { forecast: null } });
  assert.equal(session.water_missing, '', 'the next one is another');
  assert.equal(session.forecast, null);
});
