import { expect, test } from 'vitest';
import { HOUR_MS, hour_within, reach_of, time_ticks } from 'page/look/hours';
import { Look } from 'page/look/look';
import { hour_words, outside_words } from 'page/time/hour_words';
import { first_view, View } from 'page/view';
import { look } from './decide_made';

const FROM = Date.UTC(2025, 2, 13);
const REACH = { from_ms: FROM, to_ms: FROM + 72 * HOUR_MS };
const ISSUED = '2025-03-13T05:00:00Z';

test('TheSliderStaysWithinTheForecast', () => {
  expect(hour_within(REACH, FROM - 5 * HOUR_MS)).toBe(FROM);
  expect(hour_within(REACH, FROM + 500 * HOUR_MS)).toBe(REACH.to_ms);
  expect(hour_within(REACH, FROM + 5.4 * HOUR_MS)).toBe(FROM + 5 * HOUR_MS);
});

test('HoursCountFromTheStartOfTheForecastEvenAtAHalf', () => {
  const half = { from_ms: FROM + HOUR_MS / 2, to_ms: REACH.to_ms };
  expect(hour_within(half, FROM + 5 * HOUR_MS) % HOUR_MS).toBe(HOUR_MS / 2);
});

test('WithoutAForecastThereIsNoReach', () => {
  expect(reach_of(null)).toBeNull();
  const forecast = { instance: '', day: '', issued: '', age_s: 0, degraded: false, headline: '' };
  expect(reach_of({ ...forecast, valid_from: '', valid_to: '' })).toBeNull();
});

test('AnHourIsSaidFromNowAndFromTheIssue', () => {
  const now = Date.parse('2025-03-13T06:00:00Z');
  expect(hour_words(REACH, ISSUED, now, now)).toBe('now; 1 h after the issue');
  expect(hour_words(REACH, ISSUED, now + 24 * HOUR_MS, now)).toBe(
    '24 h from now; 25 h after the issue',
  );
  expect(hour_words(REACH, ISSUED, FROM, now)).toBe('6 h ago; 5 h before the issue');
});

test('AForecastThatEndedSaysSo', () => {
  const now = REACH.to_ms + 3 * HOUR_MS;
  expect(hour_words(REACH, ISSUED, REACH.to_ms, now)).toBe(
    'The forecast ended 3 h ago. Make a new one.',
  );
});

test('AnHourOutsideOfTheForecastIsNotShownInSilence', () => {
  const wanted = REACH.to_ms + 5 * HOUR_MS;
  expect(outside_words(REACH, wanted, look)).toBe(
    'The forecast does not reach Sun 16 Mar 05:00: this is the hour nearest to it.',
  );
  for (const inside of [null, FROM, REACH.to_ms]) {
    expect(outside_words(REACH, inside, look)).toBe('');
  }
});

test('AZonesNameHasNoUnderscores', () => {
  const far = new Look(new View({ ...first_view(), clock: 'site' }));
  far.site_zone = 'America/Port_of_Spain';
  expect(far.zone_name).toBe('America/Port of Spain');
});

test('DaysBeginAtMidnightOfTheZone', () => {
  const utc = time_ticks(REACH, 'UTC', 900).filter(({ is_day }) => is_day);
  expect(utc.map(({ text }) => text)).toEqual(['Thu 13', 'Fri 14', 'Sat 15', 'Sun 16']);
  const paris = time_ticks(REACH, 'Europe/Paris', 900).filter(({ is_day }) => is_day);
  expect(paris[0]?.at_ms).toBe(FROM + 23 * HOUR_MS);
});

test('WordsOfTicksDoNotLieOnOneAnother', () => {
  for (const width_px of [250, 360, 700, 1200]) {
    const ticks = time_ticks(REACH, 'UTC', width_px);
    const px = (at_ms: number): number => ((at_ms - FROM) / (72 * HOUR_MS)) * width_px;
    ticks.slice(1).forEach((tick, i) => {
      expect(px(tick.at_ms) - px(ticks[i]?.at_ms ?? 0)).toBeGreaterThan(27);
    });
  }
});
