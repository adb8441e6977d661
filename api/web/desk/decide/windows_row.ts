// One task's starts as a row: the height, the fill and the number of a column are its chance.
import { drawn } from '../../look/element';
import { told_by, type Answer } from './answer';
import type { Start, Windows, WindowsTask } from './answers';
import type { Axis } from './axis';
import { hour_line, tick_lines } from './axis_drawing';
import { hour_on } from './clock';
import { binding_text, chance_text, interval_text, percent_of } from './words';

const TOP = 14; // the numbers stand here
const FULL = 40; // a column of 100 %
const SHORT = 8; // of a row without a start worth a number

export interface WindowsRow {
  svg: SVGSVGElement;
  slider_hour: SVGLineElement;
  select(start: number): void;
}

/** Below this a number only blurs the picture. */
const LEAST_TOLD = 0.1;

/** How high a row's parts lie. A row that has hardly a chance takes little room. */
function heights_of({ starts }: WindowsTask): { column: number; threshold: number; alpha: number } {
  const column = starts.some(({ worth }) => worth >= LEAST_TOLD) ? FULL : SHORT;
  return { column, threshold: TOP + column + 4, alpha: TOP + column + 12 };
}

export function fill_of(worth: number, rules: Windows['rules']): 'go' | 'marginal' | 'low' {
  if (worth >= rules.go) return 'go';
  return worth >= rules.marginal ? 'marginal' : 'low';
}

/** What a screen reader says of a start. */
function start_text(start: Start, zone: string, day: string): string {
  const counts = start.worth < start.probability ? `, counts as ${chance_text(start.worth)}` : '';
  return (
    `${hour_on(start.start, zone, day)}: ${chance_text(start.probability)}${counts}, ` +
    `interval ${interval_text(start.interval_95)}. ${binding_text(start, zone, day)}`
  );
}

export function windows_row(
  answer: Answer<Windows>,
  t: number,
  axis: Axis,
  zone: string,
): WindowsRow {
  const task = answer.body.tasks[t] as WindowsTask;
  const every_ms = answer.body.every_min * 60_000;
  const width = axis.width(every_ms);
  const { column, threshold, alpha } = heights_of(task);
  const row_height = alpha + 8;
  const svg = drawn('svg', {
    class: 'starts',
    height: row_height,
    width: '100%',
    role: 'slider',
    tabindex: 0,
    'aria-label': `Starts of ${task.name}`,
    'aria-valuemin': 0,
    'aria-valuemax': Math.max(0, task.starts.length - 1),
  });
  svg.append(
    ...tick_lines(axis, zone, row_height),
    drawn('line', { class: 'base', x1: 0, x2: '100%', y1: TOP + column, y2: TOP + column }),
  );
  const best = task.starts[best_start(task)]?.start ?? '';
  const always = new Set([best, ...task.windows.map((window) => window.best)]);
  task.starts.forEach((start, s) => {
    const at_ms = Date.parse(start.start);
    const x = axis.x(at_ms);
    if (start.forbidden !== null) {
      svg.append(drawn('rect', { class: 'closed', x, y: TOP, width, height: column }));
      return;
    }
    // Never quite flat: a start is there, and has hardly a chance.
    const height = Math.max(1, FULL * start.worth);
    const y = TOP + column - height;
    const fill = fill_of(start.worth, answer.body.rules);
    const hatched: Record<string, string> = fill === 'marginal' ? { fill: 'url(#desk-hatch)' } : {};
    const told = told_by(answer, `tasks.${t}.starts.${s}.worth`);
    svg.append(drawn('rect', { class: `start ${fill}`, x, y, width, height, ...hatched, ...told }));
    if (start.worth < LEAST_TOLD) return;
    const number = String(Math.min(99, percent_of(start.worth, answer.body.rules)));
    const at = { x: axis.x(at_ms + every_ms / 2), y: y - 3, 'text-anchor': 'middle' };
    const when = always.has(start.start) ? 'number always' : 'number';
    svg.append(drawn('text', { class: when, ...at }, number));
  });
  const most = Math.max(0, ...task.starts.map(({ worth }) => worth));
  if (column === SHORT) {
    const text = task.starts.length === 0 ? 'no start' : `the best start has ${chance_text(most)}`;
    svg.append(drawn('text', { class: 'none', x: 4, y: TOP + column - 5 }, text));
  }
  svg.append(
    ...bars(task.windows_by_threshold, 'threshold', threshold, axis, every_ms),
    ...bars(task.windows_by_alpha ?? [], 'alpha', alpha, axis, every_ms),
  );
  const selected = drawn('rect', { class: 'chosen', y: TOP - 12, height: column + 14, width });
  selected.setAttribute('visibility', 'hidden');
  const slider_hour = hour_line(row_height);
  svg.append(selected, slider_hour);

  let named = -1;
  const name = (s: number): void => {
    const start = task.starts[s];
    if (start === undefined) return;
    named = s;
    svg.setAttribute('aria-valuenow', String(named));
    svg.setAttribute('aria-valuetext', start_text(start, zone, answer.body.from));
  };
  name(first_named(task));
  return {
    svg,
    slider_hour,
    select(s) {
      const start = task.starts[s];
      selected.setAttribute('visibility', start === undefined ? 'hidden' : 'visible');
      if (start !== undefined) selected.setAttribute('x', axis.x(Date.parse(start.start)));
      name(s);
    },
  };
}

/** The start that the server calls the best, as in its report; -1 where there is none. */
export function best_start({ best, starts }: WindowsTask): number {
  if (best !== undefined) return starts.findIndex(({ start }) => start === best?.start);
  // A server that does not say: the start of most worth, of equal ones the first.
  return starts.reduce(
    (most, { worth }, s) => (worth > (starts[most]?.worth ?? -1) ? s : most),
    -1,
  );
}

/** Where the keys begin. */
export function first_named(task: WindowsTask): number {
  return Math.max(0, best_start(task));
}

function bars(
  windows: { from: string; to: string }[],
  kind: string,
  y: number,
  axis: Axis,
  every_ms: number,
): SVGElement[] {
  return windows.map(({ from, to }) => {
    const x1 = axis.x(Date.parse(from));
    const x2 = axis.x(Date.parse(to) + every_ms);
    return drawn('line', { class: `bar ${kind}`, x1, x2, y1: y + 2, y2: y + 2 });
  });
}
