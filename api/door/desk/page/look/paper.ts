// Paper is white and as wide as A4: the page is printed in the colours of the day, with its legend.
import { resize_charts } from './chart';
import { use_palette } from './colours';

const A4_PX = 670; // 210 mm less the margins of the style sheet

export function listen_to_printer(palette: () => string): void {
  let opened: HTMLDetailsElement[] = [];
  window.addEventListener('beforeprint', () => {
    use_palette('day');
    resize_charts(A4_PX);
    const legends = document.querySelectorAll<HTMLDetailsElement>('details.legend:not([open])');
    opened = [...legends];
    for (const legend of opened) legend.open = true;
  });
  window.addEventListener('afterprint', () => {
    use_palette(palette());
    resize_charts('auto');
    for (const legend of opened) legend.open = false;
  });
}
