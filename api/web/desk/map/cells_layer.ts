// The layer of a product's cells: the choice of the product, its squares and arrows, the same as a
// table, and what is said in their place.
import type { GeoProjection } from 'd3-geo';
import type { Desk } from '../look/desk';
import { drawn, element, labelled, scroll_region, set_hidden, set_text } from '../../look/element';
import { hour_of } from '../look/hours';
import { value_at, type Column } from '../server/coverage';
import { fetch_products, level_of, QUANTITIES, type Kind, type Product } from '../server/products';
import { Refused } from '../server/server';
import { place_text } from '../look/units';
import { current_arrow, wave_arrow, wind_barb } from './arrows';
import { fetch_cells, MOST_CELLS, type Box, type Cells } from './cells';
import { screen } from './scene';

const WAIT_MS = 250; // for the next move of the map or of the slider
const KIND: Record<Kind, string> = { currents: 'Current', wind: 'Wind', waves: 'Waves' };

export interface CellsLayer {
  node: SVGGElement;
  choice: HTMLElement;
  says: HTMLElement;
  legend: HTMLElement;
  table: HTMLElement;
  /** Draws what is known, and asks for what is not. */
  draw: (to: GeoProjection, view: Box) => void;
  /** Reads the list of products anew. */
  load: () => Promise<void>;
}

interface Shown extends Cells {
  product: Product;
  box: Box;
  at_ms: number;
  asked_level_m: number | null;
}

export function cells_layer(desk: Desk, wait_ms = WAIT_MS): CellsLayer {
  const { view, server, look } = desk;
  let products: Product[] = [];
  let shown: Shown | null = null;
  let seen: { to: GeoProjection; box: Box } | null = null;
  let wanted = ''; // what is asked for, or waits to be
  let asked = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;

  let drawn_as = ''; // where the camera was, and which cells
  let drawings = 0;

  const [marks, arrows] = [drawn('g'), drawn('g')];
  const node = drawn('g', { class: 'cells' }, arrows, marks);
  const select = element('select');
  select.addEventListener('change', () => view.set({ cells: select.value }));
  const choice = labelled('Product cells', select);
  select.classList.add('narrow');
  const says = element('p', { class: 'cells-says', role: 'status', hidden: true });
  const legend = element('p', { class: 'check', hidden: true });
  const rows = element('tbody');
  const title = element('summary');
  const heads = ['Cell', 'Value', 'Direction'].map((text) => element('th', { scope: 'col' }, text));
  const head = element('thead', {}, element('tr', {}, ...heads));
  const table = element(
    'details',
    { class: 'columns', hidden: true },
    title,
    scroll_region('Cells as a table', element('table', {}, head, rows)),
  );
  table.addEventListener('toggle', () => show_table());

  const say = (words: string): void => {
    set_text(says, words);
    set_hidden(says, words === '');
  };
  const chosen = (): Product | null => products.find(({ id }) => id === view.values.cells) ?? null;
  const is_of_now = (of: Shown): boolean =>
    of.at_ms === hour_of(desk) && of.asked_level_m === level_of(of.product, view.values.depth_m);

  const show_table = (): void => {
    const is_there = shown !== null && shown.columns.length > 0 && is_of_now(shown);
    set_hidden(table, !is_there);
    if (shown === null || !is_there) return;
    set_text(title, `Cells as a table: ${words_of(shown.product, shown.level_m)}`);
    if (!table.open) return;
    const { kind } = shown.product;
    rows.replaceChildren(
      ...shown.columns.map((column) => {
        const [much, way] = texts_of(desk, kind, column);
        return element(
          'tr',
          {},
          element('th', { scope: 'row' }, place_text(column.longitude_deg, column.latitude_deg)),
          element('td', {}, much),
          element('td', {}, way),
        );
      }),
    );
  };
  const redraw = (): void => {
    const product = chosen();
    if (shown !== null && shown.product.id !== product?.id) shown = null;
    set_hidden(legend, product === null);
    if (product !== null) show_legend(legend, product);
    show_table();
    if (shown === null || seen === null) {
      for (const group of [marks, arrows]) group.replaceChildren();
      drawn_as = '';
      return;
    }
    const { to } = seen;
    const { columns } = shown;
    const { kind, name } = shown.product;
    const at = JSON.stringify([to.scale(), to.center(), to.translate(), drawings]);
    if (at !== drawn_as) {
      marks.replaceChildren(...columns.map((column) => cell_sign(screen(to, column), name)));
    }
    // An arrow of another hour is none; its square stays where it is.
    if (!is_of_now(shown)) arrows.replaceChildren();
    else if (at !== drawn_as || arrows.childElementCount === 0) {
      arrows.replaceChildren(
        ...columns.flatMap((column) => {
          const sign = arrow_of(kind, column);
          if (sign === null) return [];
          const words = `${name}\n${texts_of(desk, kind, column).join(' ')}`;
          const place = { transform: `translate(${screen(to, column)})` };
          return [drawn('g', place, sign, drawn('title', {}, words))];
        }),
      );
    }
    drawn_as = at;
  };
  const ask = async (product: Product, at_ms: number, box: Box): Promise<void> => {
    asked += 1;
    const mine = asked;
    const { depth_m } = view.values;
    try {
      const came = await fetch_cells(server, { product, at_ms, depth_m }, box);
      if (mine !== asked) return;
      drawings += 1;
      shown = { ...came, product, box, at_ms, asked_level_m: level_of(product, depth_m) };
      const at = came.columns[0]?.times_ms[0] ?? at_ms;
      const own_time =
        at === at_ms ? '' : `The product's own time is ${look.time(at)} ${look.zone_name}.`;
      say(came.refused ?? (came.too_many === null ? own_time : many_text(came.too_many)));
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (mine !== asked) return;
      say(problem.detail);
    }
    redraw();
  };
  const ask_for_what_is_seen = (): void => {
    const product = chosen();
    const at_ms = hour_of(desk);
    if (product === null || at_ms === null || seen === null) {
      clearTimeout(timer);
      asked += 1;
      wanted = '';
      say(product === null ? '' : 'No forecast is in force: there is no hour to show.');
      return;
    }
    const { box } = seen;
    const level_m = level_of(product, view.values.depth_m);
    const now = JSON.stringify([product.id, at_ms, level_m, box]);
    if (now === wanted) return;
    wanted = now;
    clearTimeout(timer);
    timer = setTimeout(() => void ask(product, at_ms, box), wait_ms);
  };
  const show_choice = (): void => {
    const { cells } = view.values;
    const options = products.map(({ id, kind, name }) =>
      element('option', { value: id }, `${KIND[kind]}: ${name}`),
    );
    const is_gone = cells !== '' && chosen() === null;
    if (is_gone) options.push(element('option', { value: cells }, 'Not in the store'));
    select.replaceChildren(element('option', { value: '' }, 'None'), ...options);
    select.value = cells;
    select.title = select.selectedOptions[0]?.text ?? '';
    set_hidden(choice, products.length === 0 && cells === '');
  };
  const load = async (): Promise<void> => {
    try {
      products = (await fetch_products(server)).filter((one) => !one.is_measured);
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      products = []; // what the server says of itself stands elsewhere
    }
    show_choice();
    ask_for_what_is_seen();
    redraw();
  };
  desk.onChange((changed) => {
    if (changed.has('cells')) show_choice();
    if (changed.has('server') || changed.has('forecast')) wanted = ''; // it may answer otherwise
    if (changed.has('server') && server.link.is === 'there' && products.length === 0) void load();
    if (changed.has('speed') || changed.has('directions')) drawings += 1; // other words
  });
  show_choice();
  const draw = (to: GeoProjection, box: Box): void => {
    seen = { to, box };
    ask_for_what_is_seen();
    redraw();
  };
  return { node, choice, says, legend, table, draw, load };
}

