// Current by depth: its eastward and northward parts, each with the band from p10 to p90.
import { axis, chart, type Chart, type Option } from '../look/chart';
import { colours } from '../look/colours';
import type { Desk } from '../look/desk';
import { band } from './band';
import { runs, type Level } from './profile';

export interface Shown {
  levels: Level[];
  most_m_s: number;
  depth_m: number;
}

export function profile_chart(desk: Desk, shown: () => Shown | null): Chart {
  return chart(desk, 'Current by depth', 300, () => {
    const it = shown();
    return it === null ? {} : option(desk, it);
  });
}

function option({ look }: Desk, { levels, most_m_s, depth_m }: Shown): Option {
  const { water, amber, band: fill, ink } = colours();
  const number = (speed_m_s: number): number => look.speed_number(speed_m_s);
  const most = nice_most(number(most_m_s));
  const line = (name: string, read: (level: Level) => number | null, dash: string): Option => ({
    type: 'line',
    name,
    data: levels.map((level) => {
      const value = read(level);
      return [value === null ? null : number(value), level.depth_m];
    }),
    connectNulls: false,
    symbol: dash === 'solid' ? 'circle' : 'emptyDiamond',
    symbolSize: dash === 'solid' ? 6 : 8,
    z: 3,
    lineStyle: { color: dash === 'solid' ? water : amber, width: 2, type: dash },
    itemStyle: { color: dash === 'solid' ? water : amber },
  });
  const bands = (
    read: (level: Level) => [number, number] | null,
    colour: string,
    edge: string,
  ): Option[] =>
    runs(levels, (level) => read(level) !== null).map((run) => {
      const side = (i: 0 | 1): [number, number][] =>
        run.map((level) => [number(read(level)?.[i] ?? 0), level.depth_m]);
      return band([...side(0), ...side(1).reverse()], colour, edge);
    });
  return {
    grid: { left: 52, right: 14, top: 10, bottom: 46 },
    xAxis: axis(`${look.speed_unit}, plus is to the east or north`, {
      type: 'value',
      min: -most,
      max: most,
      nameLocation: 'middle',
      nameGap: 28,
    }),
    yAxis: axis('depth, m', {
      type: 'value',
      inverse: true,
      min: 0,
      max: Math.max(1, ...levels.map((level) => level.depth_m)),
      nameLocation: 'middle',
      nameGap: 34,
    }),
    series: [
      ...bands((level) => level.east_band, fill, 'none'),
      ...bands((level) => level.north_band, 'transparent', amber),
      {
        ...line('east', (level) => level.east_m_s, 'solid'),
        markLine: depth_line(depth_m, ink),
      },
      line('north', (level) => level.north_m_s, 'dashed'),
    ],
  };
}

/** The map's depth, as a line across. */
export function depth_line(depth_m: number, colour: string): Option {
  return {
    silent: true,
    symbol: 'none',
    label: { show: false },
    lineStyle: { color: colour, type: [2, 3], width: 1 },
    data: [{ yAxis: depth_m }],
  };
}

/** The next of 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2, 3 ... above. */
export function nice_most(most: number): number {
  if (!(most > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  const step = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((n) => n * power >= most * 0.999) ?? 10;
  return Number((step * power).toPrecision(3));
}
