// What else is about the vehicles in the scene: thrusters at work, wind, foundations, pictures and
// layers, and how large things are seen. Pixels are for tests/strangers/scene-drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  BoxGeometry,
  Color,
  MeshBasicMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  type BufferGeometry,
  type InstancedMesh,
  type Mesh,
} from 'three';
import { seen_px } from 'page/scene/detail';
import { Foundations } from 'page/scene/foundations';
import { InspectedView } from 'page/scene/inspected_view';
import { Instances } from 'page/scene/instances';
import { jet_of } from 'page/scene/jets';
import { ALL_LAYERS, has_layer } from 'page/scene/layers';
import { site_names } from 'page/scene/site_names';
import { SiteView } from 'page/scene/site_view';
import { site_in_words } from 'page/scene/site_words';
import { wind_of, wind_tips } from 'page/scene/wind_view';
import type { Pose } from 'page/session/frame';
import { empty_session, tell } from 'page/session/state';
import { pose_with } from './pose_for_tests';
import { INSPECTED } from './inspected_for_tests';

const near = (found: Vector3, expected: readonly number[], within = 1e-9): void => {
  const off = found.distanceTo(new Vector3(...expected));
  assert.ok(off < within, `${found.toArray().join(' ')} is not ${expected.join(' ')}`);
};

test('a thruster throws water opposite to its push, as far as it gives', () => {
  const heading_rad = Math.PI / 2; // east
  const pose = pose_with({ east_m: 10, north_m: 20, up_m: -5, heading_rad });
  // To starboard of the middle; it pushes ahead.
  const mount = { at: [0, 0.4, 0.1], axis: [1, 0, 0] } as const;
  const ahead = jet_of(mount, 0.5, pose, 2)!;
  near(ahead.from, [10, -5.1, -19.6]); // starboard of a bow to the east is south
  near(ahead.to.clone().sub(ahead.from), [-1.2, 0, 0]);
  near(jet_of(mount, -1, pose, 2)!.to.sub(ahead.from), [2.4, 0, 0]);
  assert.equal(jet_of(mount, 0.001, pose, 2), null);
  // Up out of a vehicle that is on its side: its down is to port of its bow.
  const lifts = { at: [0, 0, 0], axis: [0, 0, -1] } as const;
  const rolled = jet_of(lifts, 1, pose_with({ roll_rad: Math.PI / 2 }), 1)!;
  near(rolled.to, [-1.2, 0, 0], 1e-9); // rolled to starboard its top is east; water goes west
});

test('the wind is at hub height before the nearest turbines, else over the origin', () => {
  const session = empty_session();
  tell(session, {
    is: 'welcome',
    turbines: {
      hub_height_m: 90,
      rotor_diameter_m: 100,
      places: [
        [0, 0],
        [500, 0],
        [900, 0],
        [1400, 0],
      ],
    },
    weather: { wind_m_s: 7, wind_from_deg: 180, hub_wind_m_s: 9, hub_wind_from_deg: 270 },
  });
  const wind = wind_of(session)!;
  const tips = wind_tips(session, wind, new Vector3(1400, 90, 0));
  assert.deepEqual(
    tips.map((it) => Math.round(it.east_m)),
    [1360, 860, 460],
  ); // west of their rotors
  assert.equal(tips[0]!.up_m, 90);
  assert.ok(
    site_in_words(session, 'm/s').includes('Wind at hub height, 90 m up: 9.0 m/s from 270°.'),
  );
  session.turbines = null;
  assert.deepEqual(wind_of(session), { speed_m_s: 7, from_deg: 180, high_m: 10, is_at_hub: false });
  assert.ok(site_in_words(session, 'm/s').includes('Wind 10 m up: 7.0 m/s from 180°.'));
  assert.ok(site_in_words(session, 'knots').includes('Wind 10 m up: 13.6 kn from 180°.'));
  const label = (): string[] =>
    site_names(session, new InspectedView(new Scene()), new Vector3(0, 5, 0), ALL_LAYERS, 'knots')
      .filter((it) => it.key === 'wind')
      .map((it) => it.text);
  assert.deepEqual(label(), ['13.6 kn']); // 7 m/s of 1852 m an hour
  tell(session, { is: 'weather', wind_m_s: 0, wind_from_deg: null });
  assert.ok(site_in_words(session, 'm/s').includes('Wind 10 m up: calm.'));
  assert.deepEqual(label(), [], 'there is no arrow');
  assert.equal(has_layer('wind', session, null), true);
  tell(session, { is: 'weather', wind_m_s: 7, wind_from_deg: null });
  const unknown = 'Wind 10 m up: 7.0 m/s, its direction is not known.';
  assert.ok(site_in_words(session, 'm/s').includes(unknown));
  session.weather = null;
  assert.equal(wind_of(session), null);
});

