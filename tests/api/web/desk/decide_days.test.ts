// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import type { Clock } from 'page/decide/clock';
import { days } from 'page/decide/days';
import { asked_again_ms } from 'page/decide/decide';
import { provenance } from 'page/decide/provenance';
import { trust_line } from 'page/decide/trust';
import { answer, best, look, report, report_task } from './decide_made';

const UTC: Clock = {
  zone: 'UTC',
  zone_name: 'UTC',
  now_ms: Date.parse('2025-03-13T06:00:00Z'),
};
const text = (node: HTMLElement): string => node.textContent ?? '';

test('EachNumberNamesWhereItStandsAndHasItUnrounded', () => {
  const body = report({
    tasks: [report_task()],
    today: { ...report({ tasks: [report_task({ best: best({ probability: 0.1234567 }) })] }) },
  });
  const node = days(answer(body), UTC, '');
  const said = [...node.querySelectorAll<HTMLElement>('[data-key]')];
  expect(said.length).toBeGreaterThan(8);
  // By their addresses alone, read as a person would: from the body, name after name.
  const there = new Map<string, unknown>();
  const walk = (value: unknown, key: string): void => {
    there.set(key, value);
    if (typeof value !== 'object' || value === null) return;
    for (const [name, of] of Object.entries(value)) walk(of, key === '' ? name : `${key}.${name}`);
  };
  walk(body, '');
  for (const { dataset } of said) {
    const value = there.get(dataset.key ?? '');
    expect(value, dataset.key).not.toBeUndefined();
    expect(dataset.value).toBe(typeof value === 'string' ? value : JSON.stringify(value));
    expect(dataset.from).toBe('/sites/bay/report');
  }
  const chance = node.querySelector('[data-key="today.tasks.0.best.probability"]');
  expect(chance?.textContent).toBe('12 %');
  expect(chance?.getAttribute('data-value')).toBe('0.1234567');
});

test('TodayComesBeforeTheNextDayAndTheBestTaskFirst', () => {
  const good = report_task({ task: 'b', name: 'Good', verdict: 'go' });
  const bad = report_task({ task: 'a', name: 'Bad', verdict: 'no-go', best: null });
  const body = report({ tasks: [bad, good], today: report({ tasks: [bad, good] }) });
  const node = days(answer(body), UTC, '');
  expect([...node.querySelectorAll('.day-head h3')].map((it) => it.textContent?.trim())).toEqual([
    'Today from 00:00 No-go',
    'Fri 14 Mar No-go',
  ]);
  expect([...node.querySelectorAll('h4')].map((it) => it.textContent)).toEqual([
    'Good at A01',
    'Bad at A01',
  ]);
  expect(text(node)).toContain('There is no start.');
});

test('OnTheDayItselfTheWholeDayIsTodayAndAStartThatPassedIsOver', () => {
  const now_ms = Date.parse('2025-03-14T07:00:00Z');
  const tasks = [
    report_task({ task: 'a', best: best({ start: '2025-03-14T06:30:00Z' }) }),
    report_task({ task: 'b', best: best({ start: '2025-03-14T09:30:00Z', worth: 0.2 }) }),
  ];
  const node = days(answer(report({ tasks })), { ...UTC, now_ms }, 'nothing of today');
  const heads = [...node.querySelectorAll('.day-head h3')].map((it) => it.textContent?.trim());
  expect(heads).toEqual(['Today, Fri 14 Mar No-go']);
  expect(text(node)).not.toContain('nothing of today');
  expect([...node.querySelectorAll('.first')].map((it) => it.textContent)).toEqual([
    'Today, Fri 14 Mar Marginal best 06:30 (over), 89 % (65 to 99\u00a0%)',
    'Today, Fri 14 Mar Marginal best 09:30, 89 %, counts as 20 % (65 to 99\u00a0%)',
  ]);
});

test('TheReportIsAskedForAgainWhenADayBeginsOrAStartPasses', () => {
  const at = (time: string): number => Date.parse(`2025-03-${time}:00Z`);
  const iso = (at_ms: number): string => new Date(at_ms).toISOString().slice(8, 16);
  const today = report({ from: '2025-03-13T06:30:00Z', to: '2025-03-14T00:00:00Z' });
  expect(iso(asked_again_ms(report({ today }), at('13T06:05')))).toBe('13T06:30');
  expect(iso(asked_again_ms(report(), at('13T22:50')))).toBe('14T00:00');
  expect(iso(asked_again_ms(report(), at('14T05:00')))).toBe('14T05:10');
  expect(iso(asked_again_ms(report(), at('15T05:00')))).toBe('16T00:00');
});

