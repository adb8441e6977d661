import { expect, test } from 'vitest';
import { nice_most, nice_step } from 'page/look/nice';
import * as units from 'page/look/units';

const AT = Date.UTC(2025, 2, 30, 0, 30); // half an hour before summer time in Paris

test('AKnotIs1852MetresAnHour', () => {
  expect(units.speed_text(1852 / 3600, 'knots')).toBe('1.0 kn');
  expect(units.speed_text(0.554, 'm/s', 2)).toBe('0.55 m/s');
  expect(units.speed_in(units.speed_in(1, 'knots'), 'm/s')).toBeCloseTo(1.94384, 5);
});

test('WhatIsMissingIsADashAndNeverZero', () => {
  expect(units.speed_text(null, 'knots')).toBe('–');
  expect(units.speed_text(NaN, 'm/s')).toBe('–');
  expect(units.direction_text(undefined, 'degrees')).toBe('–');
  expect(units.metres_text(null)).toBe('–');
  expect(units.time_text(NaN, 'UTC')).toBe('–');
});

test('DirectionsHaveThreeDigitsAndNever360', () => {
  expect(units.direction_text(7.2, 'degrees')).toBe('007°');
  expect(units.direction_text(359.7, 'degrees')).toBe('000°');
  expect(units.direction_text(-90, 'degrees')).toBe('270°');
});

test('TheCompassHasSixteenPoints', () => {
  expect(units.direction_text(0, 'compass')).toBe('N');
  expect(units.direction_text(11.2, 'compass')).toBe('N');
  expect(units.direction_text(11.3, 'compass')).toBe('NNE');
  expect(units.direction_text(202.7, 'compass')).toBe('SSW');
  expect(units.direction_text(349, 'compass')).toBe('N');
});

test('SiteTimeFollowsItsZoneOverTheChangeOfSummerTime', () => {
  expect(units.time_text(AT, 'UTC')).toBe('Sun 30 Mar 00:30');
  expect(units.time_text(AT, 'Europe/Paris')).toBe('Sun 30 Mar 01:30');
  expect(units.hour_text(AT + 3_600_000, 'Europe/Paris')).toBe('03:30');
});

test('ASpanIsSaidInTheUnitThatFits', () => {
  expect(units.span_text(50 * 60)).toBe('50 min');
  expect(units.span_text(3600)).toBe('1 h');
  expect(units.span_text(-5400)).toBe('1 h 30 min');
  expect(units.span_text(86400 * 3)).toBe('3 days');
});

test('APlaceNamesItsHemispheres', () => {
  expect(units.place_text(-2.55, 48.85)).toBe('48.8500 N 2.5500 W');
  expect(units.place_text(151.2, -33.9)).toBe('33.9000 S 151.2000 E');
});

test('AnAxisEndsAtARoundNumber', () => {
  expect([0.83, 1.01, 0.0012, 6.1, 0].map(nice_most)).toEqual([1, 1.5, 0.0015, 8, 1]);
  expect(nice_most(1)).toBe(1);
  expect([30, 3, 0.6].map((range) => nice_step(range, 7))).toEqual([5, 0.5, 0.1]);
});
