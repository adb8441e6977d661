// The clock above a Gantt, its lines, and the hour that the slider stands at.
import { drawn, element } from '../../look/element';
import type { Axis } from './axis';

export function clock_above(axis: Axis, zone: string): HTMLElement {
  const ticks = axis.ticks(zone);
  const texts = ticks.map(({ at_ms, text }) => {
    const share = axis.share(at_ms);
    const anchor = share < 0.03 ? 'start' : share > 0.97 ? 'end' : 'middle';
    return drawn('text', { x: axis.x(at_ms), y: 13, 'text-anchor': anchor }, text);
  });
  const svg = drawn('svg', { class: 'clock', height: 18, width: '100%', 'aria-hidden': 'true' });
  svg.append(...texts);
  return element('div', { class: 'clock-line' }, svg);
}

export function tick_lines(axis: Axis, zone: string, height: number): SVGElement[] {
  return axis.ticks(zone).map(({ at_ms }) => {
    const x = axis.x(at_ms);
    return drawn('line', { class: 'tick', x1: x, x2: x, y1: 0, y2: height });
  });
}

export function hour_line(height: number): SVGLineElement {
  return drawn('line', { class: 'slider-hour', y1: 0, y2: height, hidden: true });
}

export function move_hour_line(line: SVGLineElement, axis: Axis, at_ms: number): void {
  line.toggleAttribute('hidden', !axis.holds(at_ms));
  line.setAttribute('x1', axis.x(at_ms));
  line.setAttribute('x2', axis.x(at_ms));
}

/** Fills that read in grey; they lie once in the page, for every drawing. */
export function hatches(): SVGSVGElement {
  const hatch = (id: string, path: string, size: number): SVGElement =>
    drawn(
      'pattern',
      { id, width: size, height: size, patternUnits: 'userSpaceOnUse' },
      drawn('rect', { class: 'under', width: size, height: size }),
      drawn('path', { class: 'over', d: path }),
    );
  return drawn(
    'svg',
    { class: 'hatches', width: 0, height: 0, 'aria-hidden': 'true' },
    drawn(
      'defs',
      {},
      hatch('desk-hatch', 'M-1,5 l6,-6 M-1,1 l2,-2 M3,5 l2,-2', 4),
      hatch('desk-dots', 'M1,1 h1.5 v1.5 h-1.5 z', 5),
    ),
  );
}
