// What is about the vehicles in the scene: relief, what is laid, thrusters at work, wind, what is
// inspected, how large things are seen, and the same in words. Pixels are for
// tests/strangers/scene-drawn.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  BoxGeometry,
  Color,
  LineSegments,
  MeshBasicMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Vector3,
  type BufferGeometry,
  type InstancedMesh,
  type Mesh,
} from 'three';
import type { Colours } from 'page/look/palette';
import { BedView, relief_of, shades_of } from 'page/scene/bed_view';
import { seen_px } from 'page/scene/detail';
import { Foundations } from 'page/scene/foundations';
import { InspectedView, LEAST_SHADE } from 'page/scene/inspected_view';
import { Instances } from 'page/scene/instances';
import { jet_of } from 'page/scene/jets';
import { LaidView, laid_on } from 'page/scene/laid_view';
import { ALL_LAYERS, has_layer } from 'page/scene/layers';
import { met_along } from 'page/scene/met';
import { finding_text, site_names } from 'page/scene/site_names';
import { SiteView } from 'page/scene/site_view';
import { site_in_words } from 'page/scene/site_words';
import { pieces_near } from 'page/scene/strands';
import { wind_of, wind_tips } from 'page/scene/wind_view';
import type { Pose } from 'page/session/frame';
import { bed_at, read_bed, type Bed } from 'page/session/bed';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { empty_session, tell } from 'page/session/state';
import { surfaces_fetched } from 'page/panel/surfaces_fetched';
import type { Station } from 'page/station';
import { pose_with } from './pose_for_tests';

const near = (found: Vector3, expected: readonly number[], within = 1e-9): void => {
  const off = found.distanceTo(new Vector3(...expected));
  assert.ok(off < within, `${found.toArray().join(' ')} is not ${expected.join(' ')}`);
};

const PAINT = { ink: '#000000', quiet: '#777777' } as Colours;

const hill = (east_m: number, north_m: number): number =>
  -30 + 6 * Math.exp(-(east_m ** 2 + north_m ** 2) / 5000);
function hilly(across = 9, step_m = 25): Bed {
  const half_m = ((across - 1) * step_m) / 2;
  const up_m = Array.from({ length: across * across }, (_, i) =>
    hill(-half_m + step_m * (i % across), -half_m + step_m * Math.floor(i / across)),
  );
  return read_bed({ east_m: -half_m, north_m: -half_m, step_m, across, up_m })!;
}

test('the bed is drawn where it is: a plumb line meets it at its height, level beyond', () => {
  const bed = hilly();
  const view = new BedView();
  const session = empty_session();
  session.bed = bed;
  view.take(session);
  view.group.updateMatrixWorld(true);
  for (const [east_m, north_m] of [
    [1, 2],
    [13, -57],
    [-99, 97.5],
    [61.5, 2],
    [400, 310],
    [-9000, 70],
    // Over the slope to it, one step wide: sides, corners, and close to their ends.
    [3, -112],
    [113, 31],
    [-52, 109],
    [-124, -7],
    [103, 104],
    [-120, 111],
    [101, -124.5],
    [-124, -123.9],
  ] as const) {
    const ray = new Raycaster(new Vector3(east_m, 100, -north_m), new Vector3(0, -1, 0));
    const hits = ray.intersectObject(view.group, true).filter((it) => it.object.visible);
    assert.equal(hits.length, 1, 'one face, from above');
    assert.ok(Math.abs(hits[0]!.point.y - view.up_at(east_m, north_m)!) < 1e-3);
  }
  assert.ok(Math.abs(view.up_at(0, 0)! - -24) < 1e-9);
  assert.ok(view.up_at(5000, 0)! < -29.5);
});

test('beside a hole at the edge the slope has one, too, where it is drawn so', () => {
  const bed = hilly();
  bed.up_m[8 * 9 + 3] = bed.up_m[3 * 9 + 8] = null; // of the northern and the eastern edge
  const view = new BedView();
  const session = empty_session();
  session.bed = bed;
  view.take(session);
  view.group.updateMatrixWorld(true);
  let holes = 0;
  for (let along_m = -110.3; along_m < 110; along_m += 3.7)
    for (const [east_m, north_m] of [
      [along_m, 113.1],
      [113.1, along_m],
    ] as const) {
      const from = new Vector3(east_m, 100, -north_m);
      const hit = met_along([view.group], from, new Vector3(0, -1, 0));
      const up_m = view.up_at(east_m, north_m);
      if (hit === null) {
        holes += 1;
        assert.equal(up_m, null);
      } else assert.ok(Math.abs(hit.point.y - up_m!) < 1e-3, `${east_m} ${north_m}`);
    }
  assert.ok(holes > 10);
});

