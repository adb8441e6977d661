// Ours and the products' at one hour, side by side as the server has them: nothing is subtracted.
import type { Look } from '../look/look';
import { element, scroll_region } from '../../look/element';
import { is_known, NOT_KNOWN } from '../look/units';
import { time_index, value_at, type Column } from '../server/coverage';
import { QUANTITIES, type Kind } from '../server/products';
import { what_it_is, type Compared, type Model } from './models';
import { beside_lines } from './models_beside';

/** "0.42 m/s to 120°"; with its own time where that is another. */
export function value_text(look: Look, kind: Kind, column: Column | null, at_ms: number): string {
  const time = column === null ? -1 : time_index(column, at_ms);
  if (column === null || time < 0) return 'no value at this hour';
  const { size, way, word } = QUANTITIES[kind];
  const much = value_at(column, size, time, 0);
  if (!is_known(much)) return 'no value at this hour';
  const said =
    kind === 'waves' ? look.metres(much, 1) : look.speed(much, kind === 'currents' ? 2 : 1);
  const direction = look.direction(value_at(column, way, time, 0));
  const at = column.times_ms[time] ?? at_ms;
  const is_same_day = look.day(at) === look.day(at_ms);
  const own_time = at === at_ms ? '' : `, at ${is_same_day ? look.hour(at) : look.time(at)}`;
  return `${said}${direction === NOT_KNOWN ? '' : ` ${word} ${direction}`}${own_time}`;
}

const ISO = /\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ/g;

/** Of what runs its hours are, as the server names them, and what else it says of it. */
export function model_words(look: Look, { letter, name, told, runs, notes }: Model): string {
  if (told.refused !== null) return `${letter}: ${name} says nothing here: ${told.refused}`;
  const said = [...(runs.length === 0 ? [] : [runs.join(', ')]), ...notes].join('; ');
  return `${letter}: ${said.replace(ISO, (text) => look.time(Date.parse(text)))}`;
}

export function models_table(
  look: Look,
  { kind, ours, models }: Compared,
  at_ms: number,
): HTMLElement {
  const heads = ['Model', 'It says', 'We say', 'It is'];
  const row = ({ letter, name, is_measured, level_m, told: { column } }: Model): HTMLElement => {
    const time = column === null ? -1 : time_index(column, at_ms);
    const height = kind === 'wind' && level_m !== null && !is_measured ? `, at ${level_m} m` : '';
    const beside = column === null || time < 0 ? [] : beside_lines(look, column, time);
    const cells: (string | Node)[][] = [
      [
        value_text(look, kind, column, at_ms),
        ...beside.map((line) => element('div', { class: 'note' }, line)),
      ],
      [value_text(look, kind, ours.get(level_m ?? 0)?.column ?? null, at_ms)],
      [column === null || time < 0 ? NOT_KNOWN : what_it_is(column, time, is_measured)],
    ];
    return element(
      'tr',
      {},
      element('th', { scope: 'row' }, `${letter}: ${name}${height}`),
      ...cells.map((parts) => element('td', {}, ...parts)),
    );
  };
  const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
  const table = element(
    'table',
    {},
    element('thead', {}, head),
    element('tbody', {}, ...models.map(row)),
  );
  return scroll_region(`${kind} of the models at the chosen hour`, table);
}
