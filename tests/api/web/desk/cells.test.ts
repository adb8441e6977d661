// @vitest-environment happy-dom
import { beforeEach, expect, test } from 'vitest';
import { common, fetch_cells, MOST_CELLS, step_of, type Box } from 'page/map/cells';
import { cells_layer } from 'page/map/cells_layer';
import { projection_of } from 'page/map/projection';
import type { Kind, Product } from 'page/server/products';
import { Server } from 'page/server/server';
import { late_server, NOW, TIMES, two_sites, type LateServer } from './late';

let products = 0; // what is known of one is kept, so that each test has its own

const product = (kind: Kind = 'currents'): Product => ({
  id: `p${(products += 1)}`,
  kind,
  name: 'model',
  boxes: [[-6, 46, 0, 51]],
  levels: { least_m: 0, most_m: 75 },
  parameters: ['sea_water_speed', 'sea_water_velocity_to_direction'],
});
const AT = Date.parse(NOW);

/** The cells of a grid in a box, as the server answers; its middle where it has none there. */
function grid(query: string, step: number, speed: number | null = 0.3): unknown {
  const asked = new URLSearchParams(query.split('?')[1]);
  const [west = 0, south = 0, east = 0, north = 0] = (asked.get('bbox') ?? '')
    .split(',')
    .map(Number);
  const within = (least: number, most: number): number[] => {
    const first = Math.ceil(least / step - 1e-9);
    const count = Math.floor(most / step + 1e-9) - first + 1;
    return count < 1
      ? [(least + most) / 2]
      : Array.from({ length: count }, (_, i) => (first + i) * step);
  };
  const [x, y] = [within(west, east), within(south, north)];
  const range = (value: number | null): unknown => ({
    shape: [1, y.length, x.length],
    axisNames: ['t', 'y', 'x'],
    values: x.flatMap(() => y.map(() => value)),
  });
  return {
    type: 'Coverage',
    domain: {
      axes: { t: { values: [asked.get('datetime')] }, x: { values: x }, y: { values: y } },
    },
    ranges: { sea_water_speed: range(speed), sea_water_velocity_to_direction: range(speed && 90) },
  };
}

/** A server of one product on a regular grid; the boxes that were asked for are noted. */
function grid_server(step: number): { server: Server; boxes: Box[] } {
  const boxes: Box[] = [];
  const ask = async (path: string): Promise<Response> => {
    const [west = 0, south = 0, east = 0, north = 0] = (
      new URLSearchParams(path.split('?')[1]).get('bbox') ?? ''
    )
      .split(',')
      .map(Number);
    boxes.push({ west, south, east, north });
    return new Response(JSON.stringify(grid(path, step)));
  };
  const told = (): void => undefined;
  return { server: new Server(ask, told, () => 'a'), boxes };
}
const area = ({ west, south, east, north }: Box): number => (east - west) * (north - south);
const VIEW = { west: -2.7, south: 48.7, east: -2.4, north: 48.95 };

test('AllCellsInTheViewAreItsOwnAndNoMiddleOfABoxIsOne', async () => {
  const { server } = grid_server(0.027);
  const came = await fetch_cells(server, { product: product(), at_ms: AT, depth_m: 5 }, VIEW);
  expect(came.refused).toBeNull();
  const inside = came.columns.filter(
    (it) =>
      it.longitude_deg >= VIEW.west &&
      it.longitude_deg <= VIEW.east &&
      it.latitude_deg >= VIEW.south &&
      it.latitude_deg <= VIEW.north,
  );
  expect(inside.length).toBe(12 * 9); // by hand: 100 to 89 times 0.027 W, 1804 to 1812 times N
  for (const { longitude_deg } of came.columns) {
    expect(Math.abs(longitude_deg / 0.027 - Math.round(longitude_deg / 0.027))).toBeLessThan(1e-6);
  }
});