test('what nobody knows is a hole, and a bed without a grid is level', () => {
  const bed = hilly(5);
  bed.up_m[2 * 5 + 2] = null; // the middle
  const view = new BedView();
  const session = empty_session();
  session.bed = bed;
  view.take(session);
  view.group.updateMatrixWorld(true);
  const ray = new Raycaster(new Vector3(1, 100, -1), new Vector3(0, -1, 0));
  const hits = ray.intersectObject(view.group, true).filter((it) => it.object.visible);
  assert.equal(hits.length, 0);
  assert.equal(view.up_at(1, 1), null);
  assert.equal(relief_of(bed, -30).index!.count, 3 * (2 * 16 - 6 + 4 * 16));
  session.bed = null;
  session.poses.set(0, pose_with({ up_m: -5, bed_m: 20 }));
  view.take(session);
  assert.equal(view.up_at(123, 456), -25);
});

test('relief is lit from the north-west, level is neither lit nor dark', () => {
  const bed = hilly();
  const shades = shades_of(bed);
  const at = (column: number, row: number): number => shades[row * 9 + column]!;
  assert.ok(at(3, 5) > 1.1 && at(5, 3) < 0.9, 'the far side of the hill is darker');
  assert.ok(Math.abs(at(4, 4) - 1) < 1e-9, 'its top is level');
  const level = read_bed({ east_m: 0, north_m: 0, step_m: 1, across: 2, up_m: [-9, -9, -9, -9] })!;
  assert.deepEqual(shades_of(level), [1, 1, 1, 1]);
});

test('a cable lies on the bed that is drawn, also between its places', () => {
  const bed = hilly();
  const ends = [-80, 80].map((east_m) => ({ east_m, north_m: 3, up_m: bed_at(bed, east_m, 3)! }));
  const laid = laid_on({ up_at: (e, n) => bed_at(bed, e, n) }, ends, 12.5);
  assert.equal(laid.length, 14);
  for (const at of laid) assert.ok(at.up_m > bed_at(bed, at.east_m, at.north_m)! + 0.1);
  assert.ok(Math.max(...laid.map((it) => it.up_m)) > -25);
  // What is told higher stays higher; where no bed is drawn it is as told.
  assert.ok(laid_on({ up_at: () => -30 }, [{ east_m: 0, north_m: 0, up_m: -8 }], 1)[0]!.up_m > -8);
  assert.ok(laid_on({ up_at: () => null }, [{ east_m: 0, north_m: 0, up_m: -8 }], 1)[0]!.up_m > -8);
});

test('a cable lies on the bed of its session from the first picture on', () => {
  const [scene, bed] = [new Scene(), new BedView()];
  const laid = new LaidView(scene);
  const session = empty_session();
  const lens = { eye: new Vector3(), field_deg: 55, high_px: 400 };
  const lowest_over_m = (): number => {
    bed.take(session);
    laid.show(session, bed, lens, PAINT);
    const lines = scene.children[0]!.children.find((it) => it instanceof LineSegments);
    const places = (lines as LineSegments).geometry.getAttribute('position');
    const over = Array.from({ length: places.count }, (_, i) => {
      return places.getY(i) - bed_at(session.bed!, places.getX(i), -places.getZ(i))!;
    });
    return Math.min(...over);
  };
  const ends = [-80, 80].map((east_m) => ({ east_m, north_m: 3, up_m: -32 }));
  session.cables = [{ id: 'c', route: ends, burial_m: 0 }];
  session.bed = hilly();
  assert.ok(lowest_over_m() > 0.1);
  session.bed = hilly(17, 12.5); // another one
  assert.ok(lowest_over_m() > 0.1);
  // Whoever asks too early lays it anew as soon as its bed is there.
  const early = new BedView();
  laid.show(session, early, lens, PAINT);
  assert.ok(lowest_over_m() > 0.1);
});

test('rods are laid near the eye alone, dashes where it is buried', () => {
  const through = [new Vector3(-5000, 0, 0), new Vector3(0, 0, 0), new Vector3(5000, 0, 0)];
  const sum = (is_dashed: boolean): number =>
    pieces_near({ through, is_dashed }, new Vector3(0, 3, 0)).reduce((length_m, [a, b]) => {
      assert.ok(Math.max(a.length(), b.length()) < 70);
      return length_m + a.distanceTo(b);
    }, 0);
  assert.ok(Math.abs(sum(false) - 120) < 12);
  assert.ok(Math.abs(sum(true) / sum(false) - 0.6) < 0.08, 'six of ten metres');
  assert.equal(pieces_near({ through, is_dashed: false }, new Vector3(0, 0, 200)).length, 0);
});

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

