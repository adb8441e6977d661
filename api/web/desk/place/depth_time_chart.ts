// The current over depth and time: how fast by the dark of a cell, where to by its arrow.
import { axis, chart, type Chart, type Option } from '../look/chart';
import { colours } from '../look/colours';
import type { Desk } from '../look/desk';
import { drawn, element } from '../../look/element';
import { HOUR_MS } from '../look/hours';
import { time_axis } from '../look/time_axis';
import { value_at, type Column } from '../server/coverage';
import { ramp, steps_of } from './ramp';

const ARROW_PX = 26; // room that an arrow wants

interface Means {
  coord(point: [number, number]): [number, number];
  value(i: number): number;
}

export function depth_time_chart(
  desk: Desk,
  column: () => Column | null,
  depth_m: () => number,
): Chart & { legend: HTMLElement } {
  const legend = element('p', { class: 'steps' });
  const made = chart(desk, 'Current over depth and time', 260, (width_px) => {
    const it = column();
    legend.replaceChildren();
    if (it === null) return {};
    const most = Math.max(
      0,
      ...(it.values.sea_water_speed ?? []).map((speed) => desk.look.speed_number(speed ?? 0)),
    );
    const steps = steps_of(most);
    legend.append(...swatches(steps, desk.look.speed_unit));
    return option(desk, it, depth_m(), steps, width_px);
  });
  return { ...made, legend };
}

function option(
  desk: Desk,
  column: Column,
  depth_m: number,
  steps: number[],
  width_px: number,
): Option {
  const { levels_m, times_ms } = column;
  const edges = edges_of(levels_m);
  const fills = ramp(steps.length - 1);
  const step_of = (speed: number): number =>
    Math.min(steps.length - 2, Math.max(0, steps.filter((least) => least <= speed).length - 1));
  const cells: number[][] = [];
  const missing: number[][] = [];
  const arrows: number[][] = [];
  const from_ms = times_ms[0] ?? 0;
  const to_ms = times_ms[times_ms.length - 1] ?? from_ms + HOUR_MS;
  const every = Math.ceil((ARROW_PX * times_ms.length) / Math.max(100, width_px - 66));
  const with_arrows = levels_with_room(levels_m, 200);
  times_ms.forEach((at_ms, t) =>
    levels_m.forEach((level_m, k) => {
      const speed = value_at(column, 'sea_water_speed', t, k);
      const [top, bottom] = [edges[k] ?? 0, edges[k + 1] ?? 0];
      const cell = [
        Math.max(from_ms, at_ms - HOUR_MS / 2),
        top,
        Math.min(to_ms, at_ms + HOUR_MS / 2),
        bottom,
      ];
      if (speed === null) {
        missing.push(cell); // struck through: never a calm cell
        return;
      }
      const step = step_of(desk.look.speed_number(speed));
      cells.push([...cell, step]);
      const to = value_at(column, 'sea_water_velocity_to_direction', t, k);
      const is_drawn = t % every === Math.floor(every / 2) && with_arrows.has(k);
      if (to !== null && is_drawn) arrows.push([at_ms, level_m, to, step, top, bottom]);
    }),
  );
  return {
    grid: { left: 52, right: 14, top: 10, bottom: 28 },
    xAxis: { ...time_axis(desk, { from_ms, to_ms }, width_px), splitLine: { show: false } },
    yAxis: axis('depth, m', {
      type: 'value',
      inverse: true,
      min: edges[0] ?? 0,
      max: edges[edges.length - 1] ?? 1,
      nameLocation: 'middle',
      nameGap: 34,
      splitLine: { show: false },
    }),
    series: [
      {
        type: 'custom',
        silent: true,
        data: cells,
        renderItem: (_: unknown, means: Means) => {
          const [x, y] = means.coord([means.value(0), means.value(1)]);
          const [right, bottom] = means.coord([means.value(2), means.value(3)]);
          const shape = { x, y, width: right - x + 0.6, height: bottom - y + 0.6 };
          return { type: 'rect', shape, style: { fill: fills[means.value(4)]?.fill } };
        },
        markLine: depth_line(depth_m, colours().ink),
      },
      {
        type: 'custom',
        silent: true,
        data: missing,
        renderItem: (_: unknown, means: Means) => {
          const [x1, y2] = means.coord([means.value(0), means.value(1)]);
          const [x2, y1] = means.coord([means.value(2), means.value(3)]);
          const style = { stroke: colours().quiet, lineWidth: 1 };
          return { type: 'line', shape: { x1, y1, x2, y2 }, style };
        },
      },
      {
        type: 'custom',
        silent: true,
        data: arrows,
        renderItem: (_: unknown, means: Means) => {
          const [x, y] = means.coord([means.value(0), (means.value(4) + means.value(5)) / 2]);
          return {
            type: 'path',
            x,
            y,
            rotation: (-means.value(2) * Math.PI) / 180,
            shape: { pathData: 'M0,8 L0,-8 M-3.5,-3 L0,-8 L3.5,-3' },
            style: { fill: 'none', stroke: fills[means.value(3)]?.on, lineWidth: 1.4 },
          };
        },
      },
    ],
  };
}

/** The map's depth, as a line across. */
function depth_line(depth_m: number, colour: string): Option {
  return {
    silent: true,
    symbol: 'none',
    label: { show: false },
    lineStyle: { color: colour, type: [2, 3], width: 1 },
    data: [{ yAxis: depth_m }],
  };
}

/** Between the levels, half-way; the first and the last as far as the level itself. */
export function edges_of(levels_m: number[]): number[] {
  const between = levels_m.slice(1).map((level, i) => (level + (levels_m[i] ?? level)) / 2);
  const first = levels_m[0] ?? 0;
  const last = levels_m[levels_m.length - 1] ?? 1;
  return levels_m.length === 1 ? [first, first + 1] : [first, ...between, last];
}

function levels_with_room(levels_m: number[], high_px: number): Set<number> {
  const edges = edges_of(levels_m);
  const deep_m = (edges[edges.length - 1] ?? 1) - (edges[0] ?? 0);
  const middles = levels_m.map((_, k) => ((edges[k] ?? 0) + (edges[k + 1] ?? 0)) / 2);
  const chosen = new Set<number>();
  let last = -Infinity;
  middles.forEach((middle_m, k) => {
    const height_px = (((edges[k + 1] ?? 0) - (edges[k] ?? 0)) / deep_m) * high_px;
    const far_px = ((middle_m - last) / deep_m) * high_px;
    if (height_px < 12 || far_px < 20) return;
    chosen.add(k);
    last = middle_m;
  });
  return chosen;
}

function swatches(steps: number[], unit: string): Node[] {
  const fills = ramp(steps.length - 1);
  const signs = fills.map(({ fill }, i) => {
    const box = drawn('rect', { width: 22, height: 14, fill });
    const picture = drawn('svg', { viewBox: '0 0 22 14', class: 'swatch' }, box);
    return element('span', {}, picture, `${steps[i]}–${steps[i + 1]}`);
  });
  return [...signs, element('span', {}, `${unit}; arrow: to, north up; struck through: no value`)];
}
