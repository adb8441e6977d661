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
  dash: 'solid' | 'dashed' | 'dotted' | number[];
  colour: keyof Colours;
  is_right?: boolean; // of the axis on the right
  times_ms?: number[]; // its own; absent: those of the series
  /** A word at its end and a sign along it, which tell it from others without any hue. */
  end?: string;
  sign?: keyof typeof SIGNS;
  wide?: boolean;
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
    const rows = (line.times_ms ?? it.times_ms).map((at_ms, i) => ({ at_ms, i }));
    const every = Math.ceil(rows.length / MOST_SIGNS);
    const signs = {
      showSymbol: true,
      showAllSymbol: true,
      symbol: line.sign === 'cross' ? `path://${SIGNS.cross}` : line.sign,
      symbolSize: (_: unknown, { dataIndex }: { dataIndex: number }) =>
        dataIndex % every === 0 ? 7 : 0,
      itemStyle: { color: paint.paper, borderColor: paint[line.colour], borderWidth: 1.5 },
    };
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
        ...(line.sign === undefined ? { showSymbol: false } : signs),
        z: 3,
        lineStyle: { color: paint[line.colour], width: line.wide ? 3.5 : 2, type: line.dash },
      },
    ];
  });
  return {
    grid: { left: 52, right: room_on_the_right(it), top: 24, bottom: 28 },
    xAxis: time_axis(desk, reach, width_px),
    yAxis: [
      y_axis(it.unit, 'left'),
      ...(it.right_unit === undefined ? [] : [y_axis(it.right_unit, 'right')]),
    ],
    series: [...lines, ...ends_of(it), ...above_of(desk, it, width_px)],
  };
}

const MOST_SIGNS = 16; // along a line

function room_on_the_right(it: Series): number {
  if (it.right_unit !== undefined) return 52;
  return it.lines.some(({ end }) => end !== undefined) ? 44 : 14;
}

const END_PX = 15; // of a word's height

/** The words at the ends of the lines, moved up or down as far as they would lie on each other. */
function ends_of(it: Series): Option[] {
  const ends = it.lines.flatMap((line) => {
    const times_ms = line.times_ms ?? it.times_ms;
    const last = line.values.map((value) => value !== null).lastIndexOf(true);
    const [at_ms, value] = [times_ms[last], line.values[last]];
    if (line.end === undefined || at_ms === undefined || value == null) return [];
    return [{ at_ms, value, text: line.end }];
  });
  if (ends.length === 0) return [];
  const { ink, paper } = colours();
  type Means = { coord(point: [number, number]): [number, number] };
  return [
    {
      type: 'custom',
      silent: true,
      clip: false,
      z: 5,
      data: ends.map(({ at_ms, value }) => [at_ms, value]),
      renderItem: ({ dataIndex }: { dataIndex: number }, means: Means) => {
        const at = ends.map(({ at_ms, value }) => means.coord([at_ms, value]));
        const [x, y] = spread(at, END_PX)[dataIndex] ?? [0, 0];
        const style = {
          text: ends[dataIndex]?.text ?? '',
          x: x + 6,
          y,
          verticalAlign: 'middle',
          fill: ink,
          stroke: paper,
          lineWidth: 3,
          font: 'bold 13px system-ui, "DejaVu Sans", sans-serif',
        };
        return { type: 'text', style };
      },
    },
  ];
}

const NEAR_PX = 40; // across
const ROUNDS = 24; // enough for a dozen words in one place

/** Words that would lie on each other are moved apart, up and down, in the order they have. */
export function spread(points: [number, number][], least_px: number): [number, number][] {
  const placed: [number, number][] = points.map(([x, y]) => [x, y]);
  const order = [...placed].sort((a, b) => a[1] - b[1]);
  for (let round = 0; round < ROUNDS; round += 1) {
    order.forEach((upper, i) => {
      for (const lower of order.slice(i + 1)) {
        const lacking = least_px - (lower[1] - upper[1]);
        if (lacking <= 0 || Math.abs(lower[0] - upper[0]) > NEAR_PX) continue;
        upper[1] -= lacking / 2;
        lower[1] += lacking / 2;
      }
    });
  }
  return placed;
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

const SIGNS = {
  circle: 'M11.5,7 a3.5,3.5 0 1 0 7,0 a3.5,3.5 0 1 0 -7,0 Z',
  rect: 'M11.5,3.5 h7 v7 h-7 Z',
  triangle: 'M15,3.5 L18.5,10.5 h-7 Z',
  diamond: 'M15,3.5 L18.5,7 L15,10.5 L11.5,7 Z',
  cross: 'M11.5,3.5 L18.5,10.5 M11.5,10.5 L18.5,3.5', // what was measured
};

function sign_of(sign: keyof typeof SIGNS, stroke: string): SVGElement {
  return drawn('path', { d: SIGNS[sign], fill: colours().paper, stroke, 'stroke-width': 1.5 });
}

function legend_of({ lines, above }: Series): Node[] {
  const dashes = { solid: 'none', dashed: '7 4', dotted: '2 3' };
  const signs = lines.map(({ name, dash, colour, band: has, end, wide, sign }) => {
    const stroke = drawn('path', {
      d: 'M0,7 H30',
      stroke: colours()[colour],
      'stroke-width': wide ? 3.5 : 2,
      'stroke-dasharray': typeof dash === 'string' ? dashes[dash] : dash.join(' '),
    });
    const picture = drawn('svg', { viewBox: '0 0 30 14', class: 'swatch line' }, stroke);
    if (sign !== undefined) picture.append(sign_of(sign, colours()[colour]));
    const named = end === undefined || end === name ? name : `${end}: ${name}`;
    return element('span', {}, picture, has === null ? named : `${named}, with the band p10–p90`);
  });
  const is_compared = lines.some(({ end }) => end !== undefined);
  if (!is_compared && lines.every((line) => line.band === null)) {
    signs.push(element('span', {}, 'The server gives no band for it.'));
  }
  if (above !== undefined) signs.push(element('span', {}, above.title));
  return signs;
}
