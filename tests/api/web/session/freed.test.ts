// What was drawn for a headset, or by a key, is given back to the graphics card.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import {
  Line,
  Mesh,
  MeshBasicMaterial,
  Scene,
  SphereGeometry,
  Vector3,
  type Object3D,
} from 'three';
import { Kept } from 'page/scene/kept';
import { empty_session } from 'page/session/state';
import { HandModel } from 'page/xr/hand_models';
import { TableMarks } from 'page/xr/table_marks';
import { ThrowMark } from 'page/xr/throw_mark';
import { Vignette } from 'page/xr/vignette';
import { put_globals } from './xr_for_tests';

let put_back = (): void => undefined;
beforeEach(() => {
  put_back = put_globals({
    document: { documentElement: {} },
    getComputedStyle: () => ({ getPropertyValue: () => '#000000' }),
  });
});
afterEach(() => put_back());

/** Shapes and paints of a thing and its parts, as many as are not freed yet. */
function held_by(thing: Object3D): () => number {
  const left = new Set<unknown>();
  thing.traverse((part) => {
    if (!(part instanceof Mesh || part instanceof Line)) return;
    for (const it of [part.geometry, part.material].flat()) {
      left.add(it);
      it.addEventListener('dispose', () => left.delete(it));
    }
  });
  assert.ok(left.size > 1);
  return () => left.size;
}

test('hands, the frame about the view and the mark of a throw', () => {
  for (const made of [new HandModel(), new Vignette(), new ThrowMark()]) {
    const left = held_by(made.group);
    made.dispose();
    assert.equal(left(), 0, made.constructor.name);
  }
});

test('marks on the table, its sea and its bed', () => {
  const scene = new Scene();
  const marks = new TableMarks(scene);
  const session = empty_session();
  const pose = { vehicle: 1, east_m: 1, north_m: 2, up_m: -3, roll_rad: 0, pitch_rad: 0 };
  session.poses.set(1, { ...pose, heading_rad: 0 } as never);
  marks.show(session, 1, null, -30, new Vector3());
  const left = held_by(scene);
  marks.dispose();
  assert.deepEqual([left(), scene.children.length], [0, 0]);
});

test('what is kept by a key and no longer shown', () => {
  const scene = new Scene();
  const kept = new Kept(scene);
  kept.of('ball', () => new Mesh(new SphereGeometry(1, 4, 3), new MeshBasicMaterial()));
  kept.line('line', [new Vector3(), new Vector3(1, 0, 0)], '#ffffff');
  const left = held_by(scene);
  kept.drop_the_rest();
  assert.equal(left(), 4);
  kept.drop_the_rest();
  assert.deepEqual([left(), scene.children.length], [0, 0]);
});
