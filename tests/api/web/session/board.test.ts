// The board in the headset: what is pressed on it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { Board, button_boxes } from 'page/xr/board';
import { near } from './xr_for_tests';

test('a finger tip that comes through a button of the board presses it once', () => {
  const canvas = { getContext: () => null };
  Object.assign(globalThis, {
    document: { createElement: () => canvas, documentElement: {} },
    getComputedStyle: () => ({ getPropertyValue: () => '#000000' }),
  });
  const board = new Board();
  const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.3);
  board.follow({ at: new Vector3(0, 1.6, 0), turned });
  const pressed: string[] = [];
  const texts = ['HOLD', 'Give back', 'Leave'];
  board.show(
    [],
    texts.map((text) => ({ text, is_strong: false, press: () => pressed.push(text) })),
  );
  const box = button_boxes(3)[1]!;
  /** Over the middle of the second one, so far before the board. */
  const tip = (before_m: number): Vector3 => {
    const { width, height } = board.mesh.geometry.parameters;
    const [x, y] = [box.x + box.wide / 2, box.y + 27];
    const at = new Vector3((x / 560 - 0.5) * width, (0.5 - y / 700) * height, before_m);
    return board.mesh.localToWorld(at);
  };
  for (const before_m of [0.2, 0.02, 0.005, -0.005, 0.005, 0.03, 0.005])
    board.touch('right', tip(before_m));
  assert.deepEqual(pressed, ['Give back']);
  for (const before_m of [0.05, 0.005]) board.touch('right', tip(before_m));
  assert.deepEqual(pressed, ['Give back', 'Give back']);
  // A ray that meets it presses what it meets, one beside it nothing.
  const from = new Vector3(0, 1.6, 0);
  const ray = (to: Vector3): boolean => board.press(from, to.clone().sub(from).normalize());
  assert.equal(ray(tip(0)), true);
  assert.equal(pressed.length, 3);
  assert.equal(ray(tip(0).add(new Vector3(0, 3, 0))), false);
  // It stays where it is until one has turned away from it, then it comes along.
  const stood = board.mesh.position.clone();
  board.follow({ at: from, turned: new Quaternion() });
  near(board.mesh.position.distanceTo(stood), 0);
  board.follow({ at: from, turned: turned.clone().set(0, 1, 0, 0) });
  assert.ok(board.mesh.position.distanceTo(stood) > 0.5);
});
