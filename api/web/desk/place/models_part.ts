// Models side by side: at the place our forecast and every stored product that reaches it.
import type { Desk } from '../look/desk';
import { element, set_hidden, set_text } from '../../look/element';
import { hour_of } from '../look/hours';
import { fetch_products, KINDS, reaches, type Kind, type Product } from '../server/products';
import { Refused } from '../server/server';
import type { Place } from '../view';
import { fetch_compared, type Compared } from './models';
import { models_series } from './models_series';
import { model_words, models_table } from './models_table';
import { series_chart } from './series_chart';

const NAMES: Record<Kind, string> = { currents: 'Current', wind: 'Wind', waves: 'Waves' };
const OF_THE_HOUR = ['at_ms', 'speed', 'directions', 'clock', 'sites'] as const;

export function modelsPart(desk: Desk): HTMLElement {
  const { view, server } = desk;
  const says = element('p', { role: 'status' });
  const boxes = new Map(KINDS.map((kind) => [kind, kind_box(desk, kind)]));
  const clear = (): void => boxes.forEach((box) => box.show(null));

  const load_kind = async (
    kind: Kind,
    products: Product[],
    place: Place,
    is_asked: () => boolean,
  ): Promise<void> => {
    const forecast = server.forecast(view.values.site);
    if (forecast === null) return;
    const { depth_m } = view.values;
    const came = await fetch_compared(server, kind, products, forecast, place, depth_m);
    if (is_asked()) boxes.get(kind)?.show(came);
  };
  let asked = 0;
  let of = ''; // what the numbers belong to
  const load = async (kinds: readonly Kind[] = KINDS): Promise<void> => {
    asked += 1;
    const mine = asked;
    const is_asked = (): boolean => mine === asked;
    const { site, place: chosen } = view.values;
    const now = JSON.stringify([site, chosen]);
    if (now !== of) {
      of = now;
      clear();
    }
    if (site === '') return;
    try {
      const place = chosen ?? (await server.site(site)).place;
      const products = await fetch_products(server);
      if (!is_asked()) return;
      const none = place === null || products.every((product) => !reaches(product, place));
      const has_hours = server.forecast(site) !== null;
      set_text(says, has_hours ? (none ? none_text(site) : '') : 'No forecast to compare with.');
      if (none || place === null || !has_hours) return clear();
      await Promise.all(kinds.map((kind) => load_kind(kind, products, place, is_asked)));
    } catch (problem) {
      if (!(problem instanceof Refused)) throw problem;
      if (!is_asked()) return;
      clear();
      set_text(says, problem.detail);
    }
  };
  desk.onChange((changed) => {
    const is_other = (['place', 'site', 'forecast'] as const).some((key) => changed.has(key));
    if (is_other || (changed.has('server') && server.link.is === 'there')) void load();
    else if (changed.has('depth_m')) void load(of_depth());
    else if (OF_THE_HOUR.some((key) => changed.has(key))) boxes.forEach((box) => box.show_hour());
  });
  // What is still under way for the other quantities is asked for again, at no cost to the server.
  const of_depth = (): readonly Kind[] =>
    KINDS.filter((kind) => kind === 'currents' || boxes.get(kind)?.is_empty() === true);
  void load();
  return element(
    'section',
    { class: 'models' },
    element('h3', {}, 'Models side by side'),
    says,
    ...[...boxes.values()].map(({ node }) => node),
  );
}

function none_text(site: string): string {
  return (
    'No product is stored that reaches this place. Choose one nearer to the site, or ingest ' +
    `products around it: slackwater forecast --site ${site} --print-downloads prints the lines ` +
    'that fetch them.'
  );
}

interface Box {
  node: HTMLElement;
  show: (compared: Compared | null) => void;
  show_hour: () => void;
  is_empty: () => boolean;
}

/** One quantity: the lines over time, the numbers at the slider's hour, and who says nothing. */
function kind_box(desk: Desk, kind: Kind): Box {
  let it: Compared | null = null;
  const head = element('h4');
  const chart = series_chart(desk, NAMES[kind], () =>
    it === null ? null : models_series(desk.look, it),
  );
  const table = element('div');
  const words = element('ul', { class: 'words' });
  const node = element('div', { hidden: true }, head, chart.node, chart.legend, table, words);

  const show_hour = (): void => {
    const at_ms = hour_of(desk);
    chart.mark(at_ms);
    if (it === null || at_ms === null) table.replaceChildren();
    else table.replaceChildren(models_table(desk.look, it, at_ms));
  };
  const show = (compared: Compared | null): void => {
    it = compared;
    set_hidden(node, it === null);
    if (it === null) {
      table.replaceChildren();
      words.replaceChildren();
      return;
    }
    const { level_m, models, ours } = it;
    const depth = kind === 'currents' ? ` at ${level_m ?? 0} m` : '';
    const height = kind === 'wind' && level_m !== null ? ` at ${level_m} m` : '';
    set_text(head, `${NAMES[kind]}${depth}${height}`);
    chart.say(`${head.textContent}: ours and ${models.length} more. The table has the numbers.`);
    const our = ours.get(level_m ?? 0)?.refused ?? null;
    const lines = [
      ...(our === null ? [] : [`Our forecast says nothing here: ${our}`]),
      ...models.map((model) => model_words(desk.look, model)),
    ];
    words.replaceChildren(...lines.map((line) => element('li', {}, line)));
    const is_drawn = models_series(desk.look, it) !== null;
    set_hidden(chart.node, !is_drawn);
    set_hidden(chart.legend, !is_drawn);
    chart.draw();
    show_hour();
  };
  return { node, show, show_hour, is_empty: () => it === null };
}
