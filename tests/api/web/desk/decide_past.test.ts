// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import type { Decision, Score } from 'page/decide/answers';
import { came_text, decisions_list } from 'page/decide/decisions_list';
import { hourly, lead_days, methods_of } from 'page/decide/scores';
import { yesterday } from 'page/decide/yesterday';
import { answer, look } from './decide_made';

function score(some: Partial<Score> = {}): Score {
  return {
    variable: 'sea_water_velocity',
    unit: 'm s-1',
    day: '2025-03-11',
    issued: '2025-03-12T05:00:00Z',
    origin: 'forecast',
    column: null,
    depth_m: [0, 100000],
    lead_h: [0, 24],
    method: 'forecast',
    truth: 'A_BUOY',
    rmse_m_s: 0.2,
    ...some,
  };
}
const before = { issued: '2025-03-11T05:00:00Z' };

test('OfEachDayOfLeadTheNewestForecastCounts', () => {
  const scores = [
    score({ ...before, rmse_m_s: 0.9 }),
    score(),
    score({ method: 'persistence', rmse_m_s: 0.4 }),
    score({ method: 'provider', rmse_m_s: 0.3 }),
    score({ depth_m: [0, 5], rmse_m_s: 9 }),
    score({ depth_m: null, height_above_bed_m: [0, 5], rmse_m_s: 9 }),
    score({ column: 0, rmse_m_s: 9 }),
    score({ origin: 'hindcast', issued: '2025-03-13T05:00:00Z', rmse_m_s: 9 }),
    score({ ...before, lead_h: [24, 48], rmse_m_s: 0.5 }),
  ];
  const days = lead_days(scores, 'sea_water_velocity');
  expect(days.map(({ lead_h, issued }) => [lead_h[0], issued])).toEqual([
    [0, '2025-03-12T05:00:00Z'],
    [24, '2025-03-11T05:00:00Z'],
  ]);
  expect(days[0]?.by_method.get('forecast')?.rmse).toBe(0.2);
  expect(methods_of(days)).toEqual(['forecast', 'provider', 'persistence']);
  const node = yesterday(answer(scores, '/sites/bay/verification'), look);
  expect(node.querySelector('[data-key="1.rmse_m_s"]')?.textContent).toBe('0.20 m/s');
  expect([...node.querySelectorAll('tbody th')].map((it) => it.textContent)).toEqual([
    'This forecast',
    "The provider's model",
    'The last value kept',
  ]);
});

test('HoursAreOfOneIssue', () => {
  const scores = [
    score({ lead_h: [1, 2] }),
    score({ lead_h: [0, 1] }),
    score({ ...before, lead_h: [0, 1] }),
    score({ lead_h: [2, 3], rmse_m_s: null }),
  ];
  const lines = hourly(scores, 'sea_water_velocity', '2025-03-12T05:00:00Z');
  expect(lines[0]?.points.map(({ lead_h }) => lead_h)).toEqual([1, 2]);
});

test('ARivalThatWasBetterIsTold', () => {
  const scores = [score(), score({ method: 'tide-phase', rmse_m_s: 0.1 })];
  expect(yesterday(answer(scores), look).querySelector('.better')?.textContent).toBe(
    '0.10 m/s (less than ours)',
  );
  const alike = [score(), score({ method: 'tide-phase', rmse_m_s: 0.1999 })];
  expect(yesterday(answer(alike), look).querySelector('.better')).toBeNull();
});

test('WavesHaveTheirErrorInMetres', () => {
  const { rmse_m_s: _, ...wave } = score({
    variable: 'sea_surface_wave_significant_height',
    unit: 'm',
    depth_m: null,
    rmse: 0.123,
  });
  expect(yesterday(answer([wave]), look).querySelector('[data-key="0.rmse"]')?.textContent).toBe(
    '0.12 m',
  );
});

test('WithoutScoresItIsSaid', () => {
  expect(yesterday(answer([]), look).textContent).toMatch(/^Nothing that was forecast lately/);
});

function decision(some: Partial<Decision> = {}): Decision {
  return {
    id: 1,
    task: 'scour',
    turbine: 'A01',
    start: '2025-03-10T07:30:00Z',
    decided: 'go',
    by: 'A. Name',
    recorded_at: '2025-03-09T16:00:00Z',
    late: false,
    counts: true,
    note: '<b>the client</b> waits',
    said: { probability: 0.139, verdict: 'no-go', why_nothing: null },
    came: { outcome: 'held', broken: null, broken_at: null, why: null, not_checked: [] },
    ...some,
  };
}

test('WhatCameIsInWords', () => {
  const came = (some: Partial<Decision['came']>, more: Partial<Decision> = {}): string => {
    const base = decision();
    return came_text({ ...base, ...more, came: { ...base.came, ...some } }, look);
  };
  expect(came({})).toBe('held');
  expect(came({ not_checked: ['rain'] }, { decided: 'no_go' })).toBe(
    'would have held (1 not checked)',
  );
  expect(came({ outcome: 'did_not_hold', broken: 'wind', broken_at: '2025-03-10T07:10:00Z' })).toBe(
    'did not hold: wind at Mon 10 Mar 07:10',
  );
  expect(came({ outcome: 'not_known_yet' })).toBe('not known yet');
  expect(came({ outcome: 'cannot_be_known', why: 'the sheet is gone' })).toBe(
    'cannot be known: the sheet is gone',
  );
});

test('ATextOfAPersonIsNeverReadAsHtml', () => {
  const body = { decisions: [decision()], record: { text: 'of 1 go 1 held' } };
  const node = decisions_list(answer(body), 'bay', look);
  expect(node.querySelector('b')).toBeNull();
  expect(node.textContent).toContain('<b>the client</b> waits');
  expect(node.textContent).toContain('The record: of 1 go 1 held.');
});

test('WithoutDecisionsTheCommandIsNamed', () => {
  const node = decisions_list(answer({ decisions: [], record: { text: null } }), 'bay', look);
  expect(node.textContent).toContain('slackwater decide --site bay');
});

test('ADecisionOfWhichNothingWasSaidHasTheReason', () => {
  const said = { probability: null, verdict: null, why_nothing: 'no sheet' };
  const body = {
    decisions: [decision({ said, counts: false, late: true })],
    record: { text: null },
  };
  const text = decisions_list(answer(body), 'bay', look).textContent ?? '';
  for (const part of ['no sheet', 'a later record counts', 'after the start']) {
    expect(text).toContain(part);
  }
});