test('CloserThanItsCellsTheNearestCellsStillStandWhereTheyAre', async () => {
  const { server } = grid_server(0.25);
  const small = { west: -2.62, south: 48.81, east: -2.58, north: 48.84 };
  const came = await fetch_cells(server, { product: product(), at_ms: AT, depth_m: 5 }, small);
  expect(came.columns.map((it) => [it.longitude_deg, it.latitude_deg])).toEqual([
    ...[
      [-2.75, 48.75],
      [-2.5, 48.75],
      [-2.75, 49],
      [-2.5, 49],
    ],
  ]);
});

test('WhereThereAreTooManyNoneIsAskedFor', async () => {
  const { server, boxes } = grid_server(0.0125);
  const wide = { west: -5, south: 47, east: -1, north: 50 };
  const came = await fetch_cells(server, { product: product(), at_ms: AT, depth_m: 5 }, wide);
  expect(came.columns).toEqual([]);
  expect(came.too_many).toBeGreaterThan(320 * 240);
  const most = Math.max(...boxes.map((box) => area(box) / 0.0125 ** 2));
  expect(most).toBeLessThan(MOST_CELLS);
});

test('WhatTheViewAndTheProductHaveInCommon', () => {
  const one = product();
  expect(common(one, VIEW)).toEqual(VIEW);
  expect(common(one, { west: -10, south: 40, east: -5, north: 47 })).toEqual({
    ...{ west: -6, south: 46, east: -5, north: 47 },
  });
  expect(common(one, { west: 5, south: 40, east: 6, north: 47 })).toBeNull();
  const across = { west: 179, south: -1, east: -179, north: 1 };
  expect(common({ ...one, boxes: [[170, -10, -170, 10]] }, across)).toEqual(across);
  expect(step_of([3, 1, 1, 2.5])).toBeCloseTo(0.5);
  expect(step_of([7, 7])).toBeNull();
});

const COLLECTIONS = (id: string): unknown => ({
  collections: [
    {
      id,
      title: 'Currents of model',
      keywords: ['product', 'currents'],
      extent: { spatial: { bbox: [[-6, 46, 0, 51]] } },
      parameter_names: { sea_water_speed: {}, sea_water_velocity_to_direction: {} },
    },
  ],
});
const CAMERA = { longitude_deg: -2.55, latitude_deg: 48.85, zoom: 11 };
const to = projection_of(CAMERA, { width: 600, height: 500 });
const soon = (): Promise<void> => new Promise((over) => setTimeout(over, 15));

async function layer_of(values = {}): Promise<{
  layer: ReturnType<typeof cells_layer>;
  server: LateServer;
  give: (speed: number | null) => Promise<void>;
}> {
  const server = late_server(two_sites(), {}, { site: 'a', at_ms: AT, ...values });
  const layer = cells_layer(server.desk, 5);
  document.body.replaceChildren(layer.choice, layer.says, layer.legend, layer.table);
  const loading = layer.load();
  await server.answer('/collections', COLLECTIONS(`own-${(products += 1)}`));
  await loading;
  /** Answers until nobody asks: first how far cells are apart, then the cells. */
  const give = async (speed: number | null): Promise<void> => {
    await soon();
    while (server.waiting.length > 0) {
      const [first] = server.waiting;
      await first?.answer(grid(first.path, 0.1, speed));
    }
  };
  return { layer, server, give };
}
const words_of = (layer: { node: SVGElement }): string =>
  layer.node.querySelector('path.current ~ title')?.textContent ?? '';
const choose = (layer: { choice: HTMLElement }): void => {
  const select = layer.choice.querySelector('select');
  if (select === null) throw new Error('there is no choice');
  select.value = select.options[1]?.value ?? '';
  select.dispatchEvent(new Event('change'));
};

beforeEach(() => document.body.replaceChildren());

