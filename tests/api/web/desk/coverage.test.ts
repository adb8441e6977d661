import { expect, test } from 'vitest';
import {
  level_index,
  read_coverages,
  time_index,
  value_at,
  type Column,
} from 'page/server/coverage';

const T = ['2025-03-14T06:00:00Z', '2025-03-14T07:00:00Z'];
const axis = (...values: (number | string)[]): { values: (number | string)[] } => ({ values });

function only(answer: unknown): Column {
  const columns = read_coverages(answer);
  expect(columns.length).toBe(1);
  return columns[0] as Column;
}

test('AGridIsReadByTheNamesOfItsAxes', () => {
  const column = only({
    type: 'Coverage',
    domain: { axes: { t: axis(...T), x: axis(-2.55), y: axis(48.85), z: axis(0, 10, 20) } },
    ranges: {
      u: { shape: [2, 3, 1, 1], axisNames: ['t', 'z', 'y', 'x'], values: [1, 2, null, 4, 5, 6] },
      v: { shape: [3, 2], axisNames: ['z', 't'], values: [1, 4, 2, 5, 3, 6] },
    },
  });
  expect([0, 1, 2].map((level) => value_at(column, 'u', 0, level))).toEqual([1, 2, null]);
  expect([0, 1, 2].map((level) => value_at(column, 'v', 1, level))).toEqual([4, 5, 6]);
  expect(value_at(column, 'w', 0, 0)).toBeNull();
});

test('APointSeriesHasOneLevel', () => {
  const column = only({
    type: 'Coverage',
    domain: { axes: { t: axis(...T), x: axis(-2.55), y: axis(48.85) } },
    ranges: { hs: { shape: [2], axisNames: ['t'], values: [0.8, 0.9] } },
  });
  expect(column.levels_m).toEqual([0]);
  expect(value_at(column, 'hs', 1, 0)).toBe(0.9);
});

test('AGridOfPlacesGivesAColumnForEachThatHasValues', () => {
  const columns = read_coverages({
    type: 'Coverage',
    domain: { axes: { t: axis(T[0] ?? ''), x: axis(1, 2), y: axis(50, 51) } },
    ranges: {
      u: { shape: [1, 2, 2], axisNames: ['t', 'y', 'x'], values: [1, 2, 3, null] },
    },
  });
  expect(
    columns.map(({ longitude_deg, latitude_deg, values }) => [
      longitude_deg,
      latitude_deg,
      values.u?.[0],
    ]),
  ).toEqual([
    [1, 50, 1],
    [2, 50, 2],
    [1, 51, 3],
  ]);
});

test('ACollectionOfCoveragesIsReadWhole', () => {
  const coverage = (x: number): unknown => ({
    type: 'Coverage',
    domain: { axes: { t: axis(T[0] ?? ''), x: axis(x), y: axis(50) } },
    ranges: { u: { shape: [1], axisNames: ['t'], values: [x] } },
  });
  const columns = read_coverages({
    type: 'CoverageCollection',
    coverages: [coverage(1), coverage(2)],
  });
  expect(columns.map(({ longitude_deg }) => longitude_deg)).toEqual([1, 2]);
  expect(read_coverages({ type: 'CoverageCollection', coverages: [] })).toEqual([]);
});

const COLUMN: Column = {
  longitude_deg: 0,
  latitude_deg: 0,
  times_ms: T.map((text) => Date.parse(text)),
  levels_m: [0, 5, 10],
  values: {},
};

test('AnHourOutsideOfTheValuesHasNone', () => {
  const first = COLUMN.times_ms[0] ?? 0;
  expect(time_index(COLUMN, first)).toBe(0);
  expect(time_index(COLUMN, first + 35 * 60_000)).toBe(1);
  expect(time_index(COLUMN, first + 30 * 60_000)).toBe(1);
  expect(time_index(COLUMN, first - 3_600_000)).toBe(-1);
  expect(time_index(COLUMN, first + 3 * 3_600_000)).toBe(-1);
  expect(time_index(COLUMN, NaN)).toBe(-1);
});

test('BelowTheDeepestLevelThereIsNoWater', () => {
  expect(level_index(COLUMN, 6)).toBe(1);
  expect(level_index(COLUMN, 10)).toBe(2);
  expect(level_index(COLUMN, 25)).toBeNull();
});
