// The legend: what each sign is, and whether a direction is meant "to" or "from".
import type { Desk } from '../look/desk';
import { drawn, element, set_hidden, set_text } from '../../look/element';
import type { Bed } from './bed';
import { current_arrow, wave_arrow, wind_barb } from './arrows';
import { vessel_sign, way_sign } from './vessel_signs';

const LEGEND_M_S = 0.5;
export type Layer = 'current' | 'wind' | 'waves' | 'vessels' | 'bed' | 'names';
export type Shown = Record<Layer, boolean>;

export function legend(
  desk: Desk,
  shown: Shown,
  on_change: () => void,
): {
  node: HTMLElement;
  say: (depth_m: number | null) => void;
  say_bed: (bed: Bed | string | null) => void;
} {
  const current = element('span');
  const bed = element('span');
  const source = element('p', { class: 'note', hidden: true });
  const rows: [Layer, SVGElement | null, HTMLElement][] = [
    ['current', current_arrow(LEGEND_M_S, 90), current],
    ['wind', wind_barb(7.7, 270), words('Wind at 10 m, from: the staff stands to windward')],
    ['waves', wave_arrow(1, 270), words('Waves, from: the arrow comes in; longer is higher')],
    ['bed', contour_sign(), bed],
    ['vessels', vessel_legend(), words('Vessels by AIS; the dashes are the way ahead, to')],
    ['names', null, words('Names and values')],
  ];
  const node = element('details', { class: 'legend' }, element('summary', {}, 'Legend'));
  for (const [layer, sign, text] of rows) {
    const box = element('input', { type: 'checkbox', checked: shown[layer] });
    box.addEventListener('change', () => {
      shown[layer] = box.checked;
      on_change();
    });
    node.append(element('label', { class: 'check' }, box, sign_of(sign, layer), text));
  }
  node.append(
    fixed(vessel_sign({ ...SHIP, state: 'old' }), 'Vessel whose last report is old, where it was'),
    fixed(vessel_sign({ ...SHIP, alarm: 'closing' }), 'Vessel that will pass or lies too near'),
    fixed(drawn('circle', { class: 'column', r: 4 }), 'Column of the forecast, with its bed depth'),
    fixed(turbine_sign(225), 'Turbine; the bar is the side of its boat landing'),
    fixed(port_sign(), 'Port of a vessel of the plan'),
    fixed(drawn('path', { class: 'cable', d: 'M-16,0 L16,0' }), 'Cable'),
    fixed(drawn('path', { class: 'area', d: 'M-15,-7 h30 v14 h-30 Z' }), 'Zone'),
    fixed(place_sign(), 'Chosen place'),
    source,
    element('p', { class: 'note' }, 'Coast: Natural Earth 1:50 million. Not for navigation.'),
    element(
      'p',
      { class: 'note' },
      'Keys on the map: arrows move, + and − zoom, 0 shows all, Enter takes the middle.',
    ),
  );
  const say = (depth_m: number | null): void => {
    const speed = desk.look.speed(LEGEND_M_S);
    set_text(
      current,
      depth_m === null
        ? `Current, to: the arrow goes with the water; this long is ${speed}`
        : `Current at ${depth_m} m, to: the arrow goes with the water; this long is ${speed}`,
    );
  };
  const say_bed = (of: Bed | string | null): void => {
    const is_there = of !== null && typeof of !== 'string';
    set_text(bed, is_there ? `Depth contours, m below ${of.datum}` : 'Depth contours');
    set_hidden(source, of === null);
    if (of === null) return;
    const { product, attribution } = is_there ? of : { product: '', attribution: '' };
    const by = attribution === '' ? '' : `, ${attribution}`;
    set_text(source, is_there ? `Depths: ${product}${by}` : `No depth contours: ${of}`);
  };
  say(null);
  say_bed(null);
  return { node, say, say_bed };
}

const SHIP = {
  state: 'fresh',
  class: 'A',
  alarm: null,
  heading_deg: 90,
  to_direction_deg: 90,
} as const;

function vessel_legend(): SVGElement {
  const moved = { transform: 'translate(-10 0)' };
  return drawn('g', moved, way_sign(30, 0), vessel_sign(SHIP));
}

function words(text: string): HTMLElement {
  return element('span', {}, text);
}

function sign_of(sign: SVGElement | null, layer: Layer): SVGElement | string {
  if (sign === null) return '';
  const offset = layer === 'bed' || layer === 'vessels' ? 0 : layer === 'current' ? -24 : 24;
  return drawn(
    'svg',
    { class: 'sign', viewBox: '-22 -12 44 24', 'aria-hidden': 'true' },
    drawn('g', { transform: `translate(${offset} 0)` }, sign),
  );
}

function fixed(sign: SVGElement, text: string): HTMLElement {
  const picture = drawn('svg', { class: 'sign', viewBox: '-22 -12 44 24', 'aria-hidden': 'true' });
  picture.append(sign);
  return element('p', { class: 'check' }, picture, words(text));
}

/** @param landing_deg  the side where boats land, clockwise from north; null: nobody says */
export function turbine_sign(landing_deg: number | null = null): SVGElement {
  const sign = drawn(
    'g',
    { class: 'turbine' },
    drawn('path', { d: 'M0,0 L0,-8 M0,0 L7,4 M0,0 L-7,4' }),
    drawn('circle', { r: 2 }),
  );
  if (landing_deg !== null) {
    sign.append(drawn('path', { d: 'M-4,-11 h8', transform: `rotate(${landing_deg})` }));
  }
  return sign;
}

export function port_sign(): SVGElement {
  return drawn(
    'g',
    { class: 'port' },
    drawn('circle', { cy: -6, r: 2 }),
    drawn('path', { d: 'M0,-4 V7 M-4,-1 H4 M-7,2 Q-5,7 0,7 Q5,7 7,2' }),
  );
}

function contour_sign(): SVGElement {
  return drawn('path', { class: 'contour', d: 'M-20,4 C-8,-10 6,10 20,-4' });
}

export function place_sign(): SVGElement {
  return drawn(
    'g',
    { class: 'place' },
    drawn('path', { class: 'halo', d: 'M-13,0 h8 M5,0 h8 M0,-13 v8 M0,5 v8' }),
    drawn('path', { d: 'M-13,0 h8 M5,0 h8 M0,-13 v8 M0,5 v8' }),
  );
}
