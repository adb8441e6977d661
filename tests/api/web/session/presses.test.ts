// Which presses of a hand count: those that began while the page saw it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Presses } from 'page/xr/presses';
import { controller } from './xr_for_tests';

const OPENED = controller('right');
const PRESSED = controller('right', { is_pressed: true });

test('a press begins once, and is held until the hand opens', () => {
  const presses = new Presses();
  const told = [OPENED, PRESSED, PRESSED, OPENED, PRESSED].map((it) => {
    presses.look([it]);
    return `${presses.begins('right') ? 'begins' : ''} ${presses.is_held('right') ? 'held' : ''}`;
  });
  assert.deepEqual(told, [' ', 'begins held', ' held', ' ', 'begins held']);
  assert.equal(presses.is_held('left'), false);
});

test('a hand that comes closed, at first or after a loss, presses nothing before it opens', () => {
  for (const lose of [
    () => undefined,
    (it: Presses) => it.look([]),
    (it: Presses) => it.look([{ ...PRESSED, is_tracked: false }]),
    (it: Presses) => it.look([{ ...OPENED, is_tracked: false }]),
    (it: Presses) => it.lose_all(),
  ]) {
    const presses = new Presses();
    if (lose.length > 0) for (const it of [OPENED, PRESSED]) presses.look([it]);
    lose(presses);
    for (let i = 0; i < 3; i += 1) {
      assert.deepEqual([presses.begins('right'), presses.is_held('right')], [false, false]);
      presses.look([PRESSED]);
    }
    presses.look([OPENED]);
    presses.look([PRESSED]);
    assert.equal(presses.begins('right'), true);
  }
});
