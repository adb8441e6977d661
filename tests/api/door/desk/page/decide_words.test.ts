import { expect, test } from 'vitest';
import { binding_text, chance_text, interval_text, past_text, with_hours } from 'page/decide/words';
import type { Binding, Past } from 'page/decide/answers';
import { start } from './decide_made';

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
  expect([0, 0.003, 0.096, 0.995, 0.998, 1].map(chance_text)).toEqual([
    'under 1 %',
    'under 1 %',
    '10 %',
    'over 99 %',
    'over 99 %',
    'over 99 %',
  ]);
  expect([null, undefined, NaN].map(chance_text)).toEqual(['–', '–', '–']);
  expect(interval_text([0.003, 0.386])).toBe('0 to 39\u00a0%');
  expect(interval_text(null)).toBe('');
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
  expect(binding_text(start(7, 0.5, { binding }), 'UTC')).toBe(
    'current at most 0.5 m/s (surveyor): exceeded at 07:10 in 12 of 25 futures; ' +
      'the forecast reaches 120 % of it.',
  );
  const near = { ...binding, exceeded: false, worker: null, share: null };
  expect(binding_text(start(7, 0.5, { binding: near }), 'UTC')).toBe('current at most 0.5 m/s.');
  expect(binding_text(start(7, 1), 'UTC')).toBe('No limit is near.');
  expect(binding_text(start(7, 1, { forbidden: 'the cable area' }), 'UTC')).toBe(
    'Closed: the cable area.',
  );
});

test('TimesInsideATextAreOfTheSite', () => {
  const text = 'exceeded at 2025-03-14T05:40:00Z in 3 futures';
  expect(with_hours(text, 'UTC')).toBe('exceeded at 05:40 in 3 futures');
  expect(with_hours(text, 'Europe/Paris')).toBe('exceeded at 06:40 in 3 futures');
});
