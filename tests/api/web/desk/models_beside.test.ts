// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { fetch_compared, type Compared } from 'page/place/models';
import { beside_lines } from 'page/place/models_beside';
import { models_table } from 'page/place/models_table';
import type { Product } from 'page/server/products';
import { late_server, TIMES, two_sites } from './late';
import { look } from './decide_made';

const SWELL = 'sea_surface_primary_swell_wave';
const VALUES: Record<string, (number | null)[]> = {
  sea_surface_wave_significant_height: [1.5, 1.6],
  sea_surface_wave_from_direction: [250, 250],
  sea_surface_wind_wave_significant_height: [1.2, null],
  [`${SWELL}_significant_height`]: [0.9, 1],
  [`${SWELL}_mean_period`]: [9.5, null],
  [`${SWELL}_from_direction`]: [280, null],
  forecast_period: [0, 1],
};
const PRODUCT: Product = {
  id: 'waves-one',
  kind: 'waves',
  name: 'one',
  boxes: [[-3, 48, -2, 49]],
  levels: null,
  parameters: Object.keys(VALUES),
};

async function compared(asked: string[] = []): Promise<Compared> {
  const ranges = Object.fromEntries(
    Object.entries(VALUES).map(([name, values]) => [
      name,
      { shape: [2], axisNames: ['t'], values },
    ]),
  );
  const answer = {
    type: 'Coverage',
    domain: { axes: { t: { values: TIMES }, x: { values: [-2.5] }, y: { values: [48.8] } } },
    ranges,
  };
  const sites = two_sites();
  const kept = {
    '/collections/waves/position': answer,
    '/collections/waves-one/position': answer,
  };
  const { desk } = late_server(sites, kept, { site: 'a' });
  const get = desk.server.get.bind(desk.server);
  desk.server.get = (path) => {
    asked.push(decodeURIComponent(path));
    return get(path);
  };
  const forecast = sites.sites[0]?.forecast;
  if (forecast == null) throw new Error('there is no forecast');
  const place = { longitude_deg: -2.5, latitude_deg: 48.8 };
  const came = await fetch_compared(desk.server, 'waves', [PRODUCT], forecast, place, 5);
  if (came === null) throw new Error('the product does not reach the place');
  return came;
}

test('WindSeaAndSwellStandApartAndWhatIsMissingIsLeftOut', async () => {
  const asked: string[] = [];
  const came = await compared(asked);
  const [at_6 = 0, at_7 = 0] = TIMES.map((time) => Date.parse(time));
  const cell = (at_ms: number): (string | null)[] =>
    [...(models_table(look, came, at_ms).querySelectorAll('tbody td')[0]?.children ?? [])].map(
      (line) => line.textContent,
    );
  expect(cell(at_6)).toEqual(['wind sea 1.2 m', 'swell 0.9 m from 280°, mean period 9.5 s']);
  expect(cell(at_7)).toEqual(['swell 1.0 m']);
  // Only what the product has is asked for, and never of ours.
  const of = (id: string): string => asked.find((path) => path.includes(`/${id}/`)) ?? '';
  expect(of('waves-one')).toContain(`${SWELL}_mean_period`);
  expect(of('waves-one')).not.toContain('secondary');
  expect(of('waves')).not.toContain('swell');
});

test('GustsAreInTheUnitThatIsRead', async () => {
  const came = await compared();
  const column = came.models[0]?.told.column;
  if (column == null) throw new Error('the product says nothing');
  column.values['wind_speed_of_gust'] = [10, null];
  expect(beside_lines(look, column, 0)[0]).toBe('gusts 10.0 m/s');
  expect(beside_lines(look, column, 1)).toEqual(['swell 1.0 m']);
});
