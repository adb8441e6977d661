// What is tried out, dashed, over what is true.
import type { GeoProjection } from 'd3-geo';
import { drawn } from '../../look/element';
import type { Trial } from '../trial';
import { line_through, screen, text } from './scene';
import { turbine_sign } from './legend';

export function draw_trial(at: SVGGElement, { turbines, zones }: Trial, to: GeoProjection): void {
  const of_zones = zones.map(({ id, ring }) => {
    const zone = drawn('path', { class: 'area exclusion trial', d: `${line_through(ring, to)}Z` });
    zone.append(drawn('title', {}, `${id}: keep out, on trial`));
    return zone;
  });
  const of_turbines = turbines.flatMap(({ id, place }) => {
    const here = screen(to, place);
    const around = drawn('circle', { class: 'trial', r: 11 });
    return [
      drawn('g', { transform: `translate(${here})` }, turbine_sign(null), around),
      text(here, 0, -16, `${id}, on trial`, 'name middle'),
    ];
  });
  at.replaceChildren(...of_zones, ...of_turbines);
}
