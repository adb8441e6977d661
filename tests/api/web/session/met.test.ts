// What a line from an eye meets: what is drawn, by the name that people were shown.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  BoxGeometry,
  Euler,
  Group,
  Mesh,
  MeshBasicMaterial,
  Raycaster,
  Scene,
  Vector3,
  type Object3D,
} from 'three';
import { FarMarks } from 'page/scene/far_marks';
import { Foundations } from 'page/scene/foundations';
import { InspectedView } from 'page/scene/inspected_view';
import { Kept } from 'page/scene/kept';
import {
  give_names,
  met_along,
  name_of,
  set_all_about,
  that_can_be_pressed,
  that_hide,
} from 'page/scene/met';
import { vehicle_key, vehicle_shape, vessel_key, vessel_shape } from 'page/scene/shapes';
import { read_vessels } from 'page/session/around';
import { read_structures, read_vehicle } from 'page/session/message';
import { read_surface_mesh } from 'page/session/surface_mesh';
import { empty_session, tell } from 'page/session/state';

const WEST = new Vector3(-1, 0, 0);

/** From a place towards the west. */
function name_at(scene: Scene, x: number, y: number, z: number): string {
  scene.updateMatrixWorld(true);
  const met = met_along(that_hide(scene), new Vector3(x, y, z), WEST);
  return met === null ? 'nothing' : name_of(met);
}

test('each of many of one body has its own name', () => {
  const scene = new Scene();
  const lens = { eye: new Vector3(20, 0, 0), field_deg: 55, high_px: 400 };
  const foundations = new Foundations(scene);
  const size = { radius_m: 4, bottom_m: -30, top_m: 15 };
  // More than there is room for at first; one without a name; some near, some far.
  const told = Array.from({ length: 40 }, (_, nth) => {
    return { name: nth === 7 ? '' : `pile ${nth}`, east_m: 0, north_m: 100 * nth, ...size };
  });
  foundations.show(read_structures(told), lens);
  for (let nth = 0; nth < 40; nth += 1)
    assert.equal(name_at(scene, 50, 0, -100 * nth), nth === 7 ? '' : `pile ${nth}`);
  assert.equal(name_at(scene, 50, 0, -50), 'nothing');

  const marks = new FarMarks(scene);
  const mark = (names: string[]): void => {
    marks.begin();
    names.forEach((name, nth) =>
      marks.add('vessel', name, new Vector3(0, 0, 100 + 50 * nth), new Euler(), {
        long_m: 30,
        wide_m: 5,
      }),
    );
    marks.end();
  };
  mark(['Anna', 'Berta']);
  assert.deepEqual([name_at(scene, 50, 0, 100), name_at(scene, 50, 0, 150)], ['Anna', 'Berta']);
  mark(['Berta']);
  assert.deepEqual([name_at(scene, 50, 0, 100), name_at(scene, 50, 0, 150)], ['Berta', 'nothing']);
});

test('a surface has its name, from near and as a mark; what has none is nothing by name', () => {
  const scene = new Scene();
  const session = empty_session();
  const [surface, kind, patches] = [0, 'bed', 1];
  tell(session, {
    is: 'welcome',
    surfaces: [{ vehicle: 0, surface, name: 'plate', kind, patches, seen: 0 }],
  });
  const view = new InspectedView(scene);
  const corners = [0, -1, -1, 0, 1, -1, 0, 0, 1]; // upright, its face to the east
  const mesh = { name: 'plate', kind, corners, triangles: [0, 1, 2], patch_of: [0] };
  view.take([...session.surfaces.values()][0]!, read_surface_mesh(mesh)!);
  const tones = { covered: '#ffffff', not_covered: '#000000' };
  for (const away_m of [5, 5000]) {
    const lens = { eye: new Vector3(away_m, 0, 0), field_deg: 55, high_px: 400 };
    view.show(session, lens, tones);
    assert.equal(name_at(scene, 50, 0, 0), 'plate', `${away_m} m away`);
  }
  view.hide(session);
  assert.equal(name_at(scene, 50, 0, 0), 'nothing', 'it is not shown');

  const sea = new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial());
  sea.name = 'sea';
  scene.add(sea);
  assert.equal(name_at(scene, 50, 0, 0), '');
});

test('what is hidden is not met, nor are parts of it', () => {
  const scene = new Scene();
  const box = (x: number, name: string, of: Object3D): Mesh => {
    const made = new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial());
    made.position.x = x;
    give_names(made, [name]);
    of.add(made);
    return made;
  };
  const group = new Group();
  group.name = 'group';
  scene.add(group);
  const near = box(10, 'near', group);
  const far = box(0, 'far', scene);
  far.name = 'far';
  assert.equal(name_at(scene, 50, 0, 0), 'near');
  near.visible = false;
  assert.equal(name_at(scene, 50, 0, 0), 'far');
  near.visible = true;
  group.visible = false;
  assert.equal(name_at(scene, 50, 0, 0), 'far', 'its parent is hidden');
  // three itself would have met it.
  const ray = new Raycaster(new Vector3(50, 0, 0), WEST);
  assert.equal(ray.intersectObjects(scene.children)[0]!.object, near);

  // What is all about hides, and cannot be pressed, whatever else has its name.
  far.name = 'sky';
  assert.deepEqual(that_can_be_pressed(scene), [group, far]);
  set_all_about(far);
  assert.deepEqual(that_can_be_pressed(scene), [group]);
  assert.equal(name_at(scene, 50, 0, 0), 'far');
});

test('a shape is of its vehicle and of its vessel, not of another of the same number', () => {
  const scene = new Scene();
  const kept = new Kept(scene);
  const vehicle = { vehicle: 0, name: 'Anna', kind: 'rov', model: 'a', length_m: 1, width_m: 1 };
  const vessel = { mmsi: 211, name: 'Berta', east_m: 0, north_m: 0, length_m: 60 };
  const met = (of: object, other: object): string[] => {
    const now = read_vehicle({ ...vehicle, ...of })!;
    const [passing] = read_vessels([{ ...vessel, ...other }]);
    kept.of(vehicle_key(now), () => vehicle_shape(now));
    kept.of(vessel_key(passing!), () => vessel_shape(passing!)).position.set(0, 0, 100);
    kept.drop_the_rest();
    assert.equal(scene.children.length, 2, 'the old ones are gone');
    return [name_at(scene, 50, 0, 0), name_at(scene, 50, 0, 100)];
  };
  assert.deepEqual(met({}, {}), ['Anna', 'Berta']);
  const before = [...scene.children];
  assert.deepEqual(met({}, { east_m: 9 }), ['Anna', 'Berta']);
  assert.deepEqual(scene.children, before, 'they are the same');
  assert.deepEqual(met({ name: 'Clara' }, { name: 'Dora' }), ['Clara', 'Dora']);
  for (const [of, other] of [
    [{ length_m: 3 }, { length_m: 90 }],
    [{ width_m: 3 }, { mmsi: 212 }],
    [{ kind: 'auv' }, {}],
  ] as const) {
    const [, was] = [met({}, {}), [...scene.children]];
    met(of, other);
    assert.notEqual(scene.children[0], was[0]);
    if (Object.keys(other).length > 0) assert.ok(!was.includes(scene.children[1]!));
  }
});
