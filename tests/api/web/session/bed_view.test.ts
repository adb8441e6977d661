// The bed as it is drawn and known: relief, holes, beyond the grid, and the cables that lie on it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { LineSegments, Raycaster, Scene, Vector3 } from 'three';
import type { Colours } from 'page/look/palette';
import { BedView, relief_of, shades_of } from 'page/scene/bed_view';
import { LaidView, laid_on } from 'page/scene/laid_view';
import { met_along } from 'page/scene/met';
import { pieces_near } from 'page/scene/strands';
import { bed_at, read_bed, type Bed } from 'page/session/bed';
import { empty_session } from 'page/session/state';
import { pose_with } from './pose_for_tests';

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
