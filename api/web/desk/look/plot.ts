// A plot in SVG, for what is drawn anew at each step of the slider: a few paths, coloured by the
// style sheet.
import { drawn, element } from '../../look/element';

export interface Scale {
  min: number;
  max: number;
  name: string;
  every: number; // from tick to tick
  is_down?: boolean; // grows downwards
}
export interface Plot {
  x: (value: number) => number;
  y: (value: number) => number;
  frame: SVGElement[];
}
export interface Picture {
  node: HTMLElement;
  draw: () => void;
  say: (words: string) => void;
}

export const MARGIN = { left: 56, right: 14, top: 10, bottom: 46 };

export function picture(
  name: string,
  height_px: number,
  content: (width_px: number) => SVGElement[],
): Picture {
  const svg = drawn('svg', { class: 'plot', role: 'img', 'aria-label': name });
  const node = element('div', { class: 'chart' }, svg);
  node.style.height = `${height_px}px`;
  const draw = (): void => {
    const width_px = node.clientWidth;
    if (width_px <= 2) return;
    svg.setAttribute('viewBox', `0 0 ${width_px} ${height_px}`); // so that paper may shrink it
    svg.replaceChildren(...content(width_px));
  };
  new ResizeObserver(draw).observe(node);
  return { node, draw, say: (words) => svg.setAttribute('aria-label', words) };
}

/** Axes with a grid; `x` and `y` turn values into pixels. */
export function plot(width: number, height: number, across: Scale, up: Scale): Plot {
  const [left, right] = [MARGIN.left, width - MARGIN.right];
  const [top, bottom] = [MARGIN.top, height - MARGIN.bottom];
  const share = ({ min, max }: Scale, value: number): number => (value - min) / (max - min);
  const x = (value: number): number => tenths(left + share(across, value) * (right - left));
  const y = (value: number): number => {
    const down = up.is_down === true ? share(up, value) : 1 - share(up, value);
    return tenths(top + down * (bottom - top));
  };
  const frame: SVGElement[] = [];
  for (const value of ticks(across)) {
    const kind = value === 0 ? 'grid zero' : 'grid';
    frame.push(drawn('path', { class: kind, d: `M${x(value)},${top} V${bottom}` }));
    frame.push(words(x(value), bottom + 17, number_text(value, across.every), 'middle'));
  }
  for (const value of ticks(up)) {
    const kind = value === 0 && up.is_down !== true ? 'grid zero' : 'grid';
    frame.push(drawn('path', { class: kind, d: `M${left},${y(value)} H${right}` }));
    frame.push(words(left - 8, y(value) + 4, number_text(value, up.every), 'end'));
  }
  frame.push(words((left + right) / 2, height - 8, across.name, 'middle quiet'));
  const middle = (top + bottom) / 2;
  const side = words(14, middle, up.name, 'middle quiet');
  side.setAttribute('transform', `rotate(-90 14 ${middle})`);
  frame.push(side);
  return { x, y, frame };
}

export function words(x: number, y: number, text: string, kind: string): SVGElement {
  return drawn('text', { x, y, class: kind }, text);
}

export function path_of(points: [number, number][]): string {
  return points.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${x},${y}`).join('');
}

function ticks({ min, max, every }: Scale): number[] {
  const first = Math.ceil(min / every - 1e-9);
  const count = Math.floor(max / every + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => (first + i) * every);
}

function number_text(value: number, every: number): string {
  if (value === 0) return '0';
  const places = Math.max(0, Math.ceil(-Math.log10(every) - 1e-9));
  const has_half = Math.abs(every * 10 ** places - Math.round(every * 10 ** places)) > 1e-6;
  return value.toFixed(places + (has_half ? 1 : 0)).replace('-', '−');
}

const tenths = (value: number): number => Math.round(value * 10) / 10;
