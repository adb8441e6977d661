// When each task can begin: a row a task, hours across; a press on a start tells all of it.
import { element } from '../../look/element';
import type { Answer } from './answer';
import type { Windows, WindowsTask } from './answers';
import { Axis } from './axis';
import { clock_above, hatches, move_hour_line } from './axis_drawing';
import { start_detail } from './start_detail';
import { windows_row, first_named } from './windows_row';
import { windows_tables } from './windows_table';
import { VERDICT, allowed_text } from './words';

export interface Gantt {
  node: HTMLElement;
  /** Marks the slider's hour. */
  at(at_ms: number): void;
}

export function windows_gantt(
  answer: Answer<Windows>,
  zone: string,
  show_hour: (at_ms: number) => void,
): Gantt {
  const windows = answer.body;
  const axis = new Axis(Date.parse(windows.from), Date.parse(windows.to));
  const node = element('div', { class: 'gantt' }, hatches());
  const hours: SVGLineElement[] = [];
  if (windows.tasks.length === 0) node.append(element('p', {}, 'No task could be worked out.'));
  else node.append(legend(windows), clock_above(axis, zone));
  for (const t of best_first(windows.tasks)) {
    const task = windows.tasks[t] as WindowsTask;
    const row = windows_row(answer, t, axis, zone);
    const detail = element('div', { class: 'detail' });
    hours.push(row.slider_hour);
    const choose = (s: number): void => {
      row.select(s);
      detail.replaceChildren(start_detail(answer, t, s, zone, show_hour));
    };
    listen(row.svg, task, choose, () => {
      row.select(-1);
      detail.replaceChildren();
    });
    node.append(
      element(
        'div',
        { class: 'task-row' },
        element('h3', { class: 'task-name' }, task.name, badge(task)),
        row.svg,
        detail,
      ),
    );
  }
  if (windows.tasks.length > 0) node.append(windows_tables(answer, zone));
  for (const { task, why } of windows.left_out) {
    node.append(element('p', { class: 'left-out' }, `${task} could not be worked out: ${why}`));
  }
  for (const note of windows.notes) node.append(element('p', { class: 'note' }, note));
  return { node, at: (at_ms) => hours.forEach((line) => move_hour_line(line, axis, at_ms)) };
}

/** As the list of the days: what can be done first. */
function best_first(tasks: readonly WindowsTask[]): number[] {
  const verdicts = ['go', 'marginal', 'no-go'];
  const worth = (task: WindowsTask | undefined): number =>
    Math.max(0, ...(task?.starts ?? []).map((start) => start.worth));
  const rank = (task: WindowsTask | undefined): number => verdicts.indexOf(task?.verdict ?? '');
  return tasks
    .map((_, t) => t)
    .sort((a, b) => rank(tasks[a]) - rank(tasks[b]) || worth(tasks[b]) - worth(tasks[a]));
}

function badge(task: WindowsTask): HTMLElement {
  return element('span', { class: 'verdict', 'data-verdict': task.verdict }, VERDICT[task.verdict]);
}

/** Pressing, and the keys of a slider; Escape closes. */
function listen(
  svg: SVGSVGElement,
  task: WindowsTask,
  choose: (start: number) => void,
  close: () => void,
): void {
  const last = task.starts.length - 1;
  let chosen = first_named(task);
  const to = (s: number): void => {
    if (last < 0) return;
    chosen = Math.max(0, Math.min(last, s));
    choose(chosen);
  };
  svg.addEventListener('click', (event) => {
    const box = svg.getBoundingClientRect();
    if (box.width > 0) to(Math.floor(((event.clientX - box.left) / box.width) * (last + 1)));
  });
  svg.addEventListener('keydown', (event) => {
    const steps: Record<string, () => void> = {
      ArrowRight: () => to(chosen + 1),
      ArrowUp: () => to(chosen + 1),
      ArrowLeft: () => to(chosen - 1),
      ArrowDown: () => to(chosen - 1),
      PageUp: () => to(chosen + 6),
      PageDown: () => to(chosen - 6),
      Home: () => to(0),
      End: () => to(last),
      Enter: () => to(chosen),
      ' ': () => to(chosen),
      Escape: close,
    };
    const step = steps[event.key];
    if (step === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    step();
  });
}

function legend({ rules, tasks }: Windows): HTMLElement {
  const percent = (share: number): string => `${Math.round(100 * share)} %`;
  const is_flown = tasks.some(({ starts }) => starts.some((it) => it.worth < it.probability));
  const mark = (kind: string, text: string): HTMLElement =>
    element('span', { class: 'key' }, element('i', { class: `mark ${kind}` }), text);
  const alpha = tasks.find(({ no_alpha }) => no_alpha !== null)?.no_alpha ?? null;
  return element(
    'div',
    { class: 'gantt-legend' },
    mark('go', `go: ${percent(rules.go)} and more`),
    mark('marginal', `marginal: ${percent(rules.marginal)} and more`),
    mark('low', 'below: no-go'),
    mark('threshold', 'the central forecast alone allows it'),
    mark('alpha', 'the usual safety margins (alpha) allow it'),
    mark('slider-hour', 'the hour shown on the page'),
    element(
      'span',
      { class: 'note' },
      'The height is the chance that all limits hold from that start to the way home. ' +
        (is_flown ? 'Where flights succeed less often, it is what the start counts as. ' : '') +
        'Press a start, or use the arrow keys, to read why.' +
        (alpha === null ? '' : ` Where there is no alpha bar: ${allowed_text(null, alpha)}.`),
    ),
  );
}
