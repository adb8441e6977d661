// Where who wears a headset stands, and how they turn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { turn_of } from 'page/xr/reading';
import { Rig } from 'page/xr/rig';
import { near, near_place } from './xr_for_tests';

test('a turn is about the head, at any size', () => {
  for (const scale of [1, 500]) {
    const rig = new Rig();
    rig.take_head({ at: new Vector3(0.3, 1.6, -0.2), turned: new Quaternion() });
    rig.bring(rig.head.position, new Vector3(10, 20, 30), scale);
    const before = rig.looks_along();
    rig.turn(Math.PI / 6);
    near_place(rig.head_at(), 10, 20, 30);
    near(rig.looks_along().angleTo(before), Math.PI / 6, 1e-7);
    assert.ok(rig.looks_along().x > 0, 'to the right of north is east');
  }
});

test('who arrives looks from where the desk looked, seated or not, and stands on a landing', () => {
  for (const lift_m of [0, 0.45]) {
    const rig = new Rig();
    rig.lift_m = lift_m;
    const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.4);
    rig.take_head({ at: new Vector3(0.5, 1.2, 0.1), turned });
    rig.face(new Vector3(7, -8, 9), 1.1, turn_of(turned));
    near_place(rig.head_at(), 7, -8, 9);
    const along = rig.looks_along();
    near(Math.atan2(-along.x, -along.z), 1.1, 1e-7);
    rig.stand_at(new Vector3(1, -30, 2));
    near_place(rig.head_at(), 1, -30 + 1.2 + lift_m, 2);
  }
});
