// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { change_text, plan_changes, task_changes } from 'page/what_if/compare';
import { result } from 'page/what_if/result';
import { answer, job, look, plan, start, windows, windows_task } from './decide_made';

const hour = (time: string): string => time.slice(11, 16);
const truth = windows([
  windows_task({ task: 'a', starts: [start(6, 0.4), start(7, 0.3)], verdict: 'no-go' }),
  windows_task({ task: 'b', starts: [] }),
]);
const other = windows([
  windows_task({ task: 'a', starts: [start(6, 0.4), start(7, 0.92)], verdict: 'go' }),
  windows_task({ task: 'b', starts: [] }),
  windows_task({ task: 'c', starts: [start(6, 0.5)] }),
]);

test('WhatChangedIsSaidInWords', () => {
  const texts = task_changes(truth, other).map((it) => [it.task, change_text(it, hour)]);
  expect(texts).toEqual([
    ['a', 'better by 52 points, best start 07:00'],
    ['b', 'the same'],
    ['c', 'only in the what-if'],
  ]);
  const back = task_changes(other, truth).map((it) => change_text(it, hour));
  expect(back).toEqual([
    'worse by 52 points, best start 06:00',
    'the same',
    'could not be worked out',
  ]);
});

test('JobsAreKeptMovedDroppedOrAdded', () => {
  const before = plan({
    jobs: [job({ job: 'a' }), job({ job: 'b' }), job({ job: 'c' }), job({ job: 'd' })],
  });
  const after = plan({
    jobs: [
      job({ job: 'a' }),
      job({ job: 'b', start: '2025-03-14T09:00:00Z' }),
      job({ job: 'c', crew: 'green' }),
      job({ job: 'e' }),
    ],
  });
  expect(plan_changes(before, after).map(({ job: name, change }) => name + ' ' + change)).toEqual([
    'a kept',
    'b moved',
    'c other team',
    'd dropped',
    'e added',
  ]);
});

test('BothAreShownSideBySide', () => {
  const body = { windows: other, plan: plan({ value: 2.5 }), no_plan: null };
  const node = result(
    answer(truth, '/w'),
    answer(plan(), '/p'),
    answer(body, '/x'),
    null,
    look,
    () => {},
  );
  const row = node.querySelector('tbody tr');
  expect([...(row?.children ?? [])].map((it) => it.textContent)).toEqual([
    'Scour survey',
    'No-go 40 % at 06:00',
    'Go 92 % at 07:00',
    'better by 52 points, best start 07:00',
  ]);
  const said = node.querySelector('[data-key="windows.tasks.0.starts.1.probability"]');
  expect(said?.getAttribute('data-value')).toBe('0.92');
  expect(node.textContent).toContain('Worth 2.50; now 1.78');
});

test('WithoutAPlanTheReasonIsTold', () => {
  const of = (no_plan: string | null): string =>
    result(
      answer(truth),
      null,
      answer({ windows: other, plan: null, no_plan }),
      ['a'],
      look,
      () => {},
    ).textContent ?? '';
  expect(of('no crew is left')).toContain('No plan: no crew is left');
  expect(of(null)).toContain('No plan: the site has none.');
});
