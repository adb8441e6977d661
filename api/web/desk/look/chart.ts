// A chart of ECharts in the page's looks: made when it can be seen, redrawn when the palette or its
// size changes. The slider's hour is a line laid over it, so that moving it draws nothing anew.
import { CustomChart, LineChart } from 'echarts/charts';
import { GridComponent, MarkLineComponent } from 'echarts/components';
import * as echarts from 'echarts/core';
import type { EChartsCoreOption } from 'echarts/core';
import { CanvasRenderer } from 'echarts/renderers';
import { colours } from './colours';
import type { Desk } from './desk';
import { element, set_hidden } from '../../look/element';

echarts.use([CanvasRenderer, CustomChart, GridComponent, LineChart, MarkLineComponent]);

export type Option = EChartsCoreOption;

export interface Chart {
  node: HTMLElement;
  /** Draws again, if the option had reason to change. */
  draw: () => void;
  /** The line at a value of the x axis; none at null. */
  mark: (x: number | null) => void;
  /** What the picture says, in words, for those who do not see it. */
  say: (words: string) => void;
}

export function chart(
  desk: Desk,
  name: string,
  height_px: number,
  option: (width_px: number) => Option,
): Chart {
  const canvas = element('div', { class: 'canvas', role: 'img', 'aria-label': name });
  const line = element('div', { class: 'hour-mark', hidden: true });
  const node = element('div', { class: 'chart' }, canvas, line);
  node.style.height = `${height_px}px`;
  let made: echarts.ECharts | null = null;
  let marked: number | null = null;

  const mark = (x: number | null): void => {
    marked = x;
    const at =
      made === null || x === null ? NaN : Number(made.convertToPixel({ xAxisIndex: 0 }, x));
    const rect = grid_of(made);
    const is_inside = rect !== null && at >= rect.x - 1 && at <= rect.x + rect.width + 1;
    set_hidden(line, !is_inside);
    if (!is_inside) return;
    line.style.transform = `translateX(${at}px)`;
    line.style.top = `${rect.y}px`;
    line.style.height = `${rect.height}px`;
  };
  const draw = (): void => {
    if (made === null) return;
    const drawn = option(made.getWidth());
    made.setOption({ animation: false, textStyle: text_style(), ...drawn }, { notMerge: true });
    mark(marked);
  };
  new ResizeObserver(() => {
    if (canvas.clientWidth < 2 || canvas.clientHeight < 2) return;
    if (made === null) {
      made = echarts.init(canvas, null, { renderer: 'canvas' });
      draw();
    } else {
      made.resize();
      draw();
    }
  }).observe(canvas);
  desk.onChange((changed) => {
    if (['palette', 'speed', 'clock', 'directions'].some((key) => changed.has(key as 'speed'))) {
      draw();
    }
  });
  resizers.push((width_px) => {
    made?.resize({ width: width_px });
    draw();
  });
  return { node, draw, mark, say: (words) => canvas.setAttribute('aria-label', words) };
}

/** Where the plot itself lies, within the axes. */
function grid_of(
  made: echarts.ECharts | null,
): { x: number; y: number; width: number; height: number } | null {
  type Inside = { getModel(): { getComponent(name: string): { coordinateSystem?: Area } | null } };
  type Area = { getRect(): { x: number; y: number; width: number; height: number } };
  const model = (made as unknown as Inside | null)?.getModel();
  return model?.getComponent('grid')?.coordinateSystem?.getRect() ?? null;
}

export const TEXT_PX = 13;

export function text_style(): { color: string; fontFamily: string; fontSize: number } {
  return {
    color: colours().ink,
    fontFamily: 'system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif',
    fontSize: TEXT_PX,
  };
}

/** The looks of an axis, so that all charts have the same. */
export function axis(name: string, more: Record<string, unknown> = {}): Record<string, unknown> {
  const { quiet, rule, ink } = colours();
  return {
    name,
    nameTextStyle: { color: quiet, fontSize: TEXT_PX },
    axisLine: { show: true, lineStyle: { color: quiet } },
    axisTick: { show: true, lineStyle: { color: quiet } },
    splitLine: { show: true, lineStyle: { color: rule } },
    ...more,
    axisLabel: { color: ink, fontSize: TEXT_PX, ...(more.axisLabel as Option | undefined) },
  };
}

const resizers: ((width_px: number | 'auto') => void)[] = [];
/** For paper, whose width no observer tells. */
export function resize_charts(width_px: number | 'auto'): void {
  for (const resize of resizers) resize(width_px);
}
