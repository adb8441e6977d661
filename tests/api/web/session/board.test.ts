// The board in the headset: where its buttons are, what is pressed on it, what it says when it is
// full.
import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { Quaternion, Vector3 } from 'three';
import { Board, button_boxes, HOLD_BOX } from 'page/xr/board';
import { near, put_globals } from './xr_for_tests';

let written: { text: string; y: number }[] = [];
let put_back = (): void => undefined;
beforeEach(() => {
  written = [];
  const context = {
    fillRect: () => undefined,
    measureText: (text: string) => ({ width: 12 * text.length }),
    fillText: (text: string, _x: number, y: number) => void written.push({ text, y }),
  };
  put_back = put_globals({
    document: { createElement: () => ({ getContext: () => context }), documentElement: {} },
    getComputedStyle: () => ({ getPropertyValue: () => '#000000' }),
  });
});
afterEach(() => put_back());

/** Its buttons, named, and which were pressed. */
function board_with(names: string[], has_hold = true): { board: Board; pressed: string[] } {
  const board = new Board();
  const pressed: string[] = [];
  const turned = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.3);
  board.follow({ at: new Vector3(0, 1.6, 0), turned });
  const buttons = names.map((text) => ({ text, press: () => void pressed.push(text) }));
  board.show([], has_hold ? () => void pressed.push('HOLD') : null, buttons);
  return { board, pressed };
}
/** Over the middle of a button, so far before the board. */
function tip_at(board: Board, text: string, before_m: number): Vector3 {
  const { at } = board.buttons().find((it) => it.text === text)!;
  return new Vector3(0, 0, before_m).applyQuaternion(board.mesh.quaternion).add(at);
}

test('a finger tip that comes through a button of the board presses it once', () => {
  const { board, pressed } = board_with(['Give back', 'Leave']);
  const tip = (before_m: number): Vector3 => tip_at(board, 'Give back', before_m);
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
});

test('it stays where it is until one has turned away from it, then it comes along', () => {
  const { board } = board_with([]);
  const from = new Vector3(0, 1.6, 0);
  const stood = board.mesh.position.clone();
  board.follow({ at: from, turned: new Quaternion() });
  near(board.mesh.position.distanceTo(stood), 0);
  board.follow({ at: from, turned: new Quaternion(0, 1, 0, 0) });
  assert.ok(board.mesh.position.distanceTo(stood) > 0.5);
});

test('a finger that the board comes to, or that comes back in it, presses nothing', () => {
  const { board, pressed } = board_with(['Leave']);
  const tip = (before_m: number): Vector3 => tip_at(board, 'Leave', before_m);
  board.touch('right', tip(0.005)); // the board came before it
  assert.deepEqual(pressed, []);
  board.touch('right', tip(0.1));
  board.lose('right');
  board.touch('right', tip(0.005));
  assert.deepEqual(pressed, []);
  board.touch('right', tip(0.1));
  board.touch('right', tip(0.005));
  assert.deepEqual(pressed, ['Leave']);
});

test('HOLD is alone in the lowest row, at one place, whatever else there is', () => {
  const high_px = 54;
  let places: Vector3[] = [];
  for (const many of [0, 3, 10]) {
    const names = Array.from({ length: many }, (_, nth) => `button ${nth}`);
    const { board, pressed } = board_with(names);
    places = [...places, board.buttons().find((it) => it.text === 'HOLD')!.at];
    const { width, height } = board.mesh.geometry.parameters;
    const px_per_m = 560 / width;
    assert.ok(HOLD_BOX.y + high_px <= height * px_per_m);
    near(HOLD_BOX.x + HOLD_BOX.wide / 2, 280); // all the width, but its edges
    assert.ok(HOLD_BOX.wide > 0.9 * 560);
    for (const box of button_boxes(many)) assert.ok(box.y >= 0 && box.y + high_px < HOLD_BOX.y);
    // Pressed over all its width, by who looks from before it.
    const eye = new Vector3(0, 1.6, 0);
    for (const along of [0.06, 0.3, 0.5, 0.7, 0.94]) {
      const up_m = height / 2 - (HOLD_BOX.y + high_px / 2) / px_per_m;
      const at = board.mesh.localToWorld(new Vector3((along - 0.5) * width, up_m, 0));
      board.press(eye, at.sub(eye).normalize());
    }
    assert.deepEqual(pressed, Array(5).fill('HOLD'), `${many} buttons`);
  }
  for (const it of places) near(it.distanceTo(places[0]!), 0);
});

test('where there is no HOLD its row stays empty', () => {
  const [with_it, without] = [board_with(['Leave']), board_with(['Leave'], false)];
  const at = (board: Board): Vector3 => board.buttons().find((it) => it.text === 'Leave')!.at;
  near(at(with_it.board).distanceTo(at(without.board)), 0);
  without.board.press(
    new Vector3(0, 1.6, 0),
    tip_at(with_it.board, 'HOLD', 0)
      .sub(new Vector3(0, 1.6, 0))
      .normalize(),
  );
  assert.deepEqual(without.pressed, []);
});

test('words that do not fit are cut with a sign, above the buttons', () => {
  for (const many of [0, 1, 5, 10]) {
    const { board } = board_with(Array.from({ length: many }, (_, nth) => `button ${nth}`));
    const lines = (count: number): { text: string; tone: '' }[] =>
      Array.from({ length: count }, (_, nth) => ({ text: `line ${nth}`, tone: '' }));
    const words = (count: number): string[] => {
      written = [];
      board.show(lines(count), null, []); // so that it is drawn anew
      written = [];
      const buttons = Array.from({ length: many }, () => ({ text: 'b', press: () => undefined }));
      board.show(lines(count), () => undefined, buttons);
      const lowest_px = button_boxes(many)[0]?.y ?? HOLD_BOX.y;
      const above = written.filter((it) => it.y < lowest_px);
      for (const it of above) assert.ok(it.y + 12 <= lowest_px, `${it.text} at ${it.y}`);
      return above.map((it) => it.text);
    };
    const all = words(40);
    assert.equal(all.at(-1), '…');
    const fit = all.length;
    assert.ok(fit >= 6, `${fit} lines`);
    assert.deepEqual(words(fit).at(-1), `line ${fit - 1}`);
    assert.deepEqual(words(fit + 1), [...lines(fit - 1).map((it) => it.text), '…']);
  }
});
