// A vessel on the map: a hull with its bow ahead, filled where its report is fresh, hollow where it
// is old; a ring and a mark of exclamation where it will pass too near. Bearings are clockwise from
// north.
import { drawn } from '../../look/element';
import { is_known } from '../look/units';
import type { Vessel } from '../server/traffic';

const HULL = 'M0,-12 C3,-9 5,-5 5,-1 V9 H-5 V-1 C-5,-5 -3,-9 0,-12 Z';
const SMALL = 'scale(0.72)'; // class B: small craft

type Shape = Pick<Vessel, 'state' | 'class' | 'alarm' | 'heading_deg' | 'to_direction_deg'>;

export function vessel_sign(vessel: Shape): SVGElement {
  const { state, alarm } = vessel;
  const bow_deg = vessel.heading_deg ?? vessel.to_direction_deg;
  const size = vessel.class === 'B' ? ` ${SMALL}` : '';
  const hull = is_known(bow_deg)
    ? drawn('path', { class: 'hull', d: HULL, transform: `rotate(${bow_deg})${size}` })
    : drawn('path', { class: 'hull', d: 'M0,-8 L8,0 L0,8 L-8,0 Z', transform: size.trim() });
  const sign = drawn('g', { class: `vessel ${state}` }, hull);
  if (alarm !== null) {
    sign.classList.add('marked');
    sign.append(
      drawn('circle', { class: 'mark', r: 17 }),
      drawn('path', { class: 'mark', d: 'M24,-13 v8 M24,-1.5 v2.5' }),
    );
  }
  return sign;
}

export const way_sign = (right: number, down: number): SVGElement =>
  drawn('path', { class: 'vessel-way', d: `M0,0 L${right},${down}` });
