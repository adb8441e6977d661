// Lines over the hours of the forecast, told apart by their dashes; bands where they are given.
import { axis, chart, type Chart, type Option } from '../look/chart';
import { colours, type Colours } from '../look/colours';
import type { Desk } from '../look/desk';
import { drawn, element } from '../../look/element';
import { time_ticks } from '../look/hours';
import { nice_most, nice_step } from '../look/nice';
import { time_axis } from '../look/time_axis';
import type { Value } from '../server/coverage';
import { band } from './band';
import { runs } from './profile';

export interface Line {
  name: string;
  values: Value[];
  band: { low: Value[]; high: Value[] } | null;
  dash: 'solid' | 'dashed' | 'dotted';
  colour: keyof Colours;
  is_right?: boolean; // of the axis on the right
}
export interface Series {
  times_ms: number[];
  unit: string;
  right_unit?: string;
  from_zero: boolean;
  lines: Line[];
  /** What stands above an hour: a direction in words. */
  above?: { title: string; text: (at_ms: number) => string };
}

export function series_chart(
  desk: Desk,
  name: string,
  series: () => Series | null,
): Chart & { legend: HTMLElement } {
  const legend = element('p', { class: 'lines' });
  const made = chart(desk, name, 180, (width_px) => {
    const it = series();
    legend.replaceChildren(...(it === null ? [] : legend_of(it)));
    return it === null ? {} : option(desk, it, width_px);
  });
  return { ...made, legend };
}

function option(desk: Desk, it: Series, width_px: number): Option {
  const from_ms = it.times_ms[0] ?? 0;
  const to_ms = it.times_ms[it.times_ms.length - 1] ?? from_ms + 1;
  const reach = { from_ms, to_ms };
  const paint = colours();
  const y_axis = (unit: string, position: 'left' | 'right'): Option =>
    axis(unit, {
      type: 'value',
      position,
      ...range_of(it, position === 'right'),
      nameLocation: 'middle',
      nameGap: 34,
      splitLine: { show: position === 'left', lineStyle: { color: paint.rule } },
    });
  const lines = it.lines.flatMap((line): Option[] => {
    const own = { yAxisIndex: line.is_right === true ? 1 : 0 };
    const rows = it.times_ms.map((at_ms, i) => ({ at_ms, i }));
    const bands =
      line.band === null
        ? []
        : runs(rows, ({ i }) => line.band?.low[i] != null && line.band.high[i] != null).map(
            (run) => {
              const side = (of: Value[]): [number, number][] =>
                run.map(({ at_ms, i }) => [at_ms, of[i] ?? 0]);
              const edges = [
                ...side(line.band?.low ?? []),
                ...side(line.band?.high ?? []).reverse(),
              ];
              const is_first = line === it.lines[0];
              const colour = is_first ? paint.band : 'transparent';
              return { ...band(edges, colour, is_first ? 'none' : paint[line.colour]), ...own };
            },
          );
    return [
      ...bands,
      {
        type: 'line',
        ...own,
        data: rows.map(({ at_ms, i }) => [at_ms, line.values[i] ?? null]),
        connectNulls: false,
        showSymbol: false,
        z: 3,
        lineStyle: { color: paint[line.colour], width: 2, type: line.dash },
      },
    ];
  });
  return {
    grid: { left: 52, right: it.right_unit === undefined ? 14 : 52, top: 24, bottom: 28 },
    xAxis: time_axis(desk, reach, width_px),
    yAxis: [
      y_axis(it.unit, 'left'),
      ...(it.right_unit === undefined ? [] : [y_axis(it.right_unit, 'right')]),
    ],
    series: [...lines, ...above_of(desk, it, width_px)],
  };
}

/** From nothing to a round number above lines and bands; to both sides where values have signs. */
function range_of(it: Series, is_right: boolean): { min: number; max: number; interval: number } {
  const all = it.lines
    .filter((line) => (line.is_right === true) === is_right)
    .flatMap(({ values, band: both }) => [...values, ...(both?.low ?? []), ...(both?.high ?? [])]);
  const max = nice_most(Math.max(0, ...all.map((value) => Math.abs(value ?? 0))));
  const min = it.from_zero ? 0 : -max;
  return { min, max, interval: nice_step(max - min, 5) };
}

const ABOVE_PX = 40; // of a direction, with room

/** Words on top of the plot at the hours of the ticks. */
function above_of(desk: Desk, it: Series, width_px: number): Option[] {
  const { above } = it;
  if (above === undefined) return [];
  const reach = { from_ms: it.times_ms[0] ?? 0, to_ms: it.times_ms[it.times_ms.length - 1] ?? 0 };
  const { ink } = colours();
  const inside_ms = 0.03 * (reach.to_ms - reach.from_ms); // free of the axes' own words
  const ticks = time_ticks(reach, desk.look.zone, width_px - 100, ABOVE_PX).filter(
    ({ at_ms }) => at_ms > reach.from_ms + inside_ms && at_ms < reach.to_ms - inside_ms,
  );
  return [
    {
      type: 'custom',
      silent: true,
      clip: false,
      data: ticks.map(({ at_ms }) => [at_ms]),
      renderItem: (
        params: { coordSys: { y: number }; dataIndex: number },
        means: { coord(point: [number, number]): [number, number] },
      ) => {
        const at_ms = ticks[params.dataIndex]?.at_ms ?? 0;
        const style = {
          text: above.text(at_ms),
          x: means.coord([at_ms, 0])[0],
          y: params.coordSys.y - 6,
          align: 'center',
          verticalAlign: 'bottom',
          fill: ink,
          font: '12px system-ui, "DejaVu Sans", sans-serif',
        };
        return { type: 'text', style };
      },
    },
  ];
}

function legend_of({ lines, above }: Series): Node[] {
  const dashes = { solid: 'none', dashed: '7 4', dotted: '2 3' };
  const signs = lines.map(({ name, dash, colour, band: has }) => {
    const stroke = drawn('path', {
      d: 'M0,7 H30',
      stroke: colours()[colour],
      'stroke-width': 2,
      'stroke-dasharray': dashes[dash],
    });
    const picture = drawn('svg', { viewBox: '0 0 30 14', class: 'swatch line' }, stroke);
    return element('span', {}, picture, has === null ? name : `${name}, with the band p10–p90`);
  });
  if (lines.every((line) => line.band === null)) {
    signs.push(element('span', {}, 'The server gives no band for it.'));
  }
  if (above !== undefined) signs.push(element('span', {}, above.title));
  return signs;
}
