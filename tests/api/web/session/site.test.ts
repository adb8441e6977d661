// What a session tells of its site: the bed, what is laid in it, thrusters, what is inspected.
// Nonsense is left out and never thrown at.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bed_at, holes_in, level_beyond_m, read_bed } from 'page/session/bed';
import { read_turbines } from 'page/session/farm';
import { is_buried, length_m, read_cables, read_moorings } from 'page/session/laid';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { read_mounts, read_thrust, read_thrusts } from 'page/session/thrust';
import { empty_session, tell } from 'page/session/state';

const NONSENSE = [undefined, null, 7, 'bed', [], {}, [null], [{}], { up_m: 3 }, [[1, 2]]];

test('a bed is a whole grid or none', () => {
  const told = { east_m: -10, north_m: -20, step_m: 10, across: 2, up_m: [-1, -2, -3, null] };
  assert.deepEqual(read_bed(told)?.up_m, [-1, -2, -3, null]);
  for (const wrong of [
    { across: 3 },
    { across: 1.5 },
    { across: 1e9 },
    { across: 201, up_m: new Array<number>(201 * 201).fill(-1) },
    { step_m: 0 },
    { step_m: -1 },
    { east_m: null },
    { up_m: [null, null, null, null] },
    { up_m: 'deep' },
  ])
    assert.equal(read_bed({ ...told, ...wrong }), null, JSON.stringify(wrong));
  for (const one of NONSENSE) assert.equal(read_bed(one), null);
});

test('a plane of a bed is found again everywhere on its grid, and nowhere else', () => {
  const plane = (east_m: number, north_m: number): number => -30 + 0.02 * east_m - 0.05 * north_m;
  const up_m: number[] = [];
  for (let row = 0; row < 5; row += 1)
    for (let column = 0; column < 5; column += 1)
      up_m.push(plane(-100 + 50 * column, -100 + 50 * row));
  const bed = read_bed({ east_m: -100, north_m: -100, step_m: 50, across: 5, up_m })!;
  for (const [east_m, north_m] of [
    [0, 0],
    [-100, -100],
    [100, 100],
    [-33, 71],
    [99, -2],
  ] as const)
    assert.ok(Math.abs(bed_at(bed, east_m, north_m)! - plane(east_m, north_m)) < 1e-12);
  for (const [east_m, north_m] of [
    [-101, 0],
    [0, 101],
    [NaN, 0],
  ] as const)
    assert.equal(bed_at(bed, east_m, north_m), null);
});

test('where a corner is not known the triangles at it are holes', () => {
  const up_m = [-1, -1, -1, null];
  const bed = read_bed({ east_m: 0, north_m: 0, step_m: 1, across: 2, up_m })!;
  assert.equal(holes_in(bed), 1);
  assert.equal(bed_at(bed, 0.2, 0.2), -1); // of the three that are known
  assert.equal(bed_at(bed, 0.8, 0.8), null);
  assert.equal(level_beyond_m(bed), -1);
});

test('cables and moorings that lead nowhere are left out', () => {
  const cables = read_cables([
    {
      id: 'c1',
      route: [
        [0, 0, -30],
        [30, 40, -30],
      ],
      burial_m: 1.5,
    },
    { id: 'c2', route: [[0, 0, -30], ['x'], [3, 4, -30]], burial_m: null },
    { id: 'c3', route: [[0, 0, -30]] },
    {
      id: 'c4',
      route: [
        [0, 0, -30],
        [1, 0, -30],
      ],
      burial_m: 0,
    },
  ]);
  assert.deepEqual(
    cables.map((it) => [it.id, it.burial_m, is_buried(it), length_m(it.route)]),
    [
      ['c1', 1.5, true, 50],
      ['c2', null, false, 5],
      ['c4', 0, false, 1],
    ],
  );
  const moorings = read_moorings([
    { id: 'm1', fairlead: [0, 0, -10], anchor: [90, 0, -60] },
    { id: 'm2', fairlead: [0, 0, -10] },
    { id: 'm3', fairlead: [0, 0, null], anchor: [90, 0, -60] },
  ]);
  assert.deepEqual(
    moorings.map((it) => it.id),
    ['m1'],
  );
  for (const one of NONSENSE) assert.deepEqual([read_cables(one), read_moorings(one)], [[], []]);
});

test('thrusters are told all or none, and no share is above one', () => {
  const mount = { at: [0.1, 0.2, 0.3], axis: [0, 3, 4] };
  assert.deepEqual(read_mounts([mount]), [{ at: [0.1, 0.2, 0.3], axis: [0, 0.6, 0.8] }]);
  assert.deepEqual(read_mounts([mount, { at: [0, 0, 0], axis: [0, 0, 0] }]), []);
  assert.deepEqual(read_thrust({ vehicle: 3, share: [0.5, -7] }), { vehicle: 3, share: [0.5, -1] });
  for (const none of ['x', null, Number.NaN])
    assert.equal(read_thrust({ vehicle: 3, share: [0.5, none] }), null);
  for (const one of NONSENSE) assert.equal(read_thrust(one), null);
  const rows = [[3, 50, -700], [4, 'x'], ['x', 1], [5], 7];
  assert.deepEqual(read_thrusts(rows), [
    { vehicle: 3, share: [0.5, -1] },
    { vehicle: 5, share: [] },
  ]);
  for (const one of ['x', 7, null, {}]) assert.deepEqual(read_thrusts(one), []);
});