test('what is half as far away is seen twice as large', () => {
  const camera = new PerspectiveCamera(55, 1, 0.1, 1000);
  const lens = { eye: new Vector3(), field_deg: 55, high_px: 1000 };
  const at = (away_m: number): number => seen_px(lens, new Vector3(0, 0, -away_m), 2);
  assert.ok(Math.abs(at(10) / at(20) - 2) < 1e-9);
  // As the projection has it.
  const top = new Vector3(0, 1, -20).project(camera).y - new Vector3(0, -1, -20).project(camera).y;
  assert.ok(Math.abs(at(20) - (top / 2) * 1000) < 1e-6);
});

test('foundations are round from near and have few faces from afar', () => {
  const scene = new Scene();
  const view = new Foundations(scene);
  const camera = new PerspectiveCamera(55, 1, 0.1, 20_000);
  const size = { radius_m: 4, bottom_m: -30, top_m: 15 };
  const structures = [0, 3000].map((east_m) => ({ name: '', east_m, north_m: 0, ...size }));
  const shown = (): number[] => scene.children.map((it) => (it as InstancedMesh).count);
  camera.position.set(20, -10, 0);
  view.show(structures, { eye: camera.position, field_deg: camera.fov, high_px: 400 });
  assert.deepEqual(shown(), [1, 1]);
  camera.position.set(1500, 900, 0);
  view.show(structures, { eye: camera.position, field_deg: camera.fov, high_px: 400 });
  assert.deepEqual(shown(), [0, 2]);
});

test('as many of one body are drawn as there are', () => {
  const scene = new Scene();
  const many = new Instances(scene, new BoxGeometry(1, 1, 1), new MeshBasicMaterial(), 'boxes');
  for (const count of [3, 100, 0, 41]) {
    many.begin();
    for (let i = 0; i < count; i += 1) {
      many.part.position.set(i, 0, 0);
      many.add(new Color(i / 100, 0, 0));
    }
    many.end();
    const [drawn] = scene.children as InstancedMesh[];
    assert.deepEqual([scene.children.length, drawn!.count, drawn!.name], [1, count, 'boxes']);
    if (count === 0) continue;
    assert.equal(drawn!.instanceMatrix.getX(4 * (count - 1)) !== 0, true);
    assert.equal(drawn!.instanceMatrix.array[16 * (count - 1) + 12], count - 1);
    assert.ok(Math.abs(drawn!.instanceColor!.getX(count - 1) - (count - 1) / 100) < 1e-6);
  }
});

test('the picture of a camera is in its view while it is of now, and of its vehicle', () => {
  const scene = new Scene();
  const site = new SiteView(scene);
  const session = empty_session();
  tell(session, {
    is: 'welcome',
    vehicles: [{ vehicle: 0, name: 'rov' }],
    status: [{ vehicle: 0, camera: { pan_deg: 0 } }],
    pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 4, at: 9 }],
  });
  const pane = scene.children.at(-1) as Mesh<BufferGeometry, MeshBasicMaterial>;
  const [of] = session.pictures.values();
  const canvas = { width: 64, height: 36 } as HTMLCanvasElement;
  const is_shown = (layers = ALL_LAYERS, pose: Pose | null = pose_with({})): boolean => {
    site.show_picture(pose, session, layers);
    return pane.visible;
  };
  assert.equal(is_shown(), false, 'there is none');
  site.picture = { of: of!, canvas, is_old: false };
  assert.equal(is_shown(), true);
  assert.equal(is_shown({ ...ALL_LAYERS, picture: false }), false);
  assert.equal(is_shown(ALL_LAYERS, pose_with({ vehicle: 1 })), false);
  assert.equal(is_shown(ALL_LAYERS, null), false);
  const before = pane.material.map;
  assert.equal(is_shown(), true);
  assert.equal(pane.material.map, before);
  site.picture = { of: of!, canvas, is_old: true };
  assert.equal(is_shown(), false);
  // Of the same number, in another session.
  site.picture = { of: { ...of!, at: 5 }, canvas, is_old: false };
  assert.equal(is_shown(), true);
  assert.notEqual(pane.material.map, before);
});

test('a layer is offered where there is something to show', () => {
  const session = empty_session();
  const offered = (chosen: number | null = 0): string[] =>
    (['laid', 'inspected', 'wind', 'picture'] as const).filter((it) =>
      has_layer(it, session, chosen),
    );
  assert.deepEqual(offered(), []);
  tell(session, {
    ...INSPECTED,
    moorings: [{ id: 'M1', fairlead: [0, 0, -10], anchor: [30, 40, -10] }],
    weather: { wind_m_s: 7, wind_from_deg: 180 },
    pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 4, at: 9, time_s: 12.3 }],
  });
  assert.deepEqual(offered(), ['laid', 'inspected', 'wind', 'picture']);
  assert.deepEqual(offered(1), ['laid', 'inspected', 'wind']);
});
