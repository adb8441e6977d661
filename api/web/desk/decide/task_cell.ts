// What one day says of one task: the verdict, the best start, what binds, what nobody checked.
import { element } from '../../look/element';
import { told, told_by, type Answer } from './answer';
import type { Range, Report, ReportTask } from './answers';
import { hour_on, type Clock } from './clock';
import { verdict_badge } from './verdict_badge';
import { RULES, chance_nodes, chance_text, counted, interval_text, with_hours } from './words';

/**
 * @param title which day
 * @param day which that is: hours of another have their weekday
 * @param key where the task stands in the report: "today.tasks.3" or "tasks.3"
 */
export function task_cell(
  title: string,
  answer: Answer<Report>,
  key: string,
  task: ReportTask,
  clock: Clock,
  day: string,
): HTMLElement {
  const { zone } = clock;
  const cell = element('div', { class: 'task-cell' });
  const { best } = task;
  const first = element(
    'p',
    { class: 'first' },
    element('span', { class: 'cell-title' }, title),
    ' ',
    verdict_badge(answer, `${key}.verdict`, task.verdict),
  );
  cell.append(first);
  if (best === null) {
    first.append(' There is no start.');
  } else {
    const hour = (time: string): string => hour_on(time, zone, day);
    const is_over = Date.parse(best.start) < clock.now_ms;
    first.append(
      ' best ',
      told(answer, `${key}.best.start`, hour),
      is_over ? ' (over), ' : ', ',
      element('strong', {}, ...chance_nodes(answer, `${key}.best`, best)),
      ' ',
      element(
        'span',
        { class: 'interval' },
        '(',
        told(answer, `${key}.best.interval_95`, (range: Range) => interval_text(range)),
        ')',
      ),
    );
    if (best.flown !== null) {
      first.append(
        `; of ${counted(best.flown.flights, 'flight')} `,
        told(answer, `${key}.best.flown.probability`, chance_text),
        ' succeed',
      );
    }
    const binds = best.worth >= RULES.marginal ? 'Main limit: ' : 'What stops it: ';
    const said = told_by(answer, `${key}.best.stopped_by`);
    cell.append(
      element(
        'p',
        { class: 'binds' },
        binds,
        element('span', said, with_hours(best.stopped_by, zone, day)),
      ),
    );
  }
  if (task.assumed.length > 0) {
    const assumed = `Assumed, not forecast: ${task.assumed.join('; ')}`;
    cell.append(element('p', { class: 'binds' }, assumed));
  }
  const help = helps(answer, key, task, (time) => hour_on(time, zone, day));
  const count = task.not_checked.length;
  const parts = [
    ...(count > 0 ? [`${counted(count, 'limit')} not checked`] : []),
    ...(help.length > 0 ? ['what would help'] : []),
  ];
  if (parts.length > 0) {
    // Made at once: paper shows it open.
    cell.append(
      element(
        'details',
        {},
        element('summary', {}, parts.join('; ')),
        ...help,
        ...(count > 0 ? [element('p', {}, 'Not checked:')] : []),
        element('ul', {}, ...task.not_checked.map((limit) => element('li', {}, limit))),
      ),
    );
  }
  return cell;
}

/** The one limit without which the best start gains most. */
function helps(
  answer: Answer<Report>,
  key: string,
  task: ReportTask,
  hour: (time: string) => string,
): HTMLElement[] {
  const help = task.would_help?.limits[0];
  if (task.verdict === 'go' || help === undefined) return [];
  const of = `${key}.would_help.limits.0`;
  return [
    element(
      'p',
      { class: 'binds' },
      'Would help: without the limit ',
      told(answer, `${of}.without`, (text: string) => text),
      ' it is ',
      told(answer, `${of}.probability`, chance_text),
      ' at ',
      told(answer, `${of}.start`, hour),
      '.',
    ),
  ];
}
