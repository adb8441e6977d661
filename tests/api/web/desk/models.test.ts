// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import { fetch_compared, letter_of, type Compared } from 'page/place/models';
import { modelsPart } from 'page/place/models_part';
import { models_series } from 'page/place/models_series';
import { model_words, models_table } from 'page/place/models_table';
import { spread } from 'page/place/series_chart';
import { fetch_products, reaches, type Product } from 'page/server/products';
import type { LateServer } from './late';
import { late_server, site_answer, TIMES, two_sites } from './late';
import { look } from './decide_made';

const PLACE = { longitude_deg: -2.55, latitude_deg: 48.85 };
const collection = (id: string, kind: string, more: object = {}): object => ({
  id,
  title: `Currents of ${id}`,
  keywords: ['product', kind, 'X'],
  extent: {
    spatial: { bbox: [[-3, 48, -2, 49]] },
    vertical: { interval: [['0.0', '75.0']] },
  },
  parameter_names: {
    sea_water_speed: {},
    sea_water_velocity_to_direction: {},
    wind_speed: {},
    forecast_period: {},
  },
  ...more,
});

type Values = Record<string, (number | null)[]>;
const coverage = (values: Values, provenance: object = {}, times = TIMES): unknown => ({
  type: 'Coverage',
  domain: { axes: { t: { values: times }, x: { values: [-2.55] }, y: { values: [48.85] } } },
  ranges: Object.fromEntries(
    Object.entries(values).map(([name, all]) => [
      name,
      { shape: [times.length], axisNames: ['t'], values: all },
    ]),
  ),
  'slackwater:provenance': provenance,
});
const speeds = (...all: (number | null)[]): Values => ({
  sea_water_speed: all,
  sea_water_velocity_to_direction: all.map((value) => (value === null ? null : 120)),
});

const COLLECTIONS = {
  collections: [
    { id: 'currents', keywords: ['currents'], extent: {} },
    collection('one', 'currents'),
    collection('two', 'currents'),
    collection('far', 'currents', { extent: { spatial: { bbox: [[10, 50, 12, 52]] } } }),
  ],
};

function server_of(kept: Record<string, unknown>, values = {}): LateServer {
  return late_server(two_sites(), kept, { site: 'a', ...values });
}
const forecast = two_sites().sites[0]?.forecast;

async function compared(kept: Record<string, unknown>): Promise<Compared> {
  const { desk } = server_of({ ...kept, '/collections': COLLECTIONS });
  const products = await fetch_products(desk.server);
  if (forecast == null) throw new Error('there is no forecast');
  const came = await fetch_compared(desk.server, 'currents', products, forecast, PLACE, 5);
  if (came === null) throw new Error('no product reaches the place');
  return came;
}
const cells = (node: HTMLElement): (string | null)[][] =>
  [...node.querySelectorAll('tbody tr')].map((row) =>
    [...row.children].map((it) => it.textContent),
  );

test('ProductsAreKnownByWhatTheServerSaysOfThem', async () => {
  const { desk } = server_of({ '/collections': COLLECTIONS });
  const products = await fetch_products(desk.server);
  expect(products.map(({ id, kind, name }) => [id, kind, name])).toEqual([
    ['one', 'currents', 'one'],
    ['two', 'currents', 'two'],
    ['far', 'currents', 'far'],
  ]);
  expect(products[0]?.levels).toEqual({ least_m: 0, most_m: 75 });
  expect(products.map((one) => reaches(one, PLACE))).toEqual([true, true, false]);
});

test('AnExtentMayCrossTheDateLineAndNameItsLevels', () => {
  const of = (...boxes: Product['boxes']): Product => ({
    id: 'x',
    kind: 'wind',
    name: 'x',
    boxes,
    levels: null,
    parameters: [],
    is_measured: false,
    from_ms: 0,
    to_ms: 0,
  });
  const at = (longitude_deg: number): { longitude_deg: number; latitude_deg: number } => ({
    longitude_deg,
    latitude_deg: 0,
  });
  const across = of([170, -10, -170, 10]);
  expect([175, -175, 180, -180, 160, 0].map((x) => reaches(across, at(x)))).toEqual([
    ...[true, true, true, true, false, false],
  ]);
  expect(reaches(of([0, -10, 359.9, 10]), at(-2.5))).toBe(true);
  expect(reaches(of([-180, -90, 180, 90]), at(180))).toBe(true);
});

