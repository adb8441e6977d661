// What is inspected: patches by what is covered, findings and their names, in all palettes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Color, PerspectiveCamera, Scene, Vector3, type InstancedMesh, type Mesh } from 'three';
import { InspectedView, LEAST_SHADE } from 'page/scene/inspected_view';
import { ALL_LAYERS } from 'page/scene/layers';
import { finding_text, site_names } from 'page/scene/site_names';
import { site_in_words } from 'page/scene/site_words';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { empty_session, tell } from 'page/session/state';
import { surfaces_fetched } from 'page/panel/surfaces_fetched';
import type { Station } from 'page/station';
import { INSPECTED, SQUARE } from './inspected_for_tests';

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
