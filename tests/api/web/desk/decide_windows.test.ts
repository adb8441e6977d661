// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { Axis } from 'page/decide/axis';
import { windows_gantt } from 'page/decide/windows_gantt';
import { best_start, fill_of } from 'page/decide/windows_row';
import { answer, start, windows, windows_task } from './decide_made';

const T0 = Date.UTC(2025, 2, 14, 6);
const HOUR = 3_600_000;
const rows = (node: HTMLElement): SVGElement[] => [...node.querySelectorAll<SVGElement>('.starts')];
const press = (row: SVGElement | undefined, key: string): unknown =>
  row?.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));

test('TheClockIsTheZones', () => {
  const axis = new Axis(T0, T0 + 24 * HOUR);
  expect(axis.ticks('UTC').map(({ text }) => text)).toContain('09');
  expect(axis.ticks('Europe/Paris').map(({ text }) => text)[0]).toBe('09');
  expect(axis.x(T0 + 6 * HOUR)).toBe('25.000%');
  expect(axis.width(HOUR)).toBe('4.167%');
  expect(axis.holds(T0 - 1)).toBe(false);
});

test('TheFillGoesByTheRules', () => {
  const rules = { go: 0.9, marginal: 0.5, alpha: '' };
  expect([0.9, 0.899, 0.5, 0.49].map((worth) => fill_of(worth, rules))).toEqual([
    'go',
    'marginal',
    'marginal',
    'low',
  ]);
});

test('AColumnHasItsChanceAsHeightFillAndNumber', () => {
  const starts = [start(6, 0.95), start(7, 0.6), start(8, 0.02)];
  const { node } = windows_gantt(answer(windows([windows_task({ starts })])), 'UTC', () => {});
  const columns = [...node.querySelectorAll('.start')];
  expect(columns.map((it) => it.getAttribute('data-value'))).toEqual(['0.95', '0.6', '0.02']);
  expect(columns.map((it) => Number(it.getAttribute('height')))).toEqual([38, 24, 1]);
  expect(columns[1]?.getAttribute('fill')).toBe('url(#desk-hatch)');
  expect([...node.querySelectorAll('.number')].map((it) => it.textContent)).toEqual(['95', '60']);
});

test('KeysGoFromStartToStartAndSayThem', () => {
  const starts = [start(6, 0.2), start(7, 0.6), start(8, 0.3)];
  const shown: number[] = [];
  const task = windows_task({ starts, not_checked: ['rain'] });
  const { node } = windows_gantt(answer(windows([task])), 'Europe/Paris', (at) => shown.push(at));
  const row = rows(node)[0];
  expect(row?.getAttribute('aria-valuenow')).toBe('1');
  press(row, 'ArrowRight');
  expect(row?.getAttribute('aria-valuenow')).toBe('2');
  expect(row?.getAttribute('aria-valuetext')).toMatch(/^09:00: 30 %, interval 15 to 65/);
  press(row, 'End');
  expect(row?.getAttribute('aria-valuenow')).toBe('2');
  expect(node.querySelector('.start-detail')?.textContent).toContain('Not checkedrain');
  node.querySelector<HTMLButtonElement>('.start-detail button')?.click();
  expect(shown).toEqual([T0 + 2 * HOUR]);
  press(row, 'Escape');
  expect(node.querySelector('.start-detail')).toBeNull();
});

test('ARowWithoutAChanceSaysSo', () => {
  const tasks = [
    windows_task({ task: 'a', starts: [start(6, 0.02)], verdict: 'no-go' }),
    windows_task({ task: 'b', starts: [], verdict: 'no-go' }),
    windows_task({ task: 'c', name: 'Can', starts: [start(6, 0.7)], verdict: 'marginal' }),
  ];
  const { node } = windows_gantt(answer(windows(tasks)), 'UTC', () => {});
  expect([...node.querySelectorAll('.none')].map((it) => it.textContent)).toEqual([
    'the best start has 2 %',
    'no start',
  ]);
  expect(rows(node)[0]?.getAttribute('aria-label')).toBe('Starts of Can');
  press(rows(node)[2], 'ArrowRight');
  expect(node.querySelector('.start-detail')).toBeNull();
});

test('TheHourOfTheSliderIsMarkedWhereItIsInside', () => {
  const { node, at } = windows_gantt(
    answer(windows([windows_task({ starts: [start(6, 0.7)] })])),
    'UTC',
    () => {},
  );
  const line = node.querySelector('.starts .slider-hour');
  at(T0 + 3 * HOUR);
  expect([line?.getAttribute('x1'), line?.hasAttribute('hidden')]).toEqual(['50.000%', false]);
  at(T0 - HOUR);
  expect(line?.hasAttribute('hidden')).toBe(true);
});

test('AllLeftOutIsToldAndNothingIsDrawn', () => {
  const left_out = [{ task: 'scour', why: 'the sheet has no agent' }];
  const { node } = windows_gantt(
    answer(windows([], { left_out, notes: ['a note'] })),
    'UTC',
    () => {},
  );
  expect(node.textContent).toBe(
    'No task could be worked out.scour could not be worked out: the sheet has no agenta note',
  );
});

test('WhatCountsForLessThanItsChanceSaysSo', () => {
  const starts = [start(6, 0.95, { worth: 0.896 })];
  const { node } = windows_gantt(answer(windows([windows_task({ starts })])), 'UTC', () => {});
  expect(node.querySelector('.number')?.textContent).toBe('89');
  expect(rows(node)[0]?.getAttribute('aria-valuetext')).toContain('95 %, counts as 89 %');
  expect(node.textContent).toContain('Where flights succeed less often');
});

test('TheBestStartIsTheOneThatTheServerNames', () => {
  const starts = [start(6, 0.6), start(7, 0.6), start(8, 0.7, { forbidden: 'night' })];
  const of = (some: object): number => best_start(windows_task({ starts, ...some }));
  expect(of({ best: { start: start(7, 0).start } })).toBe(1);
  expect(of({ best: null })).toBe(-1);
  expect(of({})).toBe(2); // of a server that does not say
});

test('TheTableHasEachStart', () => {
  const starts = [start(6, 0.2), start(7, 0.6, { alpha: true })];
  const { node } = windows_gantt(answer(windows([windows_task({ starts })])), 'UTC', () => {});
  const details = node.querySelector('.as-table') as HTMLDetailsElement;
  details.open = true;
  details.dispatchEvent(new Event('toggle'));
  const cells = [...details.querySelectorAll('tbody tr')].map((it) =>
    [...it.children].map((cell) => cell.textContent),
  );
  expect(cells[1]).toEqual(['07:00', '60 %', '30 to 80\u00a0%', 'yes', 'yes', 'No limit is near.']);
  expect(cells[0]?.[4]).toBe('no answer');
});