test('EachModelStandsBesideOurs', async () => {
  const came = await compared({
    '/collections/currents/position': coverage(speeds(0.1, 0.2)),
    '/collections/one/position': coverage(
      { ...speeds(0.3, 0.4), forecast_period: [0, 1] },
      { runs: ['analysis', 'forecast of 2025-03-13T06:00:00Z'], notes: ['means over 1 h'] },
    ),
    '/collections/two/position': coverage({ ...speeds(0.5), forecast_period: [null] }, {}, [
      '2025-03-13T06:00:00Z',
    ]),
  });
  const [at_6, at_7] = TIMES.map((time) => Date.parse(time));
  expect(cells(models_table(look, came, at_7 ?? 0))).toEqual([
    ['A: one', '0.40 m/s to 120°', '0.20 m/s to 120°', 'forecast, 1 h from its run'],
    ['B: two', 'no value at this hour', '0.20 m/s to 120°', '–'],
  ]);
  expect(cells(models_table(look, came, at_6 ?? 0)).map((row) => row[3])).toEqual([
    'analysis',
    'the files do not say of which run',
  ]);
  const words = came.models[0] === undefined ? '' : model_words(look, came.models[0]);
  expect(words).toBe('A: analysis, forecast of Thu 13 Mar 06:00; means over 1 h');
});

test('WhatSaysNothingIsListedWithTheServersReasonAndIsNoLine', async () => {
  const came = await compared({
    '/collections/currents/position': coverage(speeds(0.1, 0.2)),
    '/collections/one/position': coverage(speeds(null, null), { notes: ['on land'] }),
    '/collections/two/position': { type: 'CoverageCollection', coverages: [] },
  });
  expect(came.models.map(({ told }) => told.refused)).toEqual([
    'on land',
    'It has no value here in these hours.',
  ]);
  expect(models_series(look, came)?.lines.map(({ end }) => end)).toEqual(['ours']);
});

test('TheQuestionIsOfThePlaceTheDepthAndTheHoursOfTheForecast', async () => {
  const { desk, waiting } = server_of({ '/collections': COLLECTIONS });
  // '/collections' answers all that begin so, too: only the paths are of interest here.
  expect(waiting).toEqual([]);
  const paths: string[] = [];
  const get = desk.server.get.bind(desk.server);
  desk.server.get = (path) => {
    paths.push(decodeURIComponent(path).replaceAll('+', ' '));
    return get(path);
  };
  const products = await fetch_products(desk.server);
  if (forecast == null) throw new Error('there is no forecast');
  await fetch_compared(desk.server, 'currents', products, forecast, PLACE, 20);
  const asked = paths.filter((path) => path.includes('position'));
  expect(asked.map((path) => path.split('/')[2])).toEqual(['currents', 'one', 'two']);
  for (const path of asked) {
    expect(path).toContain('coords=POINT(-2.55 48.85)');
    expect(path).toContain(`datetime=${TIMES[0]}/${TIMES[1]}`);
    expect(path).toContain('z=20');
  }
  expect(await fetch_compared(desk.server, 'wind', products, forecast, PLACE, 20)).toBeNull();
});

test('NoTwoLinesAreToldApartByHueAlone', async () => {
  const kept = Object.fromEntries(
    Array.from({ length: 8 }, (_, i) => [`/collections/p${i}/position`, coverage(speeds(0.1, i))]),
  );
  const { desk } = server_of({
    ...kept,
    '/collections/currents/position': coverage(speeds(0.1, 0.2)),
    '/collections': {
      collections: Object.keys(kept).map((_, i) => collection(`p${i}`, 'currents')),
    },
  });
  const products = await fetch_products(desk.server);
  if (forecast == null) throw new Error('there is no forecast');
  const came = await fetch_compared(desk.server, 'currents', products, forecast, PLACE, 5);
  const lines = (came === null ? null : models_series(look, came))?.lines ?? [];
  expect(lines.length).toBe(9);
  expect(new Set(lines.map(({ end }) => end)).size).toBe(9);
  expect(new Set(lines.map(({ dash, sign }) => `${dash} ${sign}`)).size).toBe(9);
  expect([0, 25, 26].map(letter_of)).toEqual(['A', 'Z', 'A2']);
});

test('WordsAtTheEndsDoNotLieOnEachOther', () => {
  const apart = spread(
    [
      [500, 100],
      [500, 102],
      [500, 60],
      [300, 101],
    ],
    15,
  );
  expect(apart.map(([x]) => x)).toEqual([500, 500, 500, 300]);
  const [a = 0, b = 0, c, d] = apart.map(([, y]) => y);
  expect(b - a).toBeGreaterThanOrEqual(15);
  expect([c, d]).toEqual([60, 101]);
  expect((a + b) / 2).toBeCloseTo(101);
});

