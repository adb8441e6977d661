// The three arrows of the map, each told from the others by its shape alone: the current is a full
// arrow away from its place (to), the wind a barb that stands to windward (from), the waves an open
// arrow of dashes that comes in (from). Paths start at (0, 0); directions are clockwise from north.
import { drawn } from '../../look/element';
import { is_known } from '../look/units';

const METRES_PER_SECOND_IN_A_KNOT = 1852 / 3600;
const STAFF_PX = 34;

const CURRENT_PX_PER_M_S = 70;

type Maybe = number | null;

/** Null where the speed or its direction is not known: no arrow, and the table says so. */
export function current_arrow(speed_m_s: Maybe, to_deg: Maybe): SVGElement | null {
  if (!is_known(speed_m_s) || !is_known(to_deg)) return null;
  const length = Math.max(6, speed_m_s * CURRENT_PX_PER_M_S);
  const head = Math.min(10, Math.max(6, length * 0.45));
  const shaft = Math.max(0, length - head);
  const d =
    `M-1.6,0 L-1.6,${-shaft} L${-head * 0.5},${-shaft} L0,${-length} L${head * 0.5},${-shaft}` +
    ` L1.6,${-shaft} L1.6,0 Z`;
  return drawn('path', { class: 'current', d, transform: `rotate(${to_deg}) translate(0 -5)` });
}

/** Barbs as on weather charts: half 5 kn, full 10 kn, pennant 50 kn; a ring for calm. */
export function wind_barb(speed_m_s: Maybe, from_deg: Maybe, is_south = false): SVGElement | null {
  if (!is_known(speed_m_s) || !is_known(from_deg)) return null;
  let fives = Math.round(speed_m_s / METRES_PER_SECOND_IN_A_KNOT / 5);
  if (fives === 0) return drawn('circle', { class: 'wind', r: 9 });
  const side = is_south ? -1 : 1; // barbs point to the low pressure
  let y = -STAFF_PX;
  let d = `M0,-7 L0,${y}`;
  let full = '';
  for (; fives >= 10; fives -= 10, y += 8) full += `M0,${y} L${11 * side},${y} L0,${y + 7} Z`;
  // A lone half barb stands in from the end of the staff, so that it is not read as a full one.
  if (fives === 1 && y === -STAFF_PX) y += 5;
  for (; fives >= 2; fives -= 2, y += 5) d += `M0,${y} l${11 * side},-4`;
  if (fives === 1) d += `M0,${y} l${6 * side},-2.2`;
  return drawn(
    'g',
    { class: 'wind', transform: `rotate(${from_deg})` },
    drawn('path', { d }),
    drawn('path', { class: 'full', d: full || 'M0,0' }),
  );
}

/** How far aside a wave arrow stands, to be free of the barbs: sea and wind often come as one. */
export function beside_barbs_px(wind_from: Maybe, wave_from: Maybe, is_south: boolean): number {
  if (!is_known(wind_from) || !is_known(wave_from)) return 0;
  const apart = ((((wave_from - wind_from + 180) % 360) + 360) % 360) - 180;
  if (Math.abs(apart) > 50) return 0;
  if (apart >= 0) return is_south ? 9 : 18;
  return is_south ? -18 : -9;
}

/** Comes in from where the waves come; longer for higher waves. */
export function wave_arrow(height_m: Maybe, from_deg: Maybe, beside_px = 0): SVGElement | null {
  if (!is_known(height_m) || !is_known(from_deg)) return null;
  const length = 16 + Math.min(30, height_m * 8);
  return drawn(
    'g',
    { class: 'wave', transform: `rotate(${from_deg}) translate(${beside_px} 0)` },
    drawn('path', { class: 'shaft', d: `M0,${-9 - length} L0,-9` }),
    drawn('path', { d: 'M-6,-17 L0,-9 L6,-17' }),
  );
}
