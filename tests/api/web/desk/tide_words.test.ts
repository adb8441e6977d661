import { expect, test } from 'vitest';
import { datum_words, tide_words } from 'page/place/facts';

const LAT = { name: 'LAT', below_mean_sea_level_m: 1.93, source: 'chart 2182B' };

test('TheTideIsToldOverBothLevelsAndBothAreSaid', () => {
  expect(tide_words(1.2, LAT)).toBe('+1.20 m over mean sea level, +3.13 m over chart datum (LAT)');
  expect(tide_words(-2.0, LAT)).toContain('−0.07 m over chart datum');
});

test('WhereNoChartDatumIsStatedNoneIsMadeUp', () => {
  expect(tide_words(1.2, null)).toBe('+1.20 m over mean sea level; the site states no chart datum');
  expect(datum_words(null)).toContain('states no chart datum');
});

test('BelowTheLinesStandsWhoSaysHowFarItIs', () => {
  expect(datum_words(LAT)).toBe(
    'Over mean sea level. Chart datum (LAT) is 1.93 m below it: chart 2182B.',
  );
});
