// The hodograph: where the current goes to at each depth, seen from above, north up.
import type { Desk } from '../look/desk';
import { drawn } from '../../look/element';
import { nice_most, nice_step } from '../look/nice';
import { MARGIN, path_of, picture, plot, words, type Picture, type Plot } from '../look/plot';
import { runs, type Level } from './profile';
import type { Shown } from './profile_chart';

const HEIGHT_PX = 300;

export type Known = Level & { east_m_s: number; north_m_s: number };

const is_known_level = (level: Level): level is Known =>
  level.east_m_s !== null && level.north_m_s !== null;

/** The levels that have a current, and among them the one nearest to the map's depth. */
export function known_of(
  levels: Level[],
  depth_m: number,
): { known: Known[]; chosen: Known | null } {
  const known = levels.filter(is_known_level);
  const far = (level: Known): number => Math.abs(level.depth_m - depth_m);
  const chosen = known.reduce<Known | null>(
    (best, level) => (best === null || far(level) < far(best) ? level : best),
    null,
  );
  return { known, chosen };
}

export function hodograph_chart(desk: Desk, shown: () => Shown | null): Picture {
  return picture('Hodograph', HEIGHT_PX, (width_px) => {
    const it = shown();
    return it === null ? [] : content(desk, it, width_px);
  });
}

function content({ look }: Desk, it: Shown, width_px: number): SVGElement[] {
  const { known, chosen } = known_of(it.levels, it.depth_m);
  const number = (speed_m_s: number): number => look.speed_number(speed_m_s);
  // The hour's own scale: at slack water the turning is what one wants to see.
  const parts = [
    ...known.flatMap((level) => [level.east_m_s, level.north_m_s]),
    ...(chosen?.east_band ?? []),
    ...(chosen?.north_band ?? []),
  ];
  const most = nice_most(number(Math.max(0, ...parts.map(Math.abs))));
  // North and east have the same scale: the wider side shows more, not larger.
  const high_px = HEIGHT_PX - MARGIN.top - MARGIN.bottom;
  const wide = (most * (width_px - MARGIN.left - MARGIN.right)) / high_px;
  const every = nice_step(2 * Math.max(wide, most), 9);
  const at = plot(
    width_px,
    HEIGHT_PX,
    { min: -wide, max: wide, every, name: `to the east, ${look.speed_unit}` },
    { min: -most, max: most, every, name: `to the north, ${look.speed_unit}` },
  );
  const point = (level: Known): [number, number] => [
    at.x(number(level.east_m_s)),
    at.y(number(level.north_m_s)),
  ];
  const named = with_names([chosen, known[0], known[known.length - 1]], point);
  const dots = known.flatMap((level) => {
    const [cx, cy] = point(level);
    const dot = drawn('circle', { class: 'east', cx, cy, r: level === chosen ? 5.5 : 3 });
    return named.has(level) ? [dot, words(cx + 9, cy + 4, `${level.depth_m} m`, 'on')] : [dot];
  });
  return [
    ...at.frame,
    ...(chosen === null ? [] : cross(at, chosen, number)),
    ...runs(it.levels, is_known_level).map((run) =>
      drawn('path', { class: 'east line', d: path_of(run.filter(is_known_level).map(point)) }),
    ),
    ...(chosen === null ? [] : [arrow([at.x(0), at.y(0)], point(chosen))]),
    ...dots,
  ];
}

const NAMES_APART_PX = 16;

/** Of levels, the first most wanted: those whose names do not lie on one another. */
function with_names(
  levels: (Known | null | undefined)[],
  point: (level: Known) => [number, number],
): Set<Known> {
  const named = new Set<Known>();
  for (const level of levels) {
    if (level === null || level === undefined) continue;
    const [x, y] = point(level);
    const is_free = [...named].every((other) => {
      const [ox, oy] = point(other);
      return Math.abs(oy - y) > NAMES_APART_PX || Math.abs(ox - x) > 3 * NAMES_APART_PX;
    });
    if (is_free) named.add(level);
  }
  return named;
}

/** The bands of both parts at the chosen depth. */
function cross(at: Plot, level: Known, number: (speed_m_s: number) => number): SVGElement[] {
  const { east_band, north_band } = level;
  if (east_band === null || north_band === null) return [];
  const x = at.x(number(level.east_m_s));
  const y = at.y(number(level.north_m_s));
  const [west, east] = east_band.map((speed) => at.x(number(speed)));
  const [south, north] = north_band.map((speed) => at.y(number(speed)));
  return [drawn('path', { class: 'cross', d: `M${west},${y} H${east} M${x},${south} V${north}` })];
}

function arrow([x0, y0]: [number, number], [x, y]: [number, number]): SVGElement {
  const length = Math.hypot(x - x0, y - y0);
  const degrees = (Math.atan2(x - x0, y0 - y) * 180) / Math.PI;
  const head = Math.min(9, length);
  const [half, neck] = [head / 2, head - length];
  return drawn('path', {
    class: 'arrow',
    transform: `translate(${x0} ${y0}) rotate(${degrees.toFixed(1)})`,
    d: `M0,0 V${-length} M${-half},${neck} L0,${-length} L${half},${neck}`,
  });
}
