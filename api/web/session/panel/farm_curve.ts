// Electricity of the farm against the wind: the curve of its turbines, and each turbine on it where
// the wind over its own rotor has it, wakes and all.
import { drawn, element, set_hidden, set_text } from '../../look/element';
import type { SpeedUnit } from '../look/units';
import type { Weather } from '../session/around';
import type { Turbines } from '../session/farm';
import { farm_text } from './weather_panel';

const WIDE = 300;
const HIGH = 150;
const LEFT = 34;
const BELOW = 30;
const ABOVE = 8;

export interface FarmCurve {
  readonly box: HTMLElement;
  show(turbines: Turbines | null, weather: Weather | null, unit: SpeedUnit): void;
}

/** Where a wind and a power are in the drawing. */
export function on_curve(
  turbines: Pick<Turbines, 'curve' | 'rated_w'>,
  wind_m_s: number,
  power_w: number,
): { x: number; y: number } {
  const most_m_s = turbines.curve[turbines.curve.length - 1]?.wind_m_s ?? 1;
  return {
    x: LEFT + (WIDE - LEFT) * Math.min(1, wind_m_s / most_m_s),
    y: HIGH - BELOW - (HIGH - BELOW - ABOVE) * Math.min(1, power_w / turbines.rated_w),
  };
}

export function farm_curve(): FarmCurve {
  const words = element('p', {});
  const picture = drawn('svg', { viewBox: `0 0 ${WIDE} ${HIGH}`, role: 'img', class: 'curve' });
  const box = element(
    'details',
    {},
    element('summary', {}, 'Electricity of the farm'),
    words,
    picture,
    element(
      'p',
      { class: 'note' },
      'Each dot is a turbine, at the wind over its own rotor. Behind others it has less.',
    ),
  );
  let drawn_for: Turbines | null = null;
  const dots = drawn('g', { class: 'dots' });
  const free = drawn('line', { class: 'free' });

  function draw_axes(turbines: Turbines): void {
    const at = (wind_m_s: number, power_w: number): string => {
      const { x, y } = on_curve(turbines, wind_m_s, power_w);
      return `${x.toFixed(1)},${y.toFixed(1)}`;
    };
    const points = turbines.curve.map((it) => at(it.wind_m_s, it.power_w)).join(' ');
    const label = (x: number, y: number, text: string, anchor = 'middle'): SVGTextElement =>
      drawn('text', { x, y, 'text-anchor': anchor }, text);
    const parts: SVGElement[] = [drawn('polyline', { points, class: 'line' }), free, dots];
    const most_m_s = turbines.curve[turbines.curve.length - 1]?.wind_m_s ?? 0;
    for (let wind_m_s = 0; wind_m_s <= most_m_s; wind_m_s += 5)
      parts.push(label(on_curve(turbines, wind_m_s, 0).x, HIGH - BELOW + 12, `${wind_m_s}`));
    parts.push(label((LEFT + WIDE) / 2, HIGH - 4, 'wind, m/s'));
    for (const share of [0, 0.5, 1]) {
      const power_w = share * turbines.rated_w;
      const { y } = on_curve(turbines, 0, power_w);
      parts.push(label(LEFT - 4, y + 4, (power_w / 1e6).toFixed(1), 'end'));
    }
    parts.push(label(LEFT + 4, ABOVE + 4, 'MW', 'start'));
    picture.replaceChildren(...parts);
  }

  return {
    box,
    show: (turbines, weather, unit) => {
      const farm = weather?.farm ?? null;
      const is_told = turbines !== null && turbines.curve.length > 1 && farm !== null;
      set_hidden(box, !is_told);
      if (!is_told || weather === null) return;
      if (drawn_for !== turbines) draw_axes(turbines);
      drawn_for = turbines;
      set_text(words, farm_text(farm, weather, unit));
      picture.setAttribute('aria-label', words.textContent ?? '');
      const { x } = on_curve(turbines, weather.hub_wind_m_s ?? 0, 0);
      for (const [name, value] of Object.entries({ x1: x, x2: x, y1: ABOVE, y2: HIGH - BELOW }))
        free.setAttribute(name, value.toFixed(1));
      while (dots.children.length > farm.each.length) dots.lastChild?.remove();
      while (dots.children.length < farm.each.length) dots.append(drawn('circle', { r: 3.5 }));
      farm.each.forEach((turbine, nth) => {
        const at = on_curve(turbines, turbine.wind_m_s, turbine.power_w);
        dots.children[nth]?.setAttribute('cx', at.x.toFixed(1));
        dots.children[nth]?.setAttribute('cy', at.y.toFixed(1));
      });
    },
  };
}
