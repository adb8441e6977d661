// Paper is white and as wide as A4: the page is printed in the colours of the day, with its legend
// and with what no limit checks opened; and it says when it was printed.
import { resize_charts } from './chart';
import { use_palette } from './colours';
import { element, set_text } from '../../look/element';

const A4_PX = 670; // 210 mm less the margins of the style sheet

const CLOSED = ['.legend', '.task-cell details'].map((it) => `${it}:not([open])`).join();

/** @param now  what time it is, in words */
export function listen_to_printer(palette: () => string, now: () => string): void {
  let opened: HTMLDetailsElement[] = [];
  const printed = element('p', { id: 'printed' });
  document.body.append(printed);
  window.addEventListener('beforeprint', () => {
    use_palette('day');
    resize_charts(A4_PX);
    opened = [...document.querySelectorAll<HTMLDetailsElement>(CLOSED)];
    for (const details of opened) details.open = true;
    set_text(printed, `Printed ${now()}.`);
  });
  window.addEventListener('afterprint', () => {
    use_palette(palette());
    resize_charts('auto');
    for (const details of opened) details.open = false;
  });
}
