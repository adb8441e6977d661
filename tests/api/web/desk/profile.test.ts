import { expect, test } from 'vitest';
import { known_of } from 'page/place/hodograph_chart';
import { edges_of } from 'page/place/depth_time_chart';
import { largest_m_s, profile_at, runs } from 'page/place/profile';
import type { Column } from 'page/server/coverage';

const EAST = 'eastward_sea_water_velocity';
const NORTH = 'northward_sea_water_velocity';

// One hour; at 10 m the server has nothing, at 20 m no band.
const COLUMN: Column = {
  longitude_deg: -2.55,
  latitude_deg: 48.85,
  times_ms: [Date.UTC(2025, 2, 14, 6)],
  levels_m: [0, 10, 20],
  values: {
    sea_water_speed: [0.5, null, 0.2],
    sea_water_velocity_to_direction: [37, null, 180],
    [EAST]: [0.3, null, 0],
    [`${EAST}_p10`]: [0.1, null, null],
    [`${EAST}_p90`]: [0.6, null, null],
    [NORTH]: [0.4, null, -0.2],
    [`${NORTH}_p10`]: [0.2, null, null],
    [`${NORTH}_p90`]: [0.9, null, 0],
  },
};

test('AProfileIsWhatTheServerGave', () => {
  const [top, missing, deep] = profile_at(COLUMN, 0);
  expect(top).toEqual({
    depth_m: 0,
    speed_m_s: 0.5,
    to_deg: 37,
    east_m_s: 0.3,
    north_m_s: 0.4,
    east_band: [0.1, 0.6],
    north_band: [0.2, 0.9],
  });
  expect(missing).toMatchObject({ speed_m_s: null, east_m_s: null, east_band: null });
  expect(deep).toMatchObject({ to_deg: 180, east_m_s: 0, north_band: null });
});

test('AnHourWithoutValuesIsAProfileOfNulls', () => {
  expect(profile_at(COLUMN, -1).every(({ speed_m_s }) => speed_m_s === null)).toBe(true);
});

test('ALineIsNotBridgedOverAMissingLevel', () => {
  const levels = profile_at(COLUMN, 0);
  const lines = runs(levels, ({ east_m_s }) => east_m_s !== null);
  expect(lines.map((line) => line.map(({ depth_m }) => depth_m))).toEqual([[0], [20]]);
  expect(runs([], () => true)).toEqual([]);
});

test('TheHodographHasOnlyKnownLevelsAndMarksTheNearest', () => {
  const { known, chosen } = known_of(profile_at(COLUMN, 0), 12);
  expect(known.map(({ depth_m }) => depth_m)).toEqual([0, 20]);
  expect(chosen?.depth_m).toBe(20);
  expect(known_of(profile_at(COLUMN, -1), 12)).toEqual({ known: [], chosen: null });
});

test('TheAxisHoldsTheBandsToo', () => {
  expect(largest_m_s(COLUMN)).toBe(0.9);
});

test('CellsOverDepthMeetHalfWayBetweenTheLevels', () => {
  expect(edges_of([0, 10, 20])).toEqual([0, 5, 15, 20]);
  expect(edges_of([10])).toEqual([10, 11]);
});