test('NothingIsAskedUntilAProductIsChosen', async () => {
  const { layer, server, give } = await layer_of();
  layer.draw(to, VIEW);
  await soon();
  expect(server.waiting).toEqual([]);
  expect([...(layer.choice.querySelector('select')?.options ?? [])].map((it) => it.text)).toEqual([
    'None',
    'Current: model',
  ]);
  choose(layer);
  layer.draw(to, VIEW);
  await give(0.3);
  expect(layer.node.querySelectorAll('rect.cell').length).toBeGreaterThan(8);
  const cells = layer.node.querySelectorAll('rect.cell').length;
  expect(layer.node.querySelectorAll('path.current').length).toBe(cells);
  expect(words_of(layer)).toBe('model\n0.30 m/s to 090°');
  server.desk.view.set({ speed: 'knots' });
  layer.draw(to, VIEW);
  expect(words_of(layer)).toBe('model\n0.58 kn to 090°');
  server.desk.view.set({ speed: 'm/s' });
  layer.draw(to, VIEW);
  expect(layer.legend.textContent).toContain('current, to');
  layer.table.setAttribute('open', '');
  layer.table.dispatchEvent(new Event('toggle'));
  expect(layer.table.querySelector('tbody tr')?.textContent).toContain('0.30 m/sto 090°');
  expect(layer.table.querySelectorAll('tbody tr').length).toBe(cells);
});

test('AnArrowOfAnotherHourOrDepthIsNotShown', async () => {
  const { layer, server, give } = await layer_of();
  choose(layer);
  layer.draw(to, VIEW);
  await give(0.3);
  for (const change of [{ at_ms: Date.parse(TIMES[1] ?? '') }, { depth_m: 20 }]) {
    server.desk.view.set(change);
    layer.draw(to, VIEW);
    expect(layer.node.querySelectorAll('rect.cell').length).toBeGreaterThan(8);
    expect(layer.node.querySelector('path.current')).toBeNull();
    expect(layer.table.hidden).toBe(true);
    await give(0.4);
    expect(words_of(layer)).toContain('0.40 m/s');
  }
});

test('WhatComesTooLateIsNotShownAndNothingIsAskedTwice', async () => {
  const { layer, server, give } = await layer_of();
  choose(layer);
  layer.draw(to, VIEW);
  await give(0.3);
  for (const depth_m of [20, 10]) {
    server.desk.view.set({ depth_m });
    layer.draw(to, VIEW);
    await soon();
  }
  expect(server.waiting.length).toBe(2);
  const [of_20, of_10] = [...server.waiting];
  await of_10?.answer(grid(of_10.path, 0.1, 0.1));
  await of_20?.answer(grid(of_20.path, 0.1, 0.2));
  expect(words_of(layer)).toContain('0.10 m/s');
  layer.draw(to, VIEW);
  await soon();
  expect(server.waiting).toEqual([]);
});

test('AServerThatIsBackIsAskedAgain', async () => {
  const { layer, server, give } = await layer_of();
  choose(layer);
  layer.draw(to, VIEW);
  await soon();
  while (server.waiting.length > 0) {
    await server.waiting[0]?.answer({ detail: 'the store is busy' }, 503);
  }
  expect(layer.says.textContent).toBe('the store is busy');
  layer.draw(to, VIEW);
  await soon();
  expect(server.waiting).toEqual([]);
  server.desk.view.tell(new Set(['server']));
  layer.draw(to, VIEW);
  await give(0.3);
  expect(layer.says.textContent).toBe('');
  expect(layer.node.querySelectorAll('rect.cell').length).toBeGreaterThan(8);
});

test('NoValueIsNoCell', async () => {
  const { layer, give } = await layer_of();
  choose(layer);
  layer.draw(to, VIEW);
  await give(null);
  expect(layer.node.querySelector('rect, path')).toBeNull();
  expect(layer.says.textContent).toContain('no value');
});

test('ZoomedOutItIsSaidToZoomIn', async () => {
  const { layer, give } = await layer_of();
  choose(layer);
  layer.draw(to, { west: -5.9, south: 46, east: -0.1, north: 50.9 });
  await give(0.3);
  expect(layer.says.textContent).toMatch(/^Zoom in to see the cells: there are about \d+ here/);
  expect(layer.node.querySelector('rect, path')).toBeNull();
});

test('AProductThatIsGoneIsNamedSo', async () => {
  const { layer } = await layer_of({ cells: 'of-a-link' });
  const select = layer.choice.querySelector('select');
  expect(select?.selectedOptions[0]?.text).toBe('Not in the store');
  layer.draw(to, VIEW);
  expect(layer.node.querySelector('rect, path')).toBeNull();
});