test('a curve rises with the wind, whatever its order', () => {
  const told = { hub_height_m: 90, rotor_diameter_m: 126, curve: [[9, 2], [3, 0], ['x', 1], [4]] };
  assert.deepEqual(read_turbines(told)?.curve, [
    { wind_m_s: 3, power_w: 0 },
    { wind_m_s: 9, power_w: 2 },
  ]);
});

test('a surface whose numbers point to nothing is none', () => {
  const told = {
    name: 'pile',
    kind: 'monopile',
    corners: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    triangles: [0, 1, 2],
    patch_of: [-1],
  };
  assert.equal(read_surface_mesh(told)?.triangles.length, 3);
  for (const wrong of [
    { corners: [0, 0, 0, 1, 0, 0, 0, 1] },
    { corners: [0, 0, 0, 1, 0, 0, 0, 1, null] },
    { triangles: [0, 1, 3] },
    { triangles: [0, 1, -1] },
    { triangles: [0, 1, 1.5] },
    { patch_of: [] },
    { patch_of: [0, 0] },
    { patch_of: [-2] },
  ])
    assert.equal(read_surface_mesh({ ...told, ...wrong }), null, JSON.stringify(wrong));
  for (const one of NONSENSE) assert.equal(read_surface_mesh(one), null);
});

const WELCOME = {
  is: 'welcome',
  vehicles: [{ vehicle: 0, name: 'rov', mounts: [{ at: [0, 0, 0], axis: [1, 0, 0] }] }],
  thrusts: [{ vehicle: 0, share: [0.25] }],
  surfaces: [
    { vehicle: 0, surface: 0, name: 'pile', kind: 'monopile', patches: 6, seen: 0.5, asked: 0.9 },
    { vehicle: 0, surface: 1, patches: 1e12 },
    { vehicle: 0, name: 'without a number' },
  ],
  covered: [
    {
      vehicle: 0,
      surface: 0,
      seen: 0.5,
      runs: [
        [0, 2],
        [5, 1],
      ],
    },
  ],
  findings: [
    { vehicle: 0, findings: [{ kind: 'crack', at: [1, 2, -3], size_m: 0.1, by: 'cam' }, {}] },
  ],
};

test('what is covered grows by what is told, and ends with the surface', () => {
  const session = empty_session();
  tell(session, WELCOME);
  assert.deepEqual([...session.surfaces.keys()], ['0 0']);
  const pile = session.surfaces.get('0 0')!;
  assert.deepEqual([...pile.covered], [1, 1, 0, 0, 0, 1]);
  const told = pile.told;
  assert.equal(
    tell(session, {
      is: 'covered',
      vehicle: 0,
      surface: 0,
      seen: 0.8,
      runs: [[3, 99], [-1, 9], ['x']],
    }),
    true,
  );
  assert.deepEqual([...pile.covered], [1, 1, 0, 1, 1, 1]);
  assert.equal(pile.seen, 0.8);
  assert.notEqual(pile.told, told);
  tell(session, { is: 'covered', vehicle: 9, surface: 0, runs: [[0, 1]] }); // not known here
});

test('findings of a vehicle are replaced by what it finds now, thrust by what it gives', () => {
  const session = empty_session();
  tell(session, WELCOME);
  assert.deepEqual(session.findings.get(0), [
    { vehicle: 0, kind: 'crack', at: { east_m: 1, north_m: 2, up_m: -3 }, size_m: 0.1, by: 'cam' },
  ]);
  assert.deepEqual(session.thrusts.get(0), [0.25]);
  tell(session, { is: 'findings', vehicle: 0, findings: [] });
  tell(session, { is: 'thrust', vehicle: 0, share: [-0.5] });
  assert.deepEqual([session.findings.get(0), session.thrusts.get(0)], [[], [-0.5]]);
  tell(session, {
    is: 'thrusts',
    thrusts: [
      [0, 75],
      [1, 'x'],
    ],
  });
  tell(session, { is: 'thrust', vehicle: 0, share: ['x'] });
  assert.deepEqual([...session.thrusts], [[0, [0.75]]], 'nonsense is no rest');
});

test('a recording, or an older server, tells nothing of it, and nothing is there', () => {
  const session = empty_session();
  tell(session, WELCOME);
  tell(session, { is: 'welcome', vehicles: [{ vehicle: 0 }] });
  assert.equal(session.bed, null);
  assert.deepEqual([session.cables, session.moorings], [[], []]);
  assert.deepEqual([session.thrusts.size, session.surfaces.size, session.findings.size], [0, 0, 0]);
  assert.deepEqual(session.vehicles.get(0)?.mounts, []);
});
