// Where things are in the scene, by the formulae of frames; what the surface looks like is for
// tests/strangers/scene-drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';
import { at_place, turned } from 'page/scene/axes';
import { fading_per_m } from 'page/scene/air_and_water';
import { Eye } from 'page/scene/eye';
import { names_in, spread } from 'page/scene/labels';
import { camera_edges, ring } from 'page/scene/marks';
import { vehicle_shape } from 'page/scene/shapes';
import { read_vehicle } from 'page/session/message';
import { empty_session } from 'page/session/state';
import { pose_with as pose } from './pose_for_tests';

const near = (found: Vector3, expected: readonly number[], within = 1e-9): void => {
  const off = found.distanceTo(new Vector3(...expected));
  assert.ok(off < within, `${found.toArray().join(' ')} is not ${expected.join(' ')}`);
};

/** Body forward, right, down to the scene, by Rz(psi) Ry(theta) Rx(phi) to north, east, down. */
function body_to_scene(
  of: readonly number[],
  roll: number,
  pitch: number,
  heading: number,
): number[] {
  const [x = 0, y = 0, z = 0] = of;
  const [cr, sr, cp, sp] = [Math.cos(roll), Math.sin(roll), Math.cos(pitch), Math.sin(pitch)];
  const [ch, sh] = [Math.cos(heading), Math.sin(heading)];
  const [y1, z1] = [cr * y - sr * z, sr * y + cr * z];
  const [x2, z2] = [cp * x + sp * z1, -sp * x + cp * z1];
  const [north, east] = [ch * x2 - sh * y1, sh * x2 + ch * y1];
  return [east, -z2, -north];
}

test('a place is east, up and south', () => {
  near(at_place({ east_m: 3, north_m: 4, up_m: -5 }), [3, -5, -4]);
});

test('a vehicle is turned as its heading, pitch and roll say', () => {
  for (const [roll_rad, pitch_rad, heading_rad] of [
    [0, 0, 0],
    [0.3, 0, 0],
    [0, 0.4, 0],
    [0, 0, 1.2],
    [0.3, -0.7, 2.9],
    [-2.8, 0.2, -1],
  ] as const) {
    const euler = turned({ roll_rad, pitch_rad, heading_rad });
    // The shape's bow looks along -z, its starboard along x, its keel along -y.
    const axes = [
      [new Vector3(0, 0, -1), [1, 0, 0]],
      [new Vector3(1, 0, 0), [0, 1, 0]],
      [new Vector3(0, -1, 0), [0, 0, 1]],
    ] as const;
    for (const [of_shape, of_body] of axes)
      near(
        of_shape.clone().applyEuler(euler),
        body_to_scene(of_body, roll_rad, pitch_rad, heading_rad),
      );
  }
});

test('on board one looks where the camera is turned to', () => {
  const eye = new Eye();
  eye.stand = 'on_board';
  const rov = pose({ east_m: 10, north_m: 20, up_m: -5, heading_rad: Math.PI / 2 });
  eye.place(rov, { pan_deg: 90, tilt_deg: 0, zoom: 1 }, 0.5);
  near(eye.camera.getWorldDirection(new Vector3()), [0, 0, 1], 1e-9); // east and 90 more: south
  eye.place(rov, { pan_deg: 0, tilt_deg: 30, zoom: 1 }, 0.5);
  near(eye.camera.getWorldDirection(new Vector3()), [Math.sqrt(3) / 2, 0.5, 0], 1e-9);
  const wide_deg = eye.camera.fov;
  eye.place(rov, { pan_deg: 0, tilt_deg: 0, zoom: 4 }, 0.5);
  const half = (deg: number): number => Math.tan((deg * Math.PI) / 360);
  assert.ok(Math.abs(half(wide_deg) / half(eye.camera.fov) - 4) < 1e-9);
});