const part_of = (server: LateServer): HTMLElement => {
  const node = modelsPart(server.desk);
  document.body.replaceChildren(node);
  return node;
};

test('WhereNoProductReachesItIsSaidWhatToDo', async () => {
  const far = { collections: [collection('far', 'wind', { extent: {} })] };
  const node = part_of(server_of({ '/sites/a': site_answer('a'), '/collections': far }));
  await new Promise((over) => setTimeout(over, 20));
  expect(node.textContent).toContain('No product is stored that reaches this place.');
  expect(node.textContent).toContain('slackwater forecast --site a --print-downloads');
});

test('NeitherAnotherPlaceNorAnotherDepthShowsNumbersThatComeTooLate', async () => {
  const server = server_of(
    { '/sites/a': site_answer('a') },
    { depth_m: 5, place: { longitude_deg: -2.5, latitude_deg: 48.8 } },
  );
  const node = part_of(server);
  await server.answer('/collections', COLLECTIONS);
  server.desk.view.set({ depth_m: 20 });
  const of = (value: number): unknown => coverage({ ...speeds(value, value) });
  const late = server.waiting.filter(({ path }) => path.includes('z=5'));
  expect(late.length).toBe(3);
  await server.answer('z=20', of(0.22));
  expect(node.querySelector('h4')?.textContent).toBe('Current at 20 m');
  for (const question of late) await question.answer(of(0.55));
  expect(node.querySelector('h4')?.textContent).toBe('Current at 20 m');
  expect(node.querySelector('table')?.textContent).toContain('0.22 m/s');
  expect(node.querySelector('table')?.textContent).not.toContain('0.55');
  server.desk.view.set({ place: { longitude_deg: -2.6, latitude_deg: 48.8 } });
  expect(node.querySelector('table')).toBeNull();
  expect([...node.querySelectorAll('div')].find((box) => box.querySelector('h4'))?.hidden).toBe(
    true,
  );
});

const MOORING = {
  ...collection('instrument-currents-M1', 'currents', {
    title: 'Currents measured by M1',
    keywords: ['measured', 'currents', 'M1'],
  }),
};
const during = (from: string, to: string): object => ({
  ...MOORING,
  extent: {
    spatial: { bbox: [[-3, 48, -2, 49]] },
    temporal: { interval: [[from, to]] },
    vertical: { interval: [['4.2', '25.0']] },
  },
});

async function measured_beside(mooring: object): Promise<Compared | null> {
  const { desk } = server_of({
    '/collections/one/': coverage(speeds(0.5, 0.5)),
    '/collections/currents/': coverage(speeds(0.4, 0.4)),
    '/collections/instrument-currents-M1/': {
      ...(coverage(speeds(0.3, null), {
        runs: ['observation'],
        notes: ['values of good quality alone; not given: 1 that were rejected'],
        distance_m: 812,
      }) as object),
    },
    '/collections': { collections: [collection('one', 'currents'), mooring] },
  });
  if (forecast == null) throw new Error('there is no forecast');
  const products = await fetch_products(desk.server);
  return fetch_compared(desk.server, 'currents', products, forecast, PLACE, 5);
}

test('WhatWasMeasuredStandsBesideTheModelsWithItsDistanceAndItsGaps', async () => {
  const came = await measured_beside(during('2024-01-01T00:00:00Z', '2026-01-01T00:00:00Z'));
  if (came === null || forecast == null) throw new Error('nothing came');
  expect(came.models.map(({ name }) => name)).toEqual([
    'one',
    'measured by M1, 0.8 km away, at 0 m',
  ]);
  const at_ms = Date.parse(TIMES[0] ?? '');
  const [, row] = cells(models_table(look, came, at_ms));
  expect(row?.[1]).toContain('0.30 m/s');
  expect(row?.[3]).toBe('measured');
  const [, after] = cells(models_table(look, came, Date.parse(TIMES[1] ?? '')));
  expect(after?.[1]).toBe('no value at this hour');
  const lines = models_series(look, came)?.lines ?? [];
  expect(lines.map(({ sign }) => sign)).toEqual([undefined, 'circle', 'cross']);
  expect(model_words(look, came.models[1] as never)).toContain('rejected');
});

test('AMooringOfAnotherYearIsNotListedAsSilent', async () => {
  const came = await measured_beside(during('2012-01-01T00:00:00Z', '2013-01-01T00:00:00Z'));
  expect(came?.models.map(({ name }) => name)).toEqual(['one']);
});
