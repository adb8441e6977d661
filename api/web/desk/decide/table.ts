// Tables, and what is opened to be read.
import { element } from '../../look/element';

export function table_of(heads: readonly string[], rows: (Node | string)[][]): HTMLTableElement {
  return element(
    'table',
    {},
    element(
      'thead',
      {},
      element('tr', {}, ...heads.map((it) => element('th', { scope: 'col' }, it))),
    ),
    element(
      'tbody',
      {},
      ...rows.map((cells) =>
        element(
          'tr',
          {},
          ...cells.map((cell, i) =>
            i === 0 ? element('th', { scope: 'row' }, cell) : element('td', {}, cell),
          ),
        ),
      ),
    ),
  );
}

/** Something that is opened to be read; what is inside is made then. */
export function opened(summary: string, inside: () => Node): HTMLDetailsElement {
  const made = element('details', {}, element('summary', {}, summary));
  made.addEventListener('toggle', () => {
    if (made.open && made.childElementCount === 1) made.append(inside());
  });
  return made;
}
