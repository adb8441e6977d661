import { expect, test } from 'vitest';
import { weather_at, type Field } from 'page/map/field';
import {
  fit,
  metres_per_px,
  place_at,
  projection_of,
  scale_bar,
  zoomed,
} from 'page/map/projection';
import { area_words, free_side } from 'page/map/scene';
import { beside_barbs_px } from 'page/map/arrows';
import type { Area } from 'page/server/answers';
import { look } from './decide_made';

const SIZE = { width: 600, height: 400 };
const CAMERA = { longitude_deg: -2.55, latitude_deg: 48.85, zoom: 12 };

test('WhatIsUnderThePointerStaysThereWhileOneZooms', () => {
  const before = place_at(CAMERA, SIZE, 100, 350);
  const after = place_at(zoomed(CAMERA, SIZE, 1.5, 100, 350), SIZE, 100, 350);
  expect(after.longitude_deg).toBeCloseTo(before.longitude_deg, 6);
  expect(after.latitude_deg).toBeCloseTo(before.latitude_deg, 6);
});

test('TheFirstLookHoldsAllOfTheSite', () => {
  const places = [
    { longitude_deg: -2.7, latitude_deg: 48.8 },
    { longitude_deg: -2.4, latitude_deg: 48.95 },
  ];
  const to = projection_of(fit(places, SIZE), SIZE);
  for (const { longitude_deg, latitude_deg } of places) {
    const [x, y] = to([longitude_deg, latitude_deg]) ?? [-1, -1];
    expect(x).toBeGreaterThan(20);
    expect(x).toBeLessThan(SIZE.width - 20);
    expect(y).toBeGreaterThan(20);
    expect(y).toBeLessThan(SIZE.height - 20);
  }
});

test('TheScaleBarIsRoundAndTrue', () => {
  const { px, text } = scale_bar(CAMERA, 120);
  expect(text).toBe('2 km');
  expect(px * metres_per_px(CAMERA)).toBeCloseTo(2000, 6);
  // Against the haversine of the two ends.
  const west = place_at(CAMERA, SIZE, 300 - px / 2, 200).longitude_deg;
  const east = place_at(CAMERA, SIZE, 300 + px / 2, 200).longitude_deg;
  const radians = Math.PI / 180;
  const half = Math.cos(48.85 * radians) * Math.sin(((east - west) / 2) * radians);
  expect(2 * 6_371_008.8 * Math.asin(half)).toBeCloseTo(2000, 1);
});

const T = [Date.UTC(2025, 2, 14, 6)];
const HERE = { longitude_deg: -2.55, latitude_deg: 48.85 };
const FIELD: Field = {
  refused: [],
  of: {
    currents: [
      {
        ...HERE,
        times_ms: T,
        levels_m: [0, 10],
        values: { sea_water_speed: [0.5, 0.3], sea_water_velocity_to_direction: [90, 100] },
      },
    ],
    wind: [],
    waves: [],
  },
};

test('AColumnShowsTheLevelNearestToTheDepth', () => {
  const at = T[0] ?? 0;
  const weather = weather_at(FIELD, HERE, at, 8);
  expect(weather).toMatchObject({ current_m_s: 0.3, current_to_deg: 100, current_depth_m: 10 });
  expect(weather.wind_m_s).toBeNull();
  expect(weather_at(FIELD, HERE, at, 30).current_m_s).toBeNull(); // below the bed
  expect(weather_at(FIELD, { ...HERE, latitude_deg: 48.9 }, at, 8).current_m_s).toBeNull();
  expect(weather_at(FIELD, HERE, NaN, 8).current_m_s).toBeNull();
});

test('AWaveArrowStandsFreeOfTheBarbs', () => {
  expect(beside_barbs_px(200, 230, false)).toBeGreaterThan(11); // barbs are on that side
  expect(beside_barbs_px(200, 190, false)).toBeLessThan(0);
  expect(beside_barbs_px(350, 10, true)).toBeGreaterThan(0);
  expect(beside_barbs_px(350, 170, false)).toBe(0);
  expect(beside_barbs_px(null, 170, false)).toBe(0);
});

test('AZoneSaysUpToWhichHeightAndWhenItWasNotInForce', () => {
  const area: Area = {
    id: 'airfield',
    kind: 'exclusion',
    reason: '',
    ring: [],
    in_force_now: true,
    below_height_m: 150,
    to_direction_deg: null,
  };
  const at = T[0] ?? 0;
  expect(area_words(area, look, at)).toBe('airfield: keep out below 150 m');
  const asleep = { ...area, below_height_m: null, in_force_now: false };
  expect(area_words(asleep, look, at)).toBe('airfield: keep out, not in force at 06:00 UTC');
});

test('WordsStandWhereNothingPoints', () => {
  const [up, right, down] = [0, 1, 2];
  expect(free_side([200, 240, 90])).toBe(up);
  expect(free_side([270, 300, null])).toBe(right);
  expect(free_side([350, 20, 80])).toBe(down);
  expect(free_side([null, null])).toBe(down);
});