const many_text = (count: number): string =>
  `Zoom in to see the cells: there are about ${count} here, and ${MOST_CELLS} can be shown.`;

const words_of = ({ kind }: Product, level_m: number | null): string =>
  `${KIND[kind].toLowerCase()}${level_m === null ? '' : ` at ${level_m} m`}`;

function texts_of({ look }: Desk, kind: Kind, column: Column): [string, string] {
  const { size, way, word } = QUANTITIES[kind];
  const much = value_at(column, size, 0, 0);
  const said =
    kind === 'waves' ? look.metres(much, 1) : look.speed(much, kind === 'currents' ? 2 : 1);
  return [said, `${word} ${look.direction(value_at(column, way, 0, 0))}`];
}

const SMALLER = 'scale(0.65)'; // of barbs and of waves; a current's length is the map's own

function arrow_of(kind: Kind, column: Column): SVGElement | null {
  const { size, way } = QUANTITIES[kind];
  return sign_of(
    kind,
    value_at(column, size, 0, 0),
    value_at(column, way, 0, 0),
    column.latitude_deg < 0,
  );
}

function sign_of(
  kind: Kind,
  much: number | null,
  way_deg: number | null,
  is_south = false,
): SVGElement | null {
  const sign =
    kind === 'currents'
      ? current_arrow(much, way_deg)
      : kind === 'wind'
        ? wind_barb(much, way_deg, is_south)
        : wave_arrow(much, way_deg);
  if (sign === null || kind === 'currents') return sign;
  return drawn('g', { transform: SMALLER }, sign);
}

/** A square: the columns of our forecast are round. */
function cell_sign([x, y]: readonly [number, number], name: string): SVGElement {
  const square = { class: 'cell', x: x - 2.5, y: y - 2.5, width: 5, height: 5 };
  return drawn('rect', square, drawn('title', {}, name));
}

const LEGEND: Record<Kind, [number, number, string]> = {
  currents: [0.5, 90, 'to; as long as above'],
  wind: [7.7, 270, 'from; the staff stands to windward'],
  waves: [1, 270, 'from; longer is higher'],
};
const MIDDLE_PX: Record<Kind, number> = { currents: -19, wind: 12, waves: 13 };

function show_legend(legend: HTMLElement, { kind, name }: Product): void {
  const [much, way_deg, words] = LEGEND[kind];
  const sign = sign_of(kind, much, way_deg);
  const picture = drawn('svg', { class: 'sign', viewBox: '-22 -12 44 24', 'aria-hidden': 'true' });
  const inside = [...(sign === null ? [] : [sign]), cell_sign([0, 0], name)];
  picture.append(drawn('g', { transform: `translate(${MIDDLE_PX[kind]} 0)` }, ...inside));
  legend.replaceChildren(
    picture,
    element('span', { class: 'long' }, `Cell of ${name}: ${KIND[kind].toLowerCase()}, ${words}`),
  );
}
