// Current by depth: its eastward and northward parts, each with the band from p10 to p90.
import type { Desk } from '../look/desk';
import { drawn } from '../../look/element';
import { nice_most, nice_step } from '../look/nice';
import { path_of, picture, plot, type Picture, type Plot } from '../look/plot';
import { runs, type Level } from './profile';

export interface Shown {
  levels: Level[];
  most_m_s: number;
  depth_m: number;
}

const HEIGHT_PX = 300;

export function profile_chart(desk: Desk, shown: () => Shown | null): Picture {
  return picture('Current by depth', HEIGHT_PX, (width_px) => {
    const it = shown();
    return it === null ? [] : content(desk, it, width_px);
  });
}

function content({ look }: Desk, { levels, most_m_s, depth_m }: Shown, wide: number): SVGElement[] {
  const most = nice_most(look.speed_number(most_m_s));
  const deepest_m = Math.max(1, ...levels.map((level) => level.depth_m));
  const at = plot(
    wide,
    HEIGHT_PX,
    {
      min: -most,
      max: most,
      every: nice_step(2 * most, wide > 330 ? 6 : 4),
      name: `${look.speed_unit}, plus is to the east or north`,
    },
    { min: 0, max: deepest_m, every: nice_step(deepest_m, 7), name: 'depth, m', is_down: true },
  );
  const number = (speed_m_s: number): number => look.speed_number(speed_m_s);
  const y = at.y(Math.min(depth_m, deepest_m));
  return [
    ...bands(at, levels, (level) => level.east_band, number, 'band'),
    ...bands(at, levels, (level) => level.north_band, number, 'band north'),
    ...at.frame,
    drawn('path', { class: 'chosen', d: `M${at.x(-most)},${y} H${at.x(most)}` }),
    ...lines(at, levels, (level) => level.east_m_s, number, 'east'),
    ...lines(at, levels, (level) => level.north_m_s, number, 'north'),
  ];
}

function lines(
  at: Plot,
  levels: Level[],
  read: (level: Level) => number | null,
  number: (speed_m_s: number) => number,
  kind: 'east' | 'north',
): SVGElement[] {
  return runs(levels, (level) => read(level) !== null).flatMap((run) => {
    const points = run.map((level): [number, number] => [
      at.x(number(read(level) ?? 0)),
      at.y(level.depth_m),
    ]);
    const signs = points.map(([x, y]) =>
      kind === 'east'
        ? drawn('circle', { class: kind, cx: x, cy: y, r: 3 })
        : drawn('path', {
            class: `${kind} sign`,
            d: `M${x},${y - 4.5} l4.5,4.5 l-4.5,4.5 l-4.5,-4.5 Z`,
          }),
    );
    return [drawn('path', { class: `${kind} line`, d: path_of(points) }), ...signs];
  });
}

function bands(
  at: Plot,
  levels: Level[],
  read: (level: Level) => [number, number] | null,
  number: (speed_m_s: number) => number,
  kind: string,
): SVGElement[] {
  return runs(levels, (level) => read(level) !== null).map((run) => {
    const side = (i: 0 | 1): [number, number][] =>
      run.map((level) => [at.x(number(read(level)?.[i] ?? 0)), at.y(level.depth_m)]);
    return drawn('path', { class: kind, d: `${path_of([...side(0), ...side(1).reverse()])}Z` });
  });
}
