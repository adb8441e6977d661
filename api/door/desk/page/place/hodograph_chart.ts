// The hodograph: where the current goes to at each depth, seen from above, north up.
import { axis, chart, type Chart, type Option } from '../look/chart';
import { colours } from '../look/colours';
import type { Desk } from '../look/desk';
import type { Level } from './profile';
import { nice_most, type Shown } from './profile_chart';

const HEIGHT_PX = 300;
const MARGIN = { left: 52, right: 14, top: 10, bottom: 46 };

export function hodograph_chart(desk: Desk, shown: () => Shown | null): Chart {
  return chart(desk, 'Hodograph', HEIGHT_PX, (width_px) => {
    const it = shown();
    return it === null ? {} : option(desk, it, width_px);
  });
}

function option({ look }: Desk, it: Shown, width_px: number): Option {
  const { water, ink, quiet } = colours();
  const known = it.levels.filter(
    (level): level is Level & { east_m_s: number; north_m_s: number } =>
      level.east_m_s !== null && level.north_m_s !== null,
  );
  const point = (level: { east_m_s: number; north_m_s: number }): [number, number] => [
    look.speed_number(level.east_m_s),
    look.speed_number(level.north_m_s),
  ];
  const chosen = known.reduce<(typeof known)[number] | undefined>(
    (best, level) =>
      best === undefined ||
      Math.abs(level.depth_m - it.depth_m) < Math.abs(best.depth_m - it.depth_m)
        ? level
        : best,
    undefined,
  );
  // The hour's own scale: at slack water the turning is what one wants to see.
  const parts = known.flatMap((level) => [level.east_m_s, level.north_m_s]);
  const bands = [...(chosen?.east_band ?? []), ...(chosen?.north_band ?? [])];
  const most = nice_most(
    look.speed_number(Math.max(0, ...[...parts, ...bands].map((part) => Math.abs(part)))),
  );
  const named = new Set([known[0], known[known.length - 1], chosen]);
  // North and east have the same scale: the wider side shows more, not larger.
  const high_px = HEIGHT_PX - MARGIN.top - MARGIN.bottom;
  const wide = (most * (width_px - MARGIN.left - MARGIN.right)) / high_px;
  const of_axis = (name: string, limit: number, gap: number): Option =>
    axis(name, {
      type: 'value',
      min: -limit,
      max: limit,
      nameLocation: 'middle',
      nameGap: gap,
      axisLabel: { showMinLabel: limit === most, showMaxLabel: limit === most },
    });
  return {
    grid: MARGIN,
    xAxis: of_axis(`to the east, ${look.speed_unit}`, wide, 28),
    yAxis: of_axis(`to the north, ${look.speed_unit}`, most, 38),
    series: [
      {
        type: 'line',
        data: chosen === undefined ? [] : [[0, 0], point(chosen)],
        symbol: ['none', 'arrow'],
        showSymbol: false,
        lineStyle: { color: ink, width: 2 },
        z: 4,
      },
      ...band_cross(chosen, look.speed_number.bind(look), quiet),
      {
        type: 'line',
        data: known.map((level) => ({
          value: point(level),
          symbolSize: level === chosen ? 11 : 6,
          label: {
            show: named.has(level),
            formatter: `${level.depth_m} m`,
            color: ink,
            position: 'right',
            fontSize: 13,
          },
        })),
        symbol: 'circle',
        lineStyle: { color: water, width: 2 },
        itemStyle: { color: water },
        z: 3,
      },
    ],
  };
}

/** The bands of both parts at the chosen depth, as a cross. */
function band_cross(
  chosen: Level | undefined,
  number: (speed_m_s: number) => number,
  color: string,
): Option[] {
  const { east_band, north_band, east_m_s, north_m_s } = chosen ?? {};
  if (!east_band || !north_band || east_m_s == null || north_m_s == null) return [];
  const line = (from: [number, number], to: [number, number]): Option => ({
    type: 'line',
    data: [from, to],
    symbol: 'none',
    lineStyle: { color, width: 1.5, type: 'dashed' },
    z: 2,
  });
  const [east, north] = [number(east_m_s), number(north_m_s)];
  return [
    line([number(east_band[0]), north], [number(east_band[1]), north]),
    line([east, number(north_band[0])], [east, number(north_band[1])]),
  ];
}