test('WestOfGreenwichTheDayIsStillTheReportsAndOtherHoursNameTheirs', () => {
  const clock = { ...UTC, zone: 'America/New_York', zone_name: 'America/New York' };
  const tasks = [report_task({ best: best({ start: '2025-03-14T01:30:00Z' }) })];
  const today = report({
    from: '2025-03-13T06:00:00Z',
    to: '2025-03-14T00:00:00Z',
    tasks: [report_task({ best: best({ start: '2025-03-13T12:30:00Z' }) })],
  });
  const node = days(answer(report({ tasks, today })), clock, '');
  const of = (where: string): (string | undefined)[] =>
    [...node.querySelectorAll(where)].map((it) => it.textContent?.trim());
  expect(of('.day-head h3')).toEqual(['Today from 02:00 No-go', 'Fri 14 Mar No-go']);
  expect(of('.span')).toEqual([
    'Thu 02:00 to Thu 20:00 America/New York',
    'Thu 20:00 to Fri 20:00 America/New York',
  ]);
  expect(of('.first')[0]).toMatch(/^Today Marginal best 08:30, /);
  expect(of('.first')[1]).toMatch(/^Fri 14 Mar Marginal best Thu 21:30, /);
  expect(of('.binds')[1]).toContain('exceeded at 01:40 in');
});

test('WithoutTasksOrTodayItIsSaid', () => {
  const node = days(answer(report()), UTC, 'No hours of today are left.');
  expect(text(node)).toContain('No hours of today are left.');
  expect(text(node)).toContain('The site names no tasks');
});

test('WhatWasLeftOutIsToldOnce', () => {
  const left_out = [{ task: 'blade', why: 'no sheet' }];
  const node = days(answer(report({ left_out, today: report({ left_out }) })), UTC, '');
  expect([...node.querySelectorAll('.left-out')].map((it) => it.textContent)).toEqual([
    'blade could not be worked out: no sheet',
  ]);
});

test('ATaskOfOneDayAloneIsShown', () => {
  const body = report({ tasks: [], today: report({ tasks: [report_task()] }) });
  expect(text(days(answer(body), UTC, ''))).toContain('Fri 14 Mar: nothing is said of it.');
});

test('WhatIsUncheckedAndWhatWouldHelpIsThere', () => {
  const would_help = {
    limits: [
      { without: 'a shift', worker: null, start: '2025-03-14T21:30:00Z', probability: 0.51 },
    ],
  };
  const task = report_task({ verdict: 'no-go', would_help, not_checked: ['visibility', 'rain'] });
  const node = days(answer(report({ tasks: [task] })), UTC, '');
  const details = node.querySelector('details') as HTMLDetailsElement;
  expect(details.querySelector('summary')?.textContent).toBe(
    '2 limits not checked; what would help',
  );
  expect(details.textContent).toContain('without the limit a shift it is 51 % at 21:30');
  expect(details.querySelectorAll('li').length).toBe(2);
});

test('TrustIsOneLineAVariable', () => {
  const trust = [
    {
      variable: 'current',
      unit: 'm/s',
      forecasts: 5,
      rmse: 0.185,
      outcome: 'tie' as const,
      best_rival: 'tide-phase',
      rival_rmse: 0.2047,
    },
    {
      variable: 'wave height',
      unit: 'm',
      forecasts: 1,
      rmse: 0.3,
      outcome: 'alone' as const,
      best_rival: null,
      rival_rmse: null,
    },
  ];
  const node = trust_line(answer(report({ trust })), look);
  expect([...node.querySelectorAll('p')].map((it) => it.textContent)).toEqual([
    'The current forecast of the last 5 days erred by 0.18 m/s; the best rival (tide-phase) ' +
      '0.20 m/s. A tie: the difference is within noise.',
    'The wave height forecast of the last day erred by 0.30 m; there is no simple method to ' +
      'compare with.',
  ]);
  expect(text(trust_line(answer(report()), look))).toBe('Nothing is verified yet.');
});

test('ProvenanceSaysWhyInputsAreNotKnown', () => {
  const node = provenance(answer(report()), null, 'the store holds nothing', look);
  expect(text(node)).toContain('Thu 13 Mar 05:00 UTC');
  expect(text(node)).toContain('the store holds nothing');
});