const SQUARE = {
  name: 'plate',
  kind: 'bed',
  corners: [0, 0, -30, 1, 0, -30, 0, 1, -30, 1, 1, -30],
  triangles: [0, 1, 2, 1, 3, 2, 0, 2, 1],
  patch_of: [1, 0, -1],
};
const INSPECTED = {
  is: 'welcome',
  vehicles: [{ vehicle: 0, name: 'rov' }],
  surfaces: [
    { vehicle: 0, surface: 0, name: 'plate', kind: 'bed', patches: 2, seen: 0.5, asked: 0.9 },
  ],
  covered: [{ vehicle: 0, surface: 0, seen: 0.5, runs: [[1, 1]] }],
  findings: [
    {
      vehicle: 0,
      findings: [
        { kind: 'crack', at: [0.5, 0.5, -30], size_m: 0.12, by: 'rov_camera' },
        { kind: 'marine_growth', at: [99, 0, -30] },
      ],
    },
  ],
};
const TONES = { covered: '#ffff00', not_covered: '#0000ff' };

test('each patch has its tone, whatever the order of its triangles, and paint lies over it', () => {
  const scene = new Scene();
  const view = new InspectedView(scene);
  const session = empty_session();
  tell(session, INSPECTED);
  const [surface] = session.surfaces.values();
  view.take(surface!, read_surface_mesh(SQUARE)!);
  const camera = new PerspectiveCamera(55, 1, 0.1, 1000);
  camera.position.set(0, -28, 0);
  const show = (): number[] => {
    view.show(session, { eye: camera.position, field_deg: camera.fov, high_px: 400 }, TONES);
    const { geometry } = scene.getObjectByName('inspected')!.children[0] as Mesh;
    const [colour, place] = ['color', 'position'].map((it) => geometry.getAttribute(it));
    assert.equal(place!.count, 6, 'what is of no patch is left out');
    assert.ok(place!.getY(0) > -30 && place!.getY(5) > -30);
    // Blue of each triangle: all of it where it is not covered.
    return [0, 3].map((corner) => Math.round(colour!.getZ(corner)));
  };
  assert.deepEqual(show(), [1, 0]); // patch 0, then patch 1
  tell(session, { is: 'covered', vehicle: 0, surface: 0, runs: [[0, 1]] });
  assert.deepEqual(show(), [0, 0]);
  tell(session, INSPECTED); // the link was cut, and the server began again
  assert.deepEqual(show(), [1, 0]);
  camera.position.set(5000, -28, 0);
  view.show(session, { eye: camera.position, field_deg: camera.fov, high_px: 400 }, TONES);
  const marks = scene.children.find((it) => it !== scene.getObjectByName('inspected'))!;
  assert.equal((marks as InstancedMesh).count, 1, 'far away it is a mark');
  session.surfaces.clear();
  view.show(session, { eye: camera.position, field_deg: camera.fov, high_px: 400 }, TONES);
  assert.equal(scene.getObjectByName('inspected')!.children.length, 0);
});

test('a surface of another session is another one, and is fetched at once', async () => {
  const scene = new Scene();
  const view = new InspectedView(scene);
  const group = scene.getObjectByName('inspected')!;
  const lens = { eye: new Vector3(0, -28, 0), field_deg: 55, high_px: 400 };
  const asked: string[] = [];
  const surface = (vehicle: number, of: string): Promise<unknown> => {
    asked.push(`${vehicle} ${of}`);
    return Promise.resolve(SQUARE);
  };
  const session = empty_session();
  const station = { session, wire: { surface } };
  const fetch_into = surfaces_fetched(station as unknown as Station, () => undefined);
  /** As the scene does for a picture; then what was asked for is there. */
  const picture = async (is_layer_shown = true): Promise<void> => {
    fetch_into(view);
    if (is_layer_shown) view.show(station.session, lens, TONES);
    else view.hide(station.session);
    await new Promise((done) => setImmediate(done));
  };
  tell(session, { ...INSPECTED, title: 'monday', start: '2026-06-01T00:00:00Z' });
  await picture();
  await picture();
  assert.deepEqual([asked.length, group.children.length], [1, 1]);
  // The link was cut: the surface is the same.
  tell(session, { ...INSPECTED, title: 'monday', start: '2026-06-01T00:00:00Z' });
  await picture();
  assert.deepEqual([asked.length, group.children.length], [1, 1]);
  // Of other days, and of another session, each has a surface of the same name.
  const mesh = group.children[0];
  tell(session, { ...INSPECTED, title: 'monday', start: '2026-06-08T00:00:00Z' });
  await picture();
  assert.equal(group.children.length, 0, 'the old one is nobody' + "'s");
  await picture();
  assert.equal(asked.length, 2);
  assert.notEqual(group.children[0], mesh);
  station.session = empty_session();
  tell(station.session, { ...INSPECTED, title: 'monday', start: '2026-06-08T00:00:00Z' });
  await picture(false);
  assert.equal(group.children.length, 0, 'it is dropped, though the layer is hidden');
});

