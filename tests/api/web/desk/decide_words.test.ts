import { expect, test } from 'vitest';
import {
  binding_text,
  chance_text,
  interval_text,
  past_text,
  percent_of,
  with_hours,
} from 'page/decide/words';
import type { Binding, Past } from 'page/decide/answers';
import { start } from './decide_made';

const DAY = '2025-03-14';
const past = (some: Partial<Past>): Past => ({
  mornings: 38,
  said_by_futures: 0.28,
  held: 0.36,
  goes: 15,
  goes_held: 14,
  others_that_held: 2,
  ...some,
});

test('AChanceIsNeitherNothingNorCertain', () => {
  expect([0, 0.003, 0.096, 0.995, 0.998, 1].map((of) => chance_text(of))).toEqual([
    'under 1 %',
    'under 1 %',
    '10 %',
    'over 99 %',
    'over 99 %',
    'over 99 %',
  ]);
  expect([null, undefined, NaN].map((of) => chance_text(of))).toEqual(['–', '–', '–']);
  expect(interval_text([0.003, 0.386])).toBe('under 1 to 39\u00a0%');
  expect(interval_text([0.9, 0.999])).toBe('90 to over 99\u00a0%');
  expect(interval_text([1, 1])).toBe('over 99\u00a0%');
  expect(interval_text(null)).toBe('');
});

test('WhatMissesARuleNeverReadsAsIfItReachedIt', () => {
  expect([0.8999, 0.896, 0.895, 0.894, 0.9].map((of) => chance_text(of))).toEqual([
    '89 %',
    '89 %',
    '89 %',
    '89 %',
    '90 %',
  ]);
  expect([0.4999, 0.5, 0.896, 0.796].map((of) => percent_of(of))).toEqual([49, 50, 89, 80]);
  expect(percent_of(0.796, { go: 0.8, marginal: 0.5 })).toBe(79);
});

test('PastGoesAreToldAndTooFewAreCalledTooFew', () => {
  expect(past_text(past({}))).toBe(
    'Of past mornings: of 15 goes 14 held over 38 past mornings; ' +
      'on 2 other mornings the best start held.',
  );
  expect(past_text(past({ mornings: 4, goes: 0, others_that_held: 1 }))).toBe(
    'Too few to judge by: no start was a go over 4 past mornings; ' +
      'on 1 other morning the best start held.',
  );
  expect(past_text(past({ goes: 1, goes_held: 1, others_that_held: 0 }))).toMatch(
    /^Too few to judge by: of 1 go 1 held/,
  );
  for (const none of [null, past({ mornings: 0 })]) expect(past_text(none)).toMatch(/Nobody knows/);
});

test('WhatBindsIsToldInWords', () => {
  const binding: Binding = {
    limit: 'current at most 0.5 m/s',
    worker: 'surveyor',
    exceeded: true,
    futures: 12,
    time: '2025-03-14T07:10:00Z',
    share: 1.2,
    bound_then: null,
  };
  expect(binding_text(start(7, 0.5, { binding }), 'UTC', DAY)).toBe(
    'current at most 0.5 m/s (surveyor): exceeded at 07:10 in 12 of 25 futures; ' +
      'the forecast reaches 120 % of it.',
  );
  const near = { ...binding, exceeded: false, worker: null, share: null };
  expect(binding_text(start(7, 0.5, { binding: near }), 'UTC', DAY)).toBe(
    'current at most 0.5 m/s.',
  );
  expect(binding_text(start(7, 1), 'UTC', DAY)).toBe('No limit is near.');
  expect(binding_text(start(7, 1, { forbidden: 'the cable area' }), 'UTC', DAY)).toBe(
    'Closed: the cable area.',
  );
});

test('TimesInsideATextAreOfTheSite', () => {
  const text = 'exceeded at 2025-03-14T05:40:00Z in 3 futures';
  expect(with_hours(text, 'UTC', DAY)).toBe('exceeded at 05:40 in 3 futures');
  expect(with_hours(text, 'Europe/Paris', DAY)).toBe('exceeded at 06:40 in 3 futures');
  expect(with_hours(text, 'America/Los_Angeles', DAY)).toBe('exceeded at Thu 22:40 in 3 futures');
});
