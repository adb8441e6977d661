import { expect, test } from 'vitest';
import type { Look } from 'page/look/look';
import { slack_path, slack_text, type SlackAnswer } from 'page/place/slack';

const look = {
  speed: (m_s: number) => `${m_s} m/s`,
  time: (ms: number) => `day ${new Date(ms).toISOString().slice(11, 16)}`,
  hour: (ms: number) => new Date(ms).toISOString().slice(11, 16),
  zone_name: 'UTC',
} as unknown as Look;

const at = (hour: string): string => `2025-03-13T${hour}:00Z`;
const END = Date.parse(at('23:00'));
const one = (from: string, to: string, more = {}) => ({
  from: at(from),
  to: at(to),
  begins_before: false,
  ends_after: false,
  sure_from: null,
  sure_to: null,
  ...more,
});
const answer = (slack: SlackAnswer['slack'], why_none: string | null = null): SlackAnswer => ({
  depth_m: 20,
  below_m_s: 0.5,
  slack,
  why_none,
});

test('WhatIsOverIsNotTold', () => {
  const said = slack_text(
    look,
    answer([one('05:10', '06:00'), one('11:20', '12:40')]),
    Date.parse(at('07:00')),
    END,
  );
  expect(said).toBe('below 0.5 m/s, UTC: likely day 11:20 to 12:40 (at no time nearly sure)');
});

test('WhatIsLikelyIsNotToldAsSure', () => {
  const sure = { sure_from: at('11:45'), sure_to: at('12:10') };
  expect(slack_text(look, answer([one('11:20', '12:40', sure)]), 0, END)).toBe(
    'below 0.5 m/s, UTC: likely day 11:20 to 12:40 (nearly sure 11:45 to 12:10)',
  );
});

test('WhatTheForecastCutsHasNoTimeOfItsOwn', () => {
  const all = answer([one('00:00', '23:00', { begins_before: true, ends_after: true })]);
  expect(slack_text(look, all, Date.parse(at('07:00')), END)).toContain(
    'likely the beginning to the end (',
  );
});

test('NoneIsSaidAndWhyNothingIsKnown', () => {
  expect(slack_text(look, answer([]), 0, END)).toBe(
    'no likely slack (below 0.5 m/s) until day 23:00 UTC',
  );
  expect(slack_text(look, answer([], 'not known: means'), 0, END)).toBe('not known: means');
});

test('APlaceAndADepthAreAskedFor', () => {
  const path = slack_path('a b', { longitude_deg: -2.5, latitude_deg: 48.8 }, 20);
  expect(path).toBe('/sites/a%20b/slack?depth=20&longitude=-2.5&latitude=48.8');
});