test('surfaces and the nearest findings have names, and all of it is told in words', () => {
  const session = empty_session();
  tell(session, {
    ...INSPECTED,
    bed: { east_m: 0, north_m: 0, step_m: 10, across: 2, up_m: [-20, -22, -24, null] },
    cables: [
      {
        id: 'export',
        route: [
          [0, 0, -20],
          [30, 40, -20],
        ],
        burial_m: 1.5,
      },
      {
        id: 'old',
        route: [
          [0, 0, -20],
          [0, 9, -20],
        ],
        burial_m: null,
      },
    ],
    moorings: [{ id: 'M1', fairlead: [0, 0, -10], anchor: [30, 40, -10] }],
    thrusts: [{ vehicle: 0, share: [0.5, 0, -0.25] }],
    pictures: [{ vehicle: 0, sensor: 'rov_camera', number: 4, at: 9, time_s: 12.3 }],
  });
  const view = new InspectedView(new Scene());
  const [surface] = session.surfaces.values();
  view.take(surface!, read_surface_mesh(SQUARE)!);
  const names = (layers = ALL_LAYERS): string[] =>
    site_names(session, view, new Vector3(0, -28, 0), layers, 'm/s').map((it) => it.text);
  assert.deepEqual(names(), ['export', 'old', 'M1', 'plate 50 %', 'crack 12 cm']);
  assert.deepEqual(names({ ...ALL_LAYERS, inspected: false }), ['export', 'old', 'M1']);
  assert.deepEqual(site_in_words(session, 'm/s'), [
    'The bed, over 10 m by 10 m, a height each 10 m: 24.0 m deep to 20.0 m deep; level beyond. ' +
      'The bed is unknown at 1 of 4 places: holes in the picture.',
    'Cable export: 50 m shown, buried 1.5 m.',
    'Cable old: 9 m shown, whether it is buried is not known.',
    'Mooring M1: from 10.0 m deep to its anchor 10.0 m deep, 50 m in a straight line. ' +
      'How it hangs is not known.',
    'Thrusters of rov: 1 at 50 %, 3 at 25 % backwards.',
    'rov inspects plate (bed): 50 % covered of 90 % asked.',
    'rov found: crack 12 cm, 30.0 m deep, by rov_camera.',
    'rov found: marine growth, 30.0 m deep.',
    'The last picture of rov camera of rov was taken at 12.3 s of the run.',
  ]);
  surface!.seen = 0.8999; // of 90 % asked
  assert.equal(names()[3], 'plate 89 %');
  assert.ok(site_in_words(session, 'm/s')[5]!.endsWith(': 89 % covered of 90 % asked.'));
  assert.equal(finding_text({ ...session.findings.get(0)![0]!, size_m: 0.004 }), 'crack 0.4 cm');
  assert.equal(finding_text({ ...session.findings.get(0)![0]!, size_m: 2 }), 'crack 2.0 m');
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

// Machado, Oliveira and Fernandes (2009), severity 1; of linear red, green, blue.
const SEEN_BY = {
  all: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanope: [
    0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998,
  ],
  deuteranope: [
    0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881,
  ],
  tritanope: [
    1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039,
  ],
} as const;

test('what is covered is told apart in each palette, by the colour blind too', () => {
  const style = readFileSync('page/page.css', 'utf8');
  const of = (name: string): Color[] =>
    [...style.matchAll(new RegExp(`--${name}: (#[0-9a-f]{6})`, 'g'))].map((it) => new Color(it[1]));
  const [covered, not_covered] = [of('covered'), of('not-covered')];
  assert.deepEqual([covered.length, not_covered.length], [3, 3]);
  covered.forEach((light, palette) => {
    for (const [who, m] of Object.entries(SEEN_BY)) {
      const luminance = ({ r, g, b }: Color, shade: number): number => {
        const row = (i: number): number => shade * (m[i]! * r + m[i + 1]! * g + m[i + 2]! * b);
        return 0.2126 * row(0) + 0.7152 * row(3) + 0.0722 * row(6);
      };
      // The brighter one at its darkest, the darker one at its brightest; as WCAG has contrast.
      const contrast =
        (luminance(light, LEAST_SHADE) + 0.05) / (luminance(not_covered[palette]!, 1) + 0.05);
      assert.ok(contrast >= 3, `${contrast.toFixed(1)} in palette ${palette} for ${who}`);
    }
  });
});
