// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { decidePart } from 'page/decide/decide';
import { report, start, windows, windows_task } from './decide_made';
import { late_server, two_sites } from './late';

const of_site = (name: string): unknown =>
  windows([windows_task({ name: `Scour at ${name}`, starts: [start(6, 0.7)] })]);
const KEPT = {
  '/decisions': { decisions: [], record: { text: null } },
  '/verification': [],
  '/sources': { issued: '', day: '', sources: [] },
};
const turn = (): Promise<unknown> => new Promise((over) => setTimeout(over, 10));

test('WhatComesLateForOneSiteNeitherDrawsNorMovesTheHoursOfAnother', async () => {
  const kept: Record<string, unknown> = { ...KEPT, '/sites/b/windows': of_site('b') };
  const { desk, answer } = late_server(two_sites(), kept, { site: 'a' });
  const node = decidePart(desk);
  document.body.replaceChildren(node);
  const body = report({ no_plan: 'none' });
  await answer('/sites/a/report', body);
  desk.view.set({ site: 'b' });
  await answer('/sites/b/report', body);
  await turn();
  const starts = (): string => node.querySelector('.windows-section')?.textContent ?? '';
  expect(starts()).toContain('Scour at b');
  await answer('/sites/a/windows', of_site('a'));
  expect(starts()).toContain('Scour at b');
  // The line of the hour is still that of the drawing that is shown.
  desk.view.set({ at_ms: Date.parse('2025-03-14T09:00:00Z') });
  expect(node.querySelector('.starts .slider-hour')?.getAttribute('x1')).toBe('50.000%');
});

test('ALateRefusalOfOneSiteDoesNotAskAgainForAnother', async () => {
  const kept: Record<string, unknown> = { ...KEPT, '/windows': of_site('b') };
  const { desk, answer, waiting } = late_server(two_sites(), kept, { site: 'a' });
  decidePart(desk);
  desk.view.set({ site: 'b' });
  await answer('/sites/b/report', report({ no_plan: 'none' }));
  await answer('/sites/a/report', { title: 'x', detail: 'no' }, 500);
  const real = desk.server.now_ms();
  Object.assign(desk.server, { now_ms: () => real + 120_000 }); // two minutes later
  desk.view.tell(new Set(['sites']));
  await turn();
  expect(waiting.map(({ path }) => path)).toEqual([]);
});

test('TheReportIsAskedForOnceThoughTheBoardShowsItToo', async () => {
  const kept: Record<string, unknown> = { ...KEPT, '/windows': of_site('a') };
  const { desk, waiting } = late_server(two_sites(), kept, { site: 'a' });
  const node = decidePart(desk);
  document.body.replaceChildren(node);
  const details = node.querySelector('.board details') as HTMLDetailsElement;
  details.open = true;
  details.dispatchEvent(new Event('toggle'));
  await turn();
  expect(waiting.filter(({ path }) => path === '/sites/a/report').length).toBe(1);
});

test('EachSectionWithHoursNamesTheirClockOnce', () => {
  const { desk } = late_server(two_sites(), KEPT, { site: 'a' });
  const node = decidePart(desk);
  expect(node.querySelector('.days-section h2')?.textContent).toBe('Today and the next day, UTC');
  const zones = [...node.querySelectorAll('h2 .zone')].map((it) => it.textContent);
  expect(zones.filter((it) => it === ', UTC').length).toBe(6);
});