test('who follows keeps the vehicle in the middle, from above with north up', () => {
  const eye = new Eye();
  const rov = pose({ east_m: 100, north_m: -40, up_m: -7 });
  eye.place(rov, null, 1);
  near(at_place(rov).project(eye.camera).setZ(0), [0, 0, 0], 1e-6);
  eye.stand = 'above';
  eye.place(rov, null, 1);
  const north = at_place({ ...rov, north_m: -39 }).project(eye.camera);
  assert.ok(north.y > 0 && Math.abs(north.x) < 1e-6);
});

test('the edges of a camera are about where it looks, narrower as it is zoomed', () => {
  const rov = pose({ heading_rad: Math.PI / 2 });
  const middle = (zoom: number): Vector3 => {
    const edges = camera_edges(rov, { pan_deg: 0, tilt_deg: -90, zoom });
    const far = edges.filter((it) => it.length() > 1);
    return far.reduce((sum, it) => sum.addScaledVector(it, 1 / far.length), new Vector3());
  };
  const down = middle(1).normalize();
  assert.ok(down.y < -0.99, down.toArray().join(' '));
  const wide = (zoom: number): number => {
    const [, a, b] = camera_edges(rov, { pan_deg: 0, tilt_deg: 0, zoom });
    return a!.distanceTo(b!);
  };
  assert.ok(Math.abs(wide(1) / wide(3) - 3) < 1e-9);
});

test('a zone is a circle of its radius', () => {
  for (const at of ring({ east_m: 5, north_m: -2, up_m: -1 }, 30))
    assert.ok(Math.abs(at.distanceTo(new Vector3(5, -1, 2)) - 30) < 1e-9);
});

test('as far as somebody says, else as far as the renders take', () => {
  assert.equal(fading_per_m(null, true), 4.8 / 8);
  const weather = { visibility_m: 1000, water_visibility_m: 2 } as never;
  assert.equal(fading_per_m(weather, true), 2.4);
  assert.equal(fading_per_m(weather, false), 0.003);
});

test('vehicles and vessels have names, and who comes near says so', () => {
  const session = empty_session();
  const rov = read_vehicle({ vehicle: 1, name: 'rov', kind: 'rov', length_m: 1, width_m: 1 });
  assert.ok(rov !== null);
  session.vehicles.set(1, rov);
  session.poses.set(1, pose({ vehicle: 1, up_m: -7 }));
  const at = { east_m: 9, north_m: 8, course_deg: 0, speed_m_s: 4, length_m: null };
  session.vessels = [
    { mmsi: '1', name: 'COASTER', ...at },
    { mmsi: '2', name: 'TUG', ...at },
  ];
  const alarm = { vehicle: 1, with: 'TUG', level: 'close', cpa_m: 20, cpa_s: 60 };
  session.alarms.set('1 TUG', alarm);
  const said = names_in(session, 1, new Vector3(), []).map((it) => `${it.text} ${it.tone}`);
  assert.deepEqual(said, ['rov 7.0 m deep chosen', 'COASTER ', 'TUG: close alarm']);
});

test('every kind has a shape of its size', () => {
  for (const kind of ['uav', 'rov', 'auv', 'usv', 'crew_vessel']) {
    const vehicle = read_vehicle({ vehicle: 1, name: 'it', kind, length_m: 4, width_m: 4 });
    assert.ok(vehicle !== null);
    assert.ok(vehicle_shape(vehicle).children.length > 0, kind);
  }
});

test('names do not lie on each other, the first stays where it is', () => {
  const spots = [
    { right: 100, down: 50, wide: 80 },
    { right: 150, down: 55, wide: 80 },
    { right: 120, down: 60, wide: 80 },
    { right: 300, down: 50, wide: 80 },
  ];
  const found = spread(spots);
  assert.deepEqual(found[0], spots[0]);
  assert.deepEqual(found[3], spots[3]);
  for (const [i, a] of found.entries())
    for (const b of found.slice(i + 1))
      assert.ok(
        a.right + a.wide <= b.right ||
          b.right + b.wide <= a.right ||
          Math.abs(a.down - b.down) >= 24,
      );
  assert.equal(spread(Array.from({ length: 20 }, () => spots[0]!)).length, 20);
});
